// What a parallel camera sees: closed forms, laws, and the limit of a pinhole that goes away.

#include <numbers>
#include <optional>

#include "catalogue/shapes.h"
#include "scene/predicates.h"
#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

constexpr double kHeight_world = 8;
constexpr double kPxPerUnit = kHeight_px / kHeight_world;
constexpr double kPx = 0.01;  ///< every expected length holds to this

/// Looks at the origin from `outward_world`.
scene::View parallel_view(const glm::dvec3& outward_world) {
    scene::View view = view_from(1);
    view.camera = scene::look_at(
        20.0 * glm::normalize(outward_world), glm::dvec3(0), {0, 1, 0}, view.camera.fov_y_rad);
    view.camera.near = 1;
    view.camera.far = 40;
    view.camera.height_world = kHeight_world;
    return view;
}

/// Where a parallel view sees a point, from the middle of the image, y up, in world units.
glm::dvec2 seen_at(const scene::View& view, const glm::dvec3& p_world) {
    return view.camera.view_from_world * p_world;
}
glm::dvec2 seen_at(const CurvePoint& p) {
    return glm::dvec2(p.x_px - kWidth_px / 2.0, kHeight_px / 2.0 - p.y_px) / kPxPerUnit;
}

/// A prism of `sides` about the y axis.
scene::Mesh prism(int sides, double radius, float half_height) {
    scene::Mesh mesh = catalogue::make_cylinder(radius, 2 * half_height, sides);
    for (glm::vec3& p : mesh.positions)
        p.y -= half_height;
    return mesh;
}

TEST(Parallel, ACubeAlongItsDiagonalIsAHexagonAndThree) {
    const Truth truth = trace(turned_cube(glm::dmat4(1)), parallel_view({1, 1, 1}));
    const double side_px = 2 * std::sqrt(2.0 / 3) * kPxPerUnit;
    ASSERT_EQ(truth.curves.size(), 9U);
    for (const Curve& curve : truth.curves)
        EXPECT_NEAR(length_px(curve), side_px, kPx);
    EXPECT_NEAR(lengths(truth).at(LineClass::contour), 6 * side_px, 6 * kPx);
    EXPECT_NEAR(lengths(truth).at(LineClass::crease), 3 * side_px, 3 * kPx);
    for (const Curve& curve : truth.curves) {
        const double near_middle =
            std::min(glm::length(seen_at(curve.begin)), glm::length(seen_at(curve.end)));
        if (curve.line_class == LineClass::crease) {
            EXPECT_NEAR(near_middle, 0, 1e-6) << "all three meet in the middle";
        }
    }
}

// A convex body shows an edge in full if one of its faces does; it is a contour if just one does.
TEST(Parallel, APrismShowsTheEdgesOfItsFrontFaces) {
    const scene::Scene scene = scene_of({prism(6, 1.5, 1)});
    for (const glm::dvec3 outward : {glm::dvec3{0.3, 0.4, 1}, {-1, 0.2, 0.1}, {0.1, 2, 0.3}}) {
        const scene::View view = parallel_view(outward);
        const Truth truth = trace(scene, view);
        const scene::Topology topology = scene::weld(scene);
        std::map<LineClass, double> expected;
        for (const scene::Edge& edge : topology.edges) {
            std::vector<glm::dvec3> normals;
            for (std::size_t i = 0; i < edge.face_count; ++i) {
                const auto& [a, b, c] =
                    topology.faces[topology.edge_faces[edge.first_face + i]].vertices;
                const auto& p = topology.p_world;
                normals.push_back(glm::normalize(glm::cross(p[b] - p[a], p[c] - p[a])));
            }
            ASSERT_EQ(normals.size(), 2U);
            if (glm::dot(normals[0], normals[1]) > 0.999) continue;  // of one flat face
            const bool is_front0 = glm::dot(normals[0], outward) > 0;
            const bool is_front1 = glm::dot(normals[1], outward) > 0;
            if (!is_front0 && !is_front1) continue;
            const double length = glm::length(seen_at(view, topology.p_world[edge.a]) -
                                              seen_at(view, topology.p_world[edge.b]));
            const auto line_class = is_front0 != is_front1 ? LineClass::contour : LineClass::crease;
            expected[line_class] += kPxPerUnit * length;
        }
        const auto found = lengths(truth);
        EXPECT_EQ(found.size(), expected.size());
        for (const auto& [line_class, length] : expected)
            EXPECT_NEAR(found.at(line_class), length, 10 * kPx) << name(line_class);
    }
}

// A torus is what balls along a circle sweep: the outline of their shadow is as far from the
// circle's ellipse as they are wide.
TEST(Parallel, ATorusRunsBesideItsEllipse) {
    constexpr double kRing = 2, kTube = 0.5;
    const double tilt = 0.9;
    const Truth truth = trace(scene_of({catalogue::make_torus({kRing, kTube}, {96, 48})}),
                              parallel_view({0, std::sin(tilt), std::cos(tilt)}));
    ASSERT_GT(truth.curves.size(), 150U);
    for (const Curve& curve : truth.curves) {
        EXPECT_EQ(curve.line_class, LineClass::contour);
        const glm::dvec2 p = seen_at(curve.begin);
        double nearest = 1e9;
        for (int i = 0; i < 2000; ++i) {
            const double turn = 2 * std::numbers::pi * i / 2000;
            const glm::dvec2 middle =
                kRing * glm::dvec2(std::sin(turn), std::sin(tilt) * std::cos(turn));
            nearest = std::min(nearest, glm::length(p - middle));
        }
        EXPECT_NEAR(nearest, kTube, 0.02);
    }
}

