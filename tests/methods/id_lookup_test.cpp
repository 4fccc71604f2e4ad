#include "methods/id_lookup/id_lookup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "catalogue/shapes.h"
#include "scene/topology.h"
#include "tests/core/error_text.h"
#include "tests/methods/small_scenes.h"
#include "truth/truth.h"

namespace ink::methods {
namespace {

core::Image<LineKind> classes_of(const scene::Scene& scene,
                                 const scene::View& view,
                                 const LookupParams& params = {}) {
    IdLookup method(params);
    method.prepare(scene);
    method.pose(scene);
    return method.classes({view, 1});
}

/// Boxes of two objects in front of each other, through each other and side by side.
scene::Scene boxes() {
    scene::Scene scene = scene_of({cube_mesh(), cube_mesh(), cube_mesh(), cube_mesh()});
    const std::array<glm::dvec3, 4> at = {
        glm::dvec3{0, 0, 0}, {2, 0, 0}, {-1.3, 0.4, 1.1}, {0.5, 0.3, 4}};
    for (std::size_t i = 0; i < at.size(); ++i)
        scene.instances[i].world_from_object = glm::translate(glm::dmat4(1), at[i]);
    return scene;
}

TEST(IdLookup, DrawsNothingInsideASmoothSphereOfAnySize) {
    // Triangles of many pixels, of one, and far below one.
    const scene::Scene scene = scene_of({catalogue::make_icosphere(1, 5)});
    for (const double distance : {2.5, 12.0, 60.0}) {
        for (const glm::dvec3 direction : {glm::dvec3{1, 0.3, 0.2}, {0.1, 0.2, 1}}) {
            const scene::View view = view_from(scene, distance * direction, {0, 0, 0}, {310, 230});
            // The border against the sky, and no line but that.
            EXPECT_EQ(drawn("id_lookup", {}, scene, {view, 1}),
                      drawn("ids", {{"of", "object"}, {"samples", "corner"}}, scene, {view, 1}))
                << distance;
        }
    }
}

TEST(IdLookup, DrawsTheEdgesOfACubeAndNoDiagonal) {
    const scene::Scene scene = scene_of({cube_mesh()});
    for (const glm::dvec3 eye : {glm::dvec3{3, 4, 6}, {0.2, 5, 0.7}, {-4, -3, 2}}) {
        const scene::View view = view_from(scene, eye, {0, 0, 0}, {301, 200});
        EXPECT_EQ(drawn("id_lookup", {}, scene, {view, 1}),
                  drawn("ids", {{"samples", "corner"}}, scene, {view, 1}));
    }
}

/// How many pixels of a class the truth has, and how many have one of the method beside or on them.
struct Agreement {
    int truth_px = 0;
    int same_px = 0;
};

std::array<Agreement, 6> compare(const core::Image<std::uint8_t>& labels,
                                 const core::Image<LineKind>& kinds) {
    std::array<Agreement, 6> result;
    for (int y = 1; y + 1 < labels.height_px(); ++y) {
        for (int x = 1; x + 1 < labels.width_px(); ++x) {
            const std::uint8_t label = labels.at(x, y);
            if (label == 0 || label > 5) continue;
            bool is_there = false;
            for (int i = 0; i < 9; ++i)
                is_there |= static_cast<int>(kinds.at(x - 1 + i % 3, y - 1 + i / 3)) == label;
            ++result[label].truth_px;
            result[label].same_px += is_there;
        }
    }
    return result;
}

TEST(IdLookup, ClassesAreThoseOfTheTruth) {
    const scene::Scene scene = boxes();
    for (const buffers::Samples samples : {buffers::Samples::corner, buffers::Samples::centre}) {
        for (const glm::dvec3 eye : {glm::dvec3{5, 6, 12}, {-7, 4, 9}, {9, 3, -8}}) {
            const scene::View view = view_from(scene, eye, {0, 0, 0.5}, {400, 300});
            const truth::Truth truth = truth::trace_truth(scene, view, {});
            LookupParams params;
            params.samples = samples;
            const auto found = compare(truth.labels, classes_of(scene, view, params));
            for (const LineKind kind : {LineKind::contour, LineKind::crease}) {
                const Agreement& of = found[static_cast<std::size_t>(kind)];
                EXPECT_GT(of.truth_px, 200);
                EXPECT_GE(of.same_px, 0.99 * of.truth_px) << static_cast<int>(kind);
            }
            for (const LineKind kind : {LineKind::intersection, LineKind::seam}) {
                const Agreement& of = found[static_cast<std::size_t>(kind)];
                EXPECT_GE(of.same_px, 0.95 * of.truth_px) << static_cast<int>(kind);
            }
        }
    }
}

/// Expects that pixels of one class in the truth of a view have it beside or on them here.
void expect_found(LineKind kind, const scene::Scene& scene, const scene::View& view) {
    const truth::Truth truth = truth::trace_truth(scene, view, {});
    const Agreement of =
        compare(truth.labels, classes_of(scene, view))[static_cast<std::size_t>(kind)];
    EXPECT_GT(of.truth_px, 100);
    EXPECT_GE(of.same_px, 0.98 * of.truth_px);
}

TEST(IdLookup, AnObjectThatEndsOnAnotherInItsPlaneHasASeam) {
    scene::Scene scene = scene_of({floor_mesh(1), floor_mesh(1)});
    scene.instances[1].world_from_object = glm::translate(glm::dmat4(1), {1.8, 0, 0});
    expect_found(LineKind::seam, scene, view_from(scene, {0.9, 3, 0.1}, {0.9, 0, 0}, {300, 200}));
}

TEST(IdLookup, AFinThinnerThanAPixelIsFoundFromBothSides) {
    // It rises a little over one of two triangles of a floor, from the edge between them.
    scene::Mesh mesh;
    mesh.positions = {{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0.001F, 0.0005F, 0}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 1, 4}};
    const scene::Scene scene = scene_of({mesh});
    scene::View inside = view_from(scene, {0.1, 3, 0.2}, {0, 0, 0}, {300, 200});
    inside.camera.fov_y_rad = 0.3;  // no border of the floor in view
    expect_found(LineKind::boundary, scene, inside);
}

TEST(IdLookup, HairlineCracksAreClosed) {
    // A floor of two halves that lie a hair apart, and of a row of tiles in brick bond.
    scene::Mesh mesh;
    const auto quad = [&](float x0, float x1, float z0, float z1) {
        scene::add_quad(mesh, {x0, 0, z0}, {0, 0, z1 - z0}, {x1 - x0, 0, 0});
    };
    quad(-1, 0, -1, 0);
    quad(1e-5F, 1, -1, 0);
    quad(-1, 0.4F, 1e-6F, 1);
    quad(0.4F, 1, 1e-6F, 1);
    const scene::Scene scene = scene_of({mesh});
    const scene::View view = view_from(scene, {0.3, 2, 0.5}, {0, 0, 0}, {300, 200});
    scene::View inside = view;
    inside.camera.fov_y_rad = 0.3;  // no border of the floor in view
    const auto image = drawn("id_lookup", {}, scene, {inside, 1});
    // The rasterizer's own sparkles in a T-junction are left: single samples of sky, 2 x 2 px each.
    EXPECT_LE(std::count(image.data(), image.data() + image.size(), 255), 8);
}

TEST(IdLookup, TwoSheetsOfOneObjectBackToBackAreSilent) {
    // A seat of straw: a fan seen from above and another from below, in one plane and within one
    // rim, from which a wall goes down. Which sheet is seen, rounding decides row by row.
    constexpr std::uint32_t kRim = 24;
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i < 2 * kRim; ++i) {
        const double turn = 2 * std::numbers::pi * (i % kRim) / kRim;
        mesh.positions.emplace_back(
            static_cast<float>(std::cos(turn)), i < kRim ? 0.37F : 0.0F, std::sin(turn));
    }
    for (std::uint32_t i = 1; i + 1 < kRim; ++i) {
        mesh.triangles.push_back({0, i + 1, i});
        const auto from = [](std::uint32_t j) { return (j + kRim / 3) % kRim; };
        mesh.triangles.push_back({from(0), from(i), from(i + 1)});
    }
    for (std::uint32_t i = 0; i < kRim; ++i) {
        const std::uint32_t next = (i + 1) % kRim;
        mesh.triangles.push_back({i, next, kRim + next});
        mesh.triangles.push_back({i, kRim + next, kRim + i});
    }
    const scene::Scene scene = scene_of({mesh});
    for (int i = 0; i < 120; ++i) {
        const double turn = 0.37 * i;
        const glm::dvec3 eye{3 * std::cos(turn), 0.6 + 0.01 * i, 3 * std::sin(turn)};
        const scene::View view = view_from(scene, eye, {0, 0.2, 0}, {320, 180});
        const core::Image<LineKind> kinds = classes_of(scene, view);
        const auto* const end = kinds.data() + kinds.size();
        EXPECT_EQ(std::count(kinds.data(), end, LineKind::intersection), 0) << i;
    }
}

