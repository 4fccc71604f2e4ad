#include <algorithm>
#include <numbers>

#include "catalogue/shapes.h"
#include "core/error.h"
#include "scene/materials.h"
#include "tests/truth/shapes.h"
#include "truth/model.h"

namespace ink::truth {
namespace {

constexpr double kPx = 0.01;

/// A floor of two unit squares that meet at x = 0, and a wall that stands on their common edge.
scene::Mesh floor_with_fin() {
    scene::Mesh mesh;
    add_quad(mesh, {-1, 0, 1}, {0, 0, 1}, {0, 0, -1}, {-1, 0, -1});
    add_quad(mesh, {0, 0, 1}, {1, 0, 1}, {1, 0, -1}, {0, 0, -1});
    add_quad(mesh, {0, 0, 1}, {0, 1, 1}, {0, 1, -1}, {0, 0, -1});
    return mesh;
}

/// The class of what is seen of the edges of so many faces; none where nothing is.
LineClass class_of_edge(const scene::Scene& scene, const Truth& truth, std::uint32_t faces) {
    const scene::Topology topology = scene::weld(scene);
    for (const Curve& curve : truth.curves) {
        if (topology.edges[curve.edge].face_count == faces) return curve.line_class;
    }
    return LineClass::none;
}

TEST(Class, FinIsACreaseWhereTheEyeSeesIt) {
    const scene::Scene scene = scene_of({floor_with_fin()});
    const auto foot_from = [&](const glm::dvec3& eye) {
        return class_of_edge(scene, trace(scene, view_from(eye, {0, 0, 0})), 3);
    };
    EXPECT_EQ(foot_from({2, 2, 5}), LineClass::crease);
    EXPECT_EQ(foot_from({-2, 2, 5}), LineClass::crease);
    EXPECT_EQ(foot_from({2, -2, 5}), LineClass::none) << "the floor is nearer on either side";
    EXPECT_EQ(foot_from({0, 2, 5}), LineClass::none) << "edge-on it is on neither";
    const Truth edge_on = trace(scene, view_from({0, 2, 5}, {0, 0, 0}));
    EXPECT_EQ(seen_length(scene, edge_on, {0, 1, 1}, {0, 1, -1}), 0) << "nor has it a rim";
}

/// Two squares that meet along the y axis, the right one bent backwards by `deviation`.
scene::Mesh bent_sheet(double deviation_rad) {
    const auto x = static_cast<float>(std::cos(deviation_rad));
    const auto z = static_cast<float>(-std::sin(deviation_rad));
    scene::Mesh mesh;
    add_quad(mesh, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
    add_quad(mesh, {0, -1, 0}, {x, -1, z}, {x, 1, z}, {0, 1, 0});
    return mesh;
}

LineClass class_of_deviation(double deviation_deg) {
    const scene::Scene scene = scene_of({bent_sheet(deviation_deg * std::numbers::pi / 180)});
    return class_of_edge(scene, trace(scene, view_from(8)), 2);
}

TEST(Class, FortyDegreesMakeACrease) {
    EXPECT_EQ(class_of_deviation(0), LineClass::none);
    EXPECT_EQ(class_of_deviation(39.9), LineClass::none);
    EXPECT_EQ(class_of_deviation(40.1), LineClass::crease);
    EXPECT_EQ(class_of_deviation(60), LineClass::crease);
    EXPECT_EQ(class_of_deviation(89), LineClass::crease);
    EXPECT_EQ(class_of_deviation(120), LineClass::contour);
}

/// The same, the edge being marked by its file or not, and creases being those that are.
LineClass class_by_file(double deviation_deg, bool is_marked) {
    scene::Mesh sheet = bent_sheet(deviation_deg * std::numbers::pi / 180);
    // The left square's first triangle runs along the edge with its side 1.
    sheet.marked_sides = {static_cast<std::uint8_t>(is_marked ? 0b010 : 0), 0, 0, 0};
    const scene::Scene scene = scene_of({sheet});
    const TruthOptions options{.creases = scene::CreaseSource::file, .threads = 1};
    return class_of_edge(scene, trace_truth(scene, view_from(8), options), 2);
}

TEST(Class, AFilesMarksMakeACreaseOfAnyAngleAndNoContourLess) {
    EXPECT_EQ(class_by_file(5, true), LineClass::crease);
    EXPECT_EQ(class_by_file(60, true), LineClass::crease);
    EXPECT_EQ(class_by_file(5, false), LineClass::none);
    EXPECT_EQ(class_by_file(60, false), LineClass::none);
    EXPECT_EQ(class_by_file(120, false), LineClass::contour);
}

TEST(Class, AFileThatMarksNothingHasNoTruthOfItsCreases) {
    const scene::Scene scene = scene_of({bent_sheet(1)});
    TruthOptions options;
    options.creases = scene::CreaseSource::file;
    EXPECT_THROW(SceneModel(scene, options), core::Error);
}

TEST(Class, AbuttingBoxesWithLevelTopsHaveASeamAndNoCreaseThere) {
    const scene::Scene scene = scene_of({box({-1, 0, 0}, {0, 1, 1}), box({0, 0, 0}, {1, 1, 1})});
    const Truth truth = trace(scene, view_from({0.5, 3, 6}, {0, 0.5, 0.5}));
    const scene::Topology topology = scene::weld(scene);
    std::size_t seams = 0;
    for (const Curve& curve : truth.curves) {
        const scene::Edge& edge = topology.edges[curve.edge];
        const bool is_on_joint = topology.p_world[edge.a].x == 0 && topology.p_world[edge.b].x == 0;
        EXPECT_EQ(curve.line_class == LineClass::seam, is_on_joint);
        seams += is_on_joint ? 1 : 0;
    }
    EXPECT_EQ(seams, 2U) << "one on top, one in front";
}

TEST(Class, MaterialsMakeASeamOnceTheyAreObjects) {
    scene::Mesh mesh;
    add_quad(mesh, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
    add_quad(mesh, {0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0});
    mesh.materials = {0, 0, 1, 1};
    scene::Scene scene = scene_of({mesh});
    EXPECT_EQ(lengths(trace(scene, view_from(6))).count(LineClass::seam), 0U);
    scene::split_materials(scene);
    EXPECT_NEAR(lengths(trace(scene, view_from(6)))[LineClass::seam], 200, kPx);
}

/// A square whose right side meets two squares of half the height: a T-junction at (0, 0, 0). The
/// right part is turned about the joint.
std::vector<scene::Mesh> t_junction(double deviation_rad) {
    const auto x = static_cast<float>(std::cos(deviation_rad));
    const auto z = static_cast<float>(-std::sin(deviation_rad));
    scene::Mesh left, right;
    add_quad(left, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
    add_quad(right, {0, -1, 0}, {x, -1, z}, {x, 0, z}, {0, 0, 0});
    add_quad(right, {0, 0, 0}, {x, 0, z}, {x, 1, z}, {0, 1, 0});
    return {left, right};
}

double length_on_joint(const scene::Scene& scene, const Truth& truth, LineClass line_class) {
    const scene::Topology topology = scene::weld(scene);
    double sum = 0;
    for (const Curve& curve : truth.curves) {
        const scene::Edge& edge = topology.edges[curve.edge];
        const bool is_on_joint = topology.p_world[edge.a].x == 0 && topology.p_world[edge.b].x == 0;
        if (is_on_joint && curve.line_class == line_class) sum += length_px(curve);
    }
    return sum;
}

TEST(Class, FlatTJunctionIsADefectAndNoLine) {
    for (const double deviation : {0.0, 0.5}) {
        const scene::Scene scene = scene_of({joined(t_junction(deviation))});
        const Truth truth = trace(scene, view_from(6));
        EXPECT_EQ(truth.counts.defect_edges, 3U) << "one long edge and the two that meet it";
        EXPECT_EQ(length_on_joint(scene, truth, LineClass::boundary), 0) << deviation;
        EXPECT_NEAR(seen_length(scene, truth, {-1, -1, 0}, {0, -1, 0}), 100, kPx)
            << "the rim stays";
    }
}

TEST(Class, BentTJunctionIsABoundary) {
    const scene::Scene scene = scene_of({joined(t_junction(0.8))});
    const Truth truth = trace(scene, view_from(6));
    EXPECT_EQ(truth.counts.defect_edges, 0U);
    // Both sides of the crack, one on the other: 200 px each.
    EXPECT_NEAR(length_on_joint(scene, truth, LineClass::boundary), 400, 4 * kPx);
}

TEST(Class, CrackThatFoldsBeforeTheEyeIsDrawn) {
    // Bent by half a radian and seen from the side where both parts lie on the same side of the
    // joint.
    const scene::Scene scene = scene_of({joined(t_junction(0.5))});
    const double angle = 0.25;
    const Truth truth =
        trace(scene, view_from({6 * std::cos(angle), 0, -6 * std::sin(angle)}, {0, 0, 0}));
    EXPECT_GT(length_on_joint(scene, truth, LineClass::boundary), 195);
}

TEST(Class, TJunctionOfTwoObjectsIsASeam) {
    const scene::Scene scene = scene_of(t_junction(0));
    const Truth truth = trace(scene, view_from(6));
    EXPECT_EQ(length_on_joint(scene, truth, LineClass::boundary), 0);
    EXPECT_NEAR(length_on_joint(scene, truth, LineClass::seam), 400, 4 * kPx);
    EXPECT_EQ(truth.counts.defect_edges, 0U);
}

TEST(Class, CrackAlongPartOfAnEdgeIsADefectThere) {
    // The right square covers the upper half of the left one's side only.
    scene::Mesh mesh;
    add_quad(mesh, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
    add_quad(mesh, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    const scene::Scene scene = scene_of({mesh});
    const Truth truth = trace(scene, view_from(6));
    EXPECT_NEAR(seen_length(scene, truth, {0, -1, 0}, {0, 1, 0}), 100, kPx);
    EXPECT_EQ(seen_length(scene, truth, {0, 0, 0}, {0, 1, 0}), 0);
}

TEST(Class, CracksWiderThanTheToleranceAreBoundaries) {
    // The wide one by digits enough: one of a unit of the last decimal place may be none at all.
    for (const auto& [gap, expected] : {std::pair{1e-6F, 0.0}, std::pair{1.04e-4F, 400.0}}) {
        scene::Mesh mesh;
        add_quad(mesh, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
        add_quad(mesh, {gap, -1, 0}, {1, -1, 0}, {1, 1, 0}, {gap, 1, 0});
        const Truth truth = trace(scene_of({mesh}), view_from(6));
        double upright = 0;
        for (const Curve& curve : truth.curves) {
            if (std::abs(curve.begin.x_px - 320) < 1 && std::abs(curve.end.x_px - 320) < 1) {
                upright += length_px(curve);
            }
        }
        EXPECT_NEAR(upright, expected, 4 * kPx) << gap;
    }
}

TEST(Class, TorusContoursEndInside) {
    const double tilt = 0.6;
    const Truth truth = trace(scene_of({catalogue::make_torus({1, 0.45}, {96, 48})}),
                              view_from({0, 6 * std::sin(tilt), 6 * std::cos(tilt)}, {0, 0, 0}));
    EXPECT_EQ(lengths(truth).size(), 1U) << "no crease, no boundary";
    // A point where one visible piece ends and no other begins: near a cusp of the hole's contour
    // (a polyhedron's zigzags there), or at the T where the hole's far rim passes behind the near
    // one.
    std::size_t left = 0, right = 0;
    for (const Curve& curve : truth.curves) {
        for (const CurvePoint& p : {curve.begin, curve.end}) {
            const auto is_at_p = [&](const CurvePoint& o) {
                return std::hypot(o.x_px - p.x_px, o.y_px - p.y_px) < 1e-3;
            };
            const auto ends =
                std::count_if(truth.curves.begin(), truth.curves.end(), [&](const Curve& other) {
                    return is_at_p(other.begin) || is_at_p(other.end);
                });
            if (ends > 1) continue;
            ++(p.x_px < 320 ? left : right);
            EXPECT_LT(std::hypot(p.x_px - 320, p.y_px - 240), 75) << "the outer contour is closed";
        }
    }
    EXPECT_GE(left, 2U);
    EXPECT_EQ(left, right) << "the image is symmetric";
}

}  // namespace
}  // namespace ink::truth
