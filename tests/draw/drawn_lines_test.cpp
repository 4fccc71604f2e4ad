#include "draw/line_drawing.h"

#include <array>
#include <numbers>

#include "catalogue/catalogue.h"
#include "core/named.h"
#include "harness/suite/suite.h"
#include "tests/truth/shapes.h"
#include "truth/eye_view.h"
#include "truth/trace_lines.h"

namespace ink::draw {
namespace {

using truth::Hidden;
using truth::kFocal_px;
using truth::LineClass;
using truth::Polyline;
using truth::view_from;

constexpr double kJoined_px = 1e-4;  ///< ends that are joined may be 1/65536 px apart

DrawnLines drawn(const scene::Scene& scene,
                 const scene::View& view,
                 Hidden hidden = Hidden::keep,
                 int threads = 1) {
    return joined_by_class(
        trace_drawn_lines(truth::build_model(scene, {}), view, {.threads = threads}, hidden));
}

double length_px(const Polyline& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        sum += std::hypot(line.points[i].x_px - line.points[i - 1].x_px,
                          line.points[i].y_px - line.points[i - 1].y_px);
    }
    return sum;
}

std::map<LineClass, double> lengths(const std::vector<Polyline>& lines) {
    std::map<LineClass, double> sum;
    for (const Polyline& line : lines)
        sum[line.line_class] += length_px(line);
    return sum;
}

TEST(DrawnLines, ABoxBehindABoxIsDashedWhereThatCoversIt) {
    const scene::Scene scene = truth::scene_of(
        {truth::box({-1, -1, 2}, {1, 1, 2.5}), truth::box({-2, -0.2, -1}, {2, 0.2, 0})});
    const DrawnLines lines = drawn(scene, view_from(6));
    const double covered = kFocal_px * 2 / 3.5, wide = kFocal_px * 4 / 6,
                 high = kFocal_px * 0.4 / 6;
    EXPECT_NEAR(lengths(lines.visible)[LineClass::contour],
                4 * covered + 2 * (wide - covered) + 2 * high,
                4 / 512.0);
    EXPECT_NEAR(lengths(lines.hidden)[LineClass::contour], 2 * covered, 4 / 512.0);
}

TEST(DrawnLines, RunOnWhereWhatLiesBehindChanges) {
    // A wall behind the upper half of a cube.
    const scene::Scene scene = truth::scene_of(
        {truth::box({-1, -1, -1}, {1, 1, 1}), truth::box({-5, 0.1, -3}, {5, 5, -2.9})});
    std::size_t traced_runs = 0;
    for (const Polyline& line : truth::join_curves(truth::trace(scene, view_from(6)).curves))
        traced_runs += line.kind != truth::ContourKind::sky || line.curves.size() > 1;
    EXPECT_GE(traced_runs, 2U);
    std::size_t rings = 0;
    for (const Polyline& line : drawn(scene, view_from(6)).visible)
        rings += line.points.size() > 4 && line.points.front().x_px == line.points.back().x_px;
    EXPECT_EQ(rings, 1U);
}

TEST(DrawnLines, CoverWhatTheTruthTracesAndNothingElse) {
    for (const char* name : {"bracket", "crystals", "soup"}) {
        const scene::Scene scene = catalogue::make_catalogue_scene(name);
        const scene::View view{scene.cameras.front(), 320, 180};
        const auto expected = lengths(truth::trace(scene, view));
        auto found = lengths(drawn(scene, view, Hidden::leave_out).visible);
        for (const auto& [line_class, length] : expected)
            EXPECT_NEAR(found[line_class], length, kJoined_px) << name;
        EXPECT_EQ(found.size(), expected.size());
    }
}

/// The lengths of all edges' lines inside the image, seen or not.
std::map<LineClass, double> clipped_lengths(const truth::Model& model, const scene::View& view) {
    const truth::EyeView eye(model, view, 1);
    std::map<LineClass, double> sum;
    for (std::uint32_t e = 0; e < model.topology.edges.size(); ++e) {
        for (const truth::ClassStretch& stretch : truth::line_stretches(eye, e)) {
            if (const auto line = truth::clip_to_image(eye, truth::segment_of(eye, e), stretch))
                sum[stretch.line_class] += line->length_px;
        }
    }
    return sum;
}

TEST(DrawnLines, VisibleAndHiddenOnesTogetherAreAllThatIsInsideTheFrame) {
    for (const char* name : {"bracket", "room", "soup"}) {
        const scene::Scene scene = catalogue::make_catalogue_scene(name);
        scene::View view{scene.cameras.front(), 320, 180};
        view.camera.fov_y_rad /= 2;  // so that the frame cuts lines
        const DrawnLines lines = drawn(scene, view);
        auto found = lengths(lines.visible);
        for (const auto& [line_class, length] : lengths(lines.hidden))
            found[line_class] += length;
        for (const auto& [line_class, length] :
             clipped_lengths(truth::build_model(scene, {}), view))
            EXPECT_NEAR(found[line_class], length, kJoined_px)
                << name << ' ' << truth::name(line_class);
    }
}

TEST(DrawnLines, AreTheSameForEveryThreadCount) {
    const scene::Scene scene = catalogue::make_catalogue_scene("bracket");
    const scene::View view{scene.cameras.front(), 320, 180};
    const DrawnLines one = drawn(scene, view), three = drawn(scene, view, Hidden::keep, 3);
    const auto expect_same = [](const auto& a, const auto& b) {
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_EQ(a[i].curves, b[i].curves);
            EXPECT_EQ(a[i].line_class, b[i].line_class);
            EXPECT_EQ(length_px(a[i]), length_px(b[i]));
        }
    };
    EXPECT_FALSE(one.hidden.empty());
    expect_same(one.visible, three.visible);
    expect_same(one.hidden, three.hidden);
}