/// Three walls that meet at an edge, as an open book has, and a floor that coincides with another.
scene::Scene walls_at_an_edge() {
    scene::Mesh mesh;
    for (const glm::vec2 xz : {glm::vec2{0, 0}, {1, 0}, {-1, 0.6F}, {-1, -0.8F}})
        mesh.positions.insert(mesh.positions.end(), {{xz.x, -1, xz.y}, {xz.x, 1, xz.y}});
    for (const std::uint32_t to : {2U, 4U, 6U})
        mesh.triangles.insert(mesh.triangles.end(), {{0, to, 1}, {1, to, to + 1}});
    scene::Scene scene = scene_of({mesh, floor_mesh(1), floor_mesh(0.7F)});
    for (const std::size_t floor : {1U, 2U})
        scene.instances[floor].world_from_object = glm::translate(glm::dmat4(1), {0, -1.2, 0});
    return scene;
}

TEST(IdLookup, DrawsWhereAWalkInFullFindsAClass) {
    // A frame looks at half of the sides in whole numbers and leaves others out; classes are made
    // of walks in full alone.
    for (const scene::Scene& scene : {boxes(),
                                      cube_on_floor(),
                                      walls_at_an_edge(),
                                      scene_of({catalogue::make_icosphere(1, 4)}),
                                      scene_of({catalogue::make_torus({1, 0.4}, {70, 30})})}) {
        for (const buffers::Samples samples :
             {buffers::Samples::corner, buffers::Samples::centre}) {
            for (const glm::dvec3 eye :
                 {glm::dvec3{5, 6, 12}, {0.3, 0.1, 1.6}, {-1.2, 0.9, 0.2}, {30, 2, -40}}) {
                const scene::View view = view_from(scene, eye, {0, 0, 0.1}, {210, 140});
                LookupParams params;
                params.samples = samples;
                const auto kinds = classes_of(scene, view, params);
                const auto image =
                    drawn("id_lookup",
                          {{"samples", samples == buffers::Samples::corner ? "corner" : "centre"}},
                          scene,
                          {view, 1});
                for (std::size_t i = 0; i < image.size(); ++i)
                    ASSERT_EQ(image.data()[i] != 0, kinds.data()[i] != LineKind::none) << i;
            }
        }
    }
}

