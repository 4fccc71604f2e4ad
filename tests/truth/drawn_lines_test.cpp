#include "truth/drawn_lines.h"

#include "catalogue/catalogue.h"
#include "tests/truth/shapes.h"
#include "truth/eye_view.h"
#include "truth/screen_line.h"

namespace ink::truth {
namespace {

constexpr double kJoined_px = 1e-4;  ///< ends that are joined may be 1/65536 px apart

DrawnLines drawn(const scene::Scene& scene,
                 const scene::View& view,
                 Hidden hidden = Hidden::keep,
                 int threads = 1) {
    return trace_drawn_lines(build_model(scene, {}), view, {.threads = threads}, hidden);
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

std::size_t pieces(const std::vector<Polyline>& lines, LineClass line_class) {
    std::size_t count = 0;
    for (const Polyline& line : lines)
        count += line.line_class == line_class ? line.curves.size() : 0;
    return count;
}

scene::Scene cube() {
    return scene_of({box({-1, -1, -1}, {1, 1, 1})});
}

TEST(DrawnLines, ACubeFromACornerShowsNineEdgesAndHidesThree) {
    const DrawnLines lines = drawn(cube(), view_from({5, 5, 5}, {0, 0, 0}));
    ASSERT_EQ(lines.visible.size(), 4U) << "the outline, and three creases that meet";
    EXPECT_EQ(pieces(lines.visible, LineClass::contour), 6U);
    EXPECT_EQ(pieces(lines.visible, LineClass::crease), 3U);
    ASSERT_EQ(lines.hidden.size(), 3U);
    EXPECT_EQ(pieces(lines.hidden, LineClass::crease), 3U);
}

TEST(DrawnLines, ACubeFromTheFrontHidesEightEdgesBehindItsFace) {
    const DrawnLines lines = drawn(cube(), view_from(6));
    ASSERT_EQ(lines.visible.size(), 1U);
    EXPECT_EQ(pieces(lines.visible, LineClass::contour), 4U);
    EXPECT_EQ(pieces(lines.hidden, LineClass::crease), 8U);
    // 2 units at distance 7; the edges in between run from there to the corners at distance 5.
    const double far = kFocal_px * 2 / 7, near = kFocal_px * 2 / 5;
    EXPECT_NEAR(lengths(lines.hidden)[LineClass::crease],
                4 * far + 4 * (near - far) / 2 * std::sqrt(2.0),
                1e-9);
}

TEST(DrawnLines, ABoxBehindABoxIsDashedWhereThatCoversIt) {
    const scene::Scene scene =
        scene_of({box({-1, -1, 2}, {1, 1, 2.5}), box({-2, -0.2, -1}, {2, 0.2, 0})});
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
    const scene::Scene scene =
        scene_of({box({-1, -1, -1}, {1, 1, 1}), box({-5, 0.1, -3}, {5, 5, -2.9})});
    std::size_t traced_runs = 0;
    for (const Polyline& line : join_curves(trace(scene, view_from(6)).curves))
        traced_runs += line.kind != ContourKind::sky || line.curves.size() > 1;
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
        const auto expected = lengths(trace(scene, view));
        auto found = lengths(drawn(scene, view, Hidden::leave_out).visible);
        for (const auto& [line_class, length] : expected)
            EXPECT_NEAR(found[line_class], length, kJoined_px) << name;
        EXPECT_EQ(found.size(), expected.size());
    }
}

/// The lengths of all edges' lines inside the image, seen or not.
std::map<LineClass, double> clipped_lengths(const Model& model, const scene::View& view) {
    const EyeView eye(model, view, 1);
    std::map<LineClass, double> sum;
    for (std::uint32_t e = 0; e < model.topology.edges.size(); ++e) {
        for (const ClassStretch& stretch : line_stretches(eye, e)) {
            if (const auto line = clip_to_image(eye, segment_of(eye, e), stretch))
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
        for (const auto& [line_class, length] : clipped_lengths(build_model(scene, {}), view))
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

}  // namespace
}  // namespace ink::truth
