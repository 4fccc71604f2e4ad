
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "catalogue/catalogue.h"
#include "catalogue/shapes.h"
#include "import/import.h"
#include "methods/edge_hash/soup_models.h"
#include "tests/models/fetched_model.h"
#include "tests/scene/small_meshes.h"

namespace ink::methods {
namespace {

SoupEdges found(const scene::Mesh& mesh, double epsilon = 0) {
    const std::vector<glm::dvec3> points(mesh.positions.begin(), mesh.positions.end());
    return find_edges({points, mesh.triangles}, epsilon);
}

/// Edges of one face.
std::ptrdiff_t boundary(const SoupEdges& soup) {
    return std::ranges::count(soup.edges, 1U, &SoupEdge::count);
}

TEST(SoupEdges, ClosedFormsComeTogetherFromLooseTriangles) {
    const SoupEdges cube = found(scene::exploded(scene::unit_cube()));
    EXPECT_EQ(cube.vertex_of.size(), 8U);
    EXPECT_EQ(cube.edges.size(), 18U);
    const SoupEdges ball = found(scene::exploded(catalogue::make_icosphere(1, 2)));
    EXPECT_EQ(ball.vertex_of.size(), 10U * 16 + 2);
    EXPECT_EQ(ball.edges.size(), 30U * 16);
    for (const SoupEdges* soup : {&cube, &ball})
        EXPECT_TRUE(std::ranges::all_of(soup->edges, [](const auto& e) { return e.count == 2; }));
}

TEST(SoupEdges, EachFaceStandsAtItsEdgesWithTheWayItRuns) {
    const SoupEdges soup = found(scene::unit_cube());
    for (const SoupEdge& edge : soup.edges) {
        ASSERT_EQ(edge.count, 2U);
        const auto faces = soup.faces_of(edge);
        EXPECT_EQ(faces[0].direction + faces[1].direction, 0);  // consistently oriented
        for (const EdgeFace& face : faces) {
            const scene::Triangle& corners = soup.faces[face.face];
            for (std::size_t i = 0; i < 3; ++i) {
                if (corners[i] != face.opposite) continue;
                const bool runs_forward = corners[(i + 1) % 3] == edge.a;
                EXPECT_EQ(corners[runs_forward ? (i + 2) % 3 : (i + 1) % 3], edge.b);
                EXPECT_EQ(face.direction, runs_forward ? 1 : -1);
            }
        }
    }
}

TEST(SoupEdges, CopesWithDoubleAndDegenerateFacesAndWithFins) {
    scene::Mesh mesh;
    mesh.positions = {{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 4}, {0, 1, 5}, {2, 2, 3}};
    const SoupEdges soup = found(mesh);
    EXPECT_EQ(soup.faces.size(), 3U);  // one is there twice, two have no area
    EXPECT_EQ(soup.edges.size(), 7U);
    EXPECT_EQ(boundary(soup), 6);
    EXPECT_EQ(soup.edges[0].count, 3U);
    EXPECT_TRUE(found({}).edges.empty());
}

TEST(SoupEdges, TheToleranceClosesCracks) {
    // A torus of 64 x 32 quads, its triangles apart by millionths.
    const scene::Scene scene = catalogue::make_catalogue_scene("soup");
    const scene::Mesh& ring = scene.meshes[scene.instances[0].mesh];
    ASSERT_EQ(ring.triangles.size(), 2U * 64 * 32);
    EXPECT_GT(boundary(found(ring, 0)), 12000);  // of 12288 sides
    const SoupEdges closed = found(ring, 1e-5);
    EXPECT_EQ(closed.vertex_of.size(), 64U * 32);
    EXPECT_EQ(closed.edges.size(), 3U * 64 * 32);
    EXPECT_EQ(boundary(closed), 0);
    EXPECT_EQ(closed.faces.size(), ring.triangles.size());
}

/// Edges of one face by the file's own indices, without any weld.
std::ptrdiff_t boundary_by_index(const scene::Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces;
    for (const scene::Triangle& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i)
            ++faces[std::minmax(t[i], t[(i + 1) % 3])];
    }
    std::ptrdiff_t boundary = 0;
    for (const auto& [edge, count] : faces)
        boundary += count == 1;
    return boundary;
}

/// Boundary edges of all models of a file: as it is indexed, welded exactly, welded within an
/// epsilon, and the last again with all of its parts as one model.
std::array<std::ptrdiff_t, 4> boundary_edges(const scene::Scene& scene, double epsilon) {
    std::array<std::ptrdiff_t, 4> counts{};
    for (const scene::Mesh& mesh : scene.meshes) {
        counts[0] += boundary_by_index(mesh);
        counts[1] += boundary(found(mesh, 0));
        counts[2] += boundary(found(mesh, epsilon));
    }
    SoupModels whole({.scope = ModelScope::scene, .epsilon = epsilon});
    whole.prepare(scene);
    whole.pose(scene);
    counts[3] = std::ranges::count(
        whole.lines({glm::dvec3(0)}), buffers::EdgeKind::boundary, &buffers::KnownEdge::kind);
    return counts;
}

// Counted from the files' bytes by a few lines of Python.

TEST(SoupEdges, OfAPlayerAndOfLooseTrianglesComeToThis) {
    // 1764 triangles, split along the seams of the skin, in three parts that touch; and 1368.
    const std::pair<const char*, std::array<std::ptrdiff_t, 4>> known[] = {
        {"penguin.obj", {418, 32, 32, 32}}, {"spider.stl", {3 * 1368, 72, 72, 72}}};
    for (const auto& [file, boundary] : known) {
        const auto path = fetched_model(file);
        INK_SKIP_WITHOUT(path);
        EXPECT_EQ(boundary_edges(import::import_scene(path), 0), boundary);
    }
}

}  // namespace
}  // namespace ink::methods