/// In how many pixels two images differ.
std::ptrdiff_t difference_px(const edge::EdgeImage& one, const edge::EdgeImage& other) {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        count += one.data()[i] != other.data()[i];
    return count;
}

TEST(SurfaceLookup, DrawsWhatIdLookupDraws) {
    for (const scene::Scene& scene : {boxes(),
                                      cube_on_floor(),
                                      scene_of({catalogue::make_icosphere(1, 4)}),
                                      scene_of({catalogue::make_torus({1, 0.4}, {70, 30})})}) {
        for (const glm::dvec3 eye : {glm::dvec3{5, 6, 12}, {-3.2, 1.9, 4}, {3, 0.5, -4}}) {
            const scene::View view = view_from(scene, eye, {0, 0, 0.1}, {310, 240});
            const auto exact = drawn("id_lookup", {}, scene, {view, 1});
            const auto coded = drawn("surface_lookup", {}, scene, {view, 1});
            const auto lines = std::count(exact.data(), exact.data() + exact.size(), 255);
            EXPECT_GT(lines, 100);
            EXPECT_LE(difference_px(exact, coded), lines / 100);
        }
    }
}

TEST(SurfaceLookup, FlagsFollowThePose) {
    // Two walls that become one: what was a boundary between them is no line any more.
    scene::Scene apart = scene_of({floor_mesh(1), floor_mesh(1)});
    scene::Scene together = apart;
    apart.instances[1].world_from_object = glm::translate(glm::dmat4(1), {2.5, 0, 0});
    together.instances[1].world_from_object = glm::translate(glm::dmat4(1), {2, 0.5, 0});
    const scene::View view = view_from(apart, {1, 3, 4}, {1, 0, 0}, {310, 240});
    for (const char* name : {"surface_lookup", "id_lookup"}) {
        const auto method = find_method(name).make({});
        method->prepare(apart);
        for (const scene::Scene& scene : {together, apart, together}) {
            method->pose(scene);
            EXPECT_EQ(image_by(*method, {view, 1}), drawn(name, {}, scene, {view, 1})) << name;
        }
    }
}

TEST(SurfaceLookup, RefusesMoreFacesThanAWordNames) {
    EXPECT_NO_THROW(LookupWord::require_room("strokes", LookupWord::kFaceOfCoded - 1));
    EXPECT_EQ(
        core::error_text([] { LookupWord::require_room("strokes", LookupWord::kFaceOfCoded); }),
        "strokes: 8388607 triangles (accepted: less than 8388607)");
}

}  // namespace
}  // namespace ink::methods
