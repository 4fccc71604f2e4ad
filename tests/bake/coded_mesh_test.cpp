#include "bake/coded_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "buffers/id_pass.h"
#include "catalogue/catalogue.h"
#include "methods/registry.h"
#include "scene/surface.h"
#include "tests/scene/small_meshes.h"

namespace ink::bake {
namespace {

/// The codes that a method draws at pixel centres, 0 where nothing is.
core::Image<std::uint16_t> drawn_codes(const char* name,
                                       const scene::Scene& scene,
                                       const scene::View& view) {
    const method::MethodInfo& info = methods::find_method(name);
    const auto method = info.make({{"samples", "centre"}});
    method->prepare(scene);
    method->pose(scene);
    return method->layers({view, 1}).front().codes.front();
}

/// Global indices of the triangles that are seen at pixel centres.
core::Image<std::uint32_t> seen_triangles(const scene::Scene& scene, const scene::View& view) {
    core::Image<std::uint32_t> image(view.width_px, view.height_px, buffers::kNoId);
    buffers::IdParams params;
    params.of = buffers::IdSource::triangle;
    buffers::IdPass pass(params, 0);
    pass.prepare(scene);
    pass.pose(scene);
    buffers::EachTile sink([&](const raster::Tile& tile) {
        for (int y = 0; !tile.is_empty && y < tile.height_px; ++y)
            std::copy_n(tile.row<std::uint32_t>(0, y),
                        tile.width_px,
                        image.row(tile.y0_px + y) + tile.x0_px);
    });
    (void)pass.draw({view, 1}, false, sink);
    return image;
}

TEST(CodedMesh, IsTheSceneWithTheCodesThatMethodsDraw) {
    for (const char* name : {"cube", "blocks", "torus", "gear", "tiles", "soup"}) {
        const auto& entries = catalogue::catalogue();
        const auto entry = std::find_if(
            entries.begin(), entries.end(), [&](const auto& each) { return each.name == name; });
        const scene::Scene scene = entry->make();
        const scene::View view{scene.cameras.front(), 320, 180};
        const CodedMesh mesh = coded_mesh(scene);
        ASSERT_EQ(mesh.triangle_count(), scene::triangle_count(scene)) << name;
        const auto surface8 = drawn_codes("surface8", scene, view);
        const auto label8 = drawn_codes("label8", scene, view);
        const auto seen = seen_triangles(scene, view);
        int compared = 0;
        for (int y = 0; y < view.height_px; ++y) {
            for (int x = 0; x < view.width_px; ++x) {
                if (seen.at(x, y) == buffers::kNoId) continue;
                for (const std::size_t corner : {0U, 2U}) {
                    const std::uint32_t vertex = mesh.indices[3 * seen.at(x, y) + corner];
                    ASSERT_EQ(mesh.surface8[vertex], surface8.at(x, y)) << name;
                    ASSERT_EQ(mesh.label8[vertex], label8.at(x, y)) << name;
                }
                ++compared;
            }
        }
        EXPECT_GT(compared, 2000) << name;
    }
}

TEST(CodedMesh, HasItsVerticesInAPose) {
    scene::Scene scene = scene::scene_of({scene::unit_cube()});
    const CodedMesh mesh = coded_mesh(scene);
    scene.instances[0].world_from_object =
        glm::dmat4(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1);
    const MovingVertices posed = posed_vertices(mesh, scene);
    ASSERT_EQ(posed.p_world.size(), mesh.vertex_count());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const glm::vec3 p = mesh.p_world[v], n = mesh.n_world[v];
        EXPECT_EQ(posed.p_world[v], glm::vec3(5 - p.y, p.x, p.z));
        EXPECT_NEAR(glm::dot(posed.n_world[v], glm::vec3(-n.y, n.x, n.z)), 1, 1e-6);
    }
}

TEST(CodedMesh, KeepsTrianglesTheirWindingAndUnitNormals) {
    const scene::Scene scene = scene::scene_of({scene::unit_cube()});
    const CodedMesh mesh = coded_mesh(scene);
    const scene::Surface surface = scene::flatten(scene);
    ASSERT_EQ(mesh.triangle_count(), 12U);
    EXPECT_EQ(mesh.vertex_count(), 24U + mesh.added_count);  // four corners a side
    for (std::size_t t = 0; t < 12; ++t) {
        std::array<glm::vec3, 3> before{};
        std::array<glm::vec3, 3> after{};
        for (std::size_t i = 0; i < 3; ++i) {
            before[i] = surface.p_world[surface.triangles[t][i]];
            after[i] = mesh.p_world[mesh.indices[3 * t + i]];
        }
        bool is_rotated = false;
        for (int turn = 0; turn < 3; ++turn) {
            is_rotated |= before == after;
            std::rotate(after.begin(), after.begin() + 1, after.end());
        }
        EXPECT_TRUE(is_rotated) << t;
    }
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_NEAR(glm::length(mesh.n_world[v]), 1, 1e-6);
        // Over all three sides at a corner: along the diagonal of the cube.
        EXPECT_NEAR(glm::dot(glm::normalize(mesh.p_world[v]), mesh.hull_n_world[v]), 1, 1e-5);
    }
}

TEST(CodedMesh, FacesOfTheLookupKnowTheirNeighboursAndCodes) {
    const CodedMesh mesh = coded_mesh(scene::scene_of({scene::unit_cube()}));
    ASSERT_EQ(mesh.lookup.faces.size(), 12U);
    EXPECT_EQ(mesh.lookup.p_world.size(), 8U);
    for (std::uint32_t f = 0; f < 12; ++f) {
        const methods::LookupTable::Face& face = mesh.lookup.faces[f];
        int crease_count = 0;
        for (unsigned i = 0; i < 3; ++i) {
            const methods::Twin twin{face.twins[i]};
            const methods::LookupTable::Face& next = mesh.lookup.faces.at(twin.face());
            EXPECT_EQ(methods::Twin{next.twins.at(twin.edge())}.face(), f);
            const auto kind = static_cast<methods::LineKind>(face.rest >> 3 * i & 7U);
            crease_count += kind == methods::LineKind::crease ? 1 : 0;
            EXPECT_EQ(face.patch == next.patch, kind == methods::LineKind::none);
        }
        EXPECT_EQ(crease_count, 2) << f;  // the third edge is the diagonal of a side
        EXPECT_GE(face.rest >> 24U, 2U) << f;
    }
}

TEST(CodedMesh, OfNothingIsNothing) {
    const CodedMesh mesh = coded_mesh(scene::Scene{});
    EXPECT_EQ(mesh.triangle_count(), 0U);
    EXPECT_EQ(mesh.vertex_count(), 0U);
}

}  // namespace
}  // namespace ink::bake