/// Visible and hidden lengths of a view by name, in units of the scene, each line drawn once.
std::array<double, 2> lengths_of(const scene::Mesh& mesh, const std::string& name) {
    harness::ViewRequest request;
    const auto views = scene::drawing_views();
    request.directions = {*core::find_named(views, name)};
    const auto of = harness::make_scene_views(truth::scene_of({mesh}), request);
    const scene::View& view = of.views.front();
    auto lines =
        trace_drawn_lines(truth::build_model(of.scene, {}), view, {.threads = 1}, Hidden::keep);
    remove_covered(lines, 0.1);
    const double units_per_px = view.camera.height_world / view.height_px;
    std::array<double, 2> sums{};
    for (const truth::Curve& curve : lines.curves)
        sums[0] += truth::length_px(curve) * units_per_px;
    for (const truth::Curve& curve : lines.hidden)
        sums[1] += truth::length_px(curve) * units_per_px;
    return sums;
}

void expect_lengths(const scene::Mesh& mesh,
                    const std::string& view,
                    double visible,
                    double hidden) {
    const auto found = lengths_of(mesh, view);
    EXPECT_NEAR(found[0], visible, 1e-5) << view;
    EXPECT_NEAR(found[1], hidden, 1e-5) << view;
}

const double kIso = std::sqrt(2.0 / 3);  ///< of an edge along an axis, seen from 1,1,1

TEST(DrawnOnce, ACube) {
    const scene::Mesh cube = truth::box({-1, -1, -1}, {1, 1, 1});
    for (const char* along_an_axis : {"front", "top", "left"})
        expect_lengths(cube, along_an_axis, 8, 0);
    expect_lengths(cube, "iso", 18 * kIso, 6 * kIso);
    expect_lengths(truth::box({0, 0, 0}, {1, 2, 4}), "iso", 3 * 7 * kIso, 7 * kIso);
}

TEST(DrawnOnce, AStair) {
    // Four steps of 1 by 1, going down to +x, two wide.
    const std::vector<glm::vec2> profile = {
        {0, 0}, {4, 0}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 4}, {0, 4}};
    const auto at = [](glm::vec2 p, float z) { return glm::vec3(p, z); };
    scene::Mesh stair;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const glm::vec2 a = profile[i], b = profile[(i + 1) % profile.size()];
        truth::add_quad(stair, at(a, 2), at(a, 0), at(b, 0), at(b, 2));
        if (i == 0 || i + 1 == profile.size()) continue;
        truth::add_triangle(stair, at({0, 0}, 2), at(a, 2), at(b, 2));
        truth::add_triangle(stair, at({0, 0}, 0), at(b, 0), at(a, 0));
    }
    expect_lengths(stair, "front", 16, 0);
    expect_lengths(stair, "top", 2 * (4 + 2) + 3 * 2, 0);
    expect_lengths(stair, "right", 2 * (4 + 2) + 3 * 2, 0);
    // Of 52 units of edges the two at the back along bottom and wall and the one between are
    // hidden, 10 units; of these one lies behind the edge of a riser, and one behind that of a
    // tread.
    expect_lengths(stair, "iso", 42 * kIso, 8 * kIso);
}

TEST(DrawnOnce, ATube) {
    constexpr int kSides = 32;
    constexpr float kOuter = 2, kInner = 1, kLength = 3;
    const auto at = [](int side, float radius, float z) {
        const double turn = 2 * std::numbers::pi * (side % kSides) / kSides;
        return glm::vec3(radius * std::cos(turn), radius * std::sin(turn), z);
    };
    scene::Mesh tube;
    for (int i = 0; i < kSides; ++i) {
        const auto quad = [&](float r0, float z0, float r1, float z1) {
            truth::add_quad(
                tube, at(i, r0, z0), at(i + 1, r0, z0), at(i + 1, r1, z1), at(i, r1, z1));
        };
        quad(kOuter, 0, kOuter, kLength);
        quad(kInner, kLength, kInner, 0);
        quad(kOuter, kLength, kInner, kLength);
        quad(kInner, 0, kOuter, 0);
    }
    const double rings = 2 * kSides * std::sin(std::numbers::pi / kSides) * (kOuter + kInner);
    expect_lengths(tube, "front", rings, 0);
    expect_lengths(tube, "back", rings, 0);
    expect_lengths(tube, "top", 2 * (2 * kOuter + kLength), 2 * kLength);
}

}  // namespace
}  // namespace ink::draw