std::size_t differing_px(const Truth& a, const Truth& b) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.labels.size(); ++i)
        differing += a.labels.data()[i] != b.labels.data()[i] ? 1 : 0;
    return differing;
}

TEST(Parallel, IsWhereAPinholeGoesThatGoesAway) {
    constexpr double kFov_rad = 0.01 * std::numbers::pi / 180;
    const scene::Scene scene = crowd();
    const scene::View parallel = parallel_view({3, 4, 9});
    scene::View far = parallel;
    const double distance = kHeight_world / 2 / std::tan(kFov_rad / 2);
    far.camera.eye_world = glm::normalize(parallel.camera.eye_world) * distance;
    far.camera.fov_y_rad = kFov_rad;
    far.camera.height_world = 0;
    far.camera.near = distance - 20;
    far.camera.far = distance + 20;
    const Truth a = trace(scene, parallel), b = trace(scene, far);
    EXPECT_GT(drawn_px(a), 1000U);
    EXPECT_LT(differing_px(a, b), a.labels.size() / 1000);
    for (const auto& [line_class, length] : lengths(a))
        EXPECT_NEAR(lengths(b).at(line_class), length, 2) << name(line_class);
}

TEST(Parallel, TurnedWithTheSceneItSeesTheSame) {
    const scene::Scene scene = crowd();
    const scene::View view = parallel_view({3, 4, 9});
    const Truth still = trace(scene, view);
    for (const double angle : {0.7, 2.1, 4.0}) {
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1), angle, glm::dvec3(1, 2, -0.5));
        const scene::Turned turned(scene, view, turn);
        EXPECT_LT(differing_px(still, trace(turned.scene, turned.view)),
                  still.labels.size() / 1000);
    }
}

TEST(Parallel, NeitherOrientationNorOrderNorThreadsChangeAnything) {
    scene::Scene scene = crowd();
    const scene::View view = parallel_view({3, 4, 9});
    const Truth straight = trace(scene, view);
    expect_same_truth(straight, trace(scene, view, 2));
    for (scene::Mesh& mesh : scene.meshes) {
        std::reverse(mesh.triangles.begin(), mesh.triangles.end());
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 2)
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    const Truth mixed = trace(scene, view);
    EXPECT_EQ(straight.labels, mixed.labels);
    EXPECT_EQ(straight.sampled, mixed.sampled);
    EXPECT_EQ(straight.exact_corner, mixed.exact_corner);
}

TEST(Parallel, AMirrorKeepsAllLengths) {
    const scene::Scene scene = crowd();
    scene::Scene mirrored = scene;
    for (scene::Instance& instance : mirrored.instances)
        instance.world_from_object = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1));
    const Truth a = trace(scene, parallel_view({3, 4, 9}));
    const Truth b = trace(mirrored, parallel_view({-3, 4, 9}));
    for (const auto& [line_class, length] : lengths(a))
        EXPECT_NEAR(lengths(b).at(line_class), length, 1e-6) << name(line_class);
}

// In digits, too: of a direction whose length is not whole, and from a billion units away.
TEST(Parallel, HowFarAwayTheEyeIsChangesNoLabel) {
    const scene::Scene scene = turned_cube(glm::dmat4(1));
    for (const glm::dvec3 outward : {glm::dvec3{0, 0, 1}, {1, 2, 3}, {-1, 1, -1}}) {
        std::optional<Truth> near;
        for (const double distance : {3.0, 3e3, 1e6, 1e9}) {
            scene::View view = parallel_view(outward);
            view.camera = scene::parallel_camera(
                {.way_world = -distance * outward, .height_world = kHeight_world},
                scene::bounding_sphere(scene));
            Truth truth = trace(scene, view);
            if (!near) near = truth;
            EXPECT_EQ(near->labels, truth.labels) << distance;
            EXPECT_EQ(near->sampled, truth.sampled) << distance;
            EXPECT_EQ(near->exact_corner, truth.exact_corner) << distance;
        }
    }
}

// Of a direction that is made 1 long the digits turn faces to the eye that are exactly edge-on.
TEST(Parallel, AFaceEdgeOnIsSeenFromNeitherSide) {
    for (const glm::dvec3 way : {glm::dvec3{-8, -10, 1}, {-9, -4, -8}, {-1, -4, 8}}) {
        const glm::dvec3 other{1, 2, 3};
        const scene::Camera camera =
            scene::parallel_camera({.way_world = way, .height_world = 1}, {glm::dvec3(0), 1});
        EXPECT_EQ(scene::facing(glm::dvec3(0), way, other, camera.viewpoint()), 0);
        EXPECT_EQ(scene::facing(other, way + other, 3.0 * other - way, camera.viewpoint()), 0);
    }
}

// From where it stands nothing depends but what is cut.
TEST(Parallel, TheNearPlaneCutsAndTheWayToItDoesNotCount) {
    const scene::Scene scene = turned_cube(glm::dmat4(1));
    scene::View view = parallel_view({1, 2, 3});
    const Truth from_afar = trace(scene, view);
    view.camera.eye_world *= 0.5;
    view.camera.far = 30;
    EXPECT_EQ(from_afar.labels, trace(scene, view).labels);
    view = parallel_view({0, 0, 1});
    view.camera.near = 20;
    const Truth cut = trace(scene, view);
    EXPECT_EQ(drawn_px(cut), drawn_px(trace(scene, parallel_view({0, 0, 1}))))
        << "one looks at the back wall from inside";
}

}  // namespace
}  // namespace ink::truth
