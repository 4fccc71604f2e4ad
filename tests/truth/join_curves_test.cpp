#include "truth/join_curves.h"

#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

Curve piece(double x0, double y0, double x1, double y1, LineClass line_class = LineClass::contour) {
    return {.line_class = line_class, .begin = {x0, y0, 5}, .end = {x1, y1, 5}};
}

using Indices = std::vector<std::uint32_t>;

TEST(JoinCurves, PiecesThatMeetBecomeOneRunWhicheverWayTheyPoint) {
    // 0 and 1 point along, 2 points against: (0,0) (1,0) (2,0) (3,0).
    const std::vector<Curve> curves = {piece(1, 0, 2, 0), piece(0, 0, 1, 0), piece(3, 0, 2, 0)};
    const std::vector<Polyline> lines = join_curves(curves);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].curves, (Indices{1, 0, 2}));
    ASSERT_EQ(lines[0].points.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(lines[0].points[i].x_px, static_cast<double>(i));
}

TEST(JoinCurves, ThreeAtOneVertexStayApart) {
    const std::vector<Curve> curves = {piece(0, 0, 1, 0), piece(0, 0, 0, 1), piece(-1, -1, 0, 0)};
    EXPECT_EQ(join_curves(curves).size(), 3U);
}

TEST(JoinCurves, ClassKindDepthAndSideMustAgree) {
    const Curve first = piece(0, 0, 1, 0);
    const auto runs_with = [&](const Curve& second) {
        return join_curves(std::vector<Curve>{first, second}).size();
    };
    EXPECT_EQ(runs_with(piece(1, 0, 2, 1)), 1U);
    EXPECT_EQ(runs_with(piece(1, 0, 2, 1, LineClass::crease)), 2U);
    Curve other_kind = piece(1, 0, 2, 1);
    other_kind.kind = ContourKind::self;
    EXPECT_EQ(runs_with(other_kind), 2U);
    Curve farther = piece(1, 0, 2, 1);
    farther.begin.w = farther.end.w = 6;
    EXPECT_EQ(runs_with(farther), 2U) << "it only looks as if they met";

    std::vector<Curve> sided = {piece(0, 0, 1, 0), piece(2, 0, 1, 0)};
    sided[0].empty_side = 1;
    sided[1].empty_side = -1;  // it points the other way: the same hand as one walks
    ASSERT_EQ(join_curves(sided).size(), 1U);
    EXPECT_EQ(join_curves(sided)[0].empty_side, 1);
    sided[1].empty_side = 1;
    EXPECT_EQ(join_curves(sided).size(), 2U);
}

TEST(JoinCurves, ARingClosesWithItsFirstPointAgain) {
    const std::vector<Curve> curves = {
        piece(0, 0, 1, 0), piece(1, 0, 1, 1), piece(0, 1, 1, 1), piece(0, 1, 0, 0)};
    const std::vector<Polyline> lines = join_curves(curves);
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_EQ(lines[0].points.size(), 5U);
    EXPECT_EQ(lines[0].points[0].x_px, lines[0].points[4].x_px);
    EXPECT_EQ(lines[0].points[0].y_px, lines[0].points[4].y_px);
    Indices sorted = lines[0].curves;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, (Indices{0, 1, 2, 3}));
}

TEST(JoinCurves, TheOutlineOfACubeIsOneRingAndItsCreasesAreThree) {
    scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1})});
    const glm::dmat4 tilt = glm::rotate(glm::dmat4(1), 0.6, glm::dvec3(1, 0, 0));
    scene.instances[0].world_from_object = glm::rotate(tilt, -0.7, glm::dvec3(0, 1, 0));
    const Truth truth = trace(scene, view_from(6));
    const std::vector<Polyline> lines = join_curves(truth.curves);
    ASSERT_EQ(lines.size(), 4U);
    std::size_t rings = 0;
    for (const Polyline& line : lines) {
        if (line.line_class == LineClass::crease) {
            EXPECT_EQ(line.curves.size(), 1U);
            continue;
        }
        ++rings;
        EXPECT_EQ(line.curves.size(), 6U);
        EXPECT_EQ(line.points.size(), 7U);
    }
    EXPECT_EQ(rings, 1U);
}

}  // namespace
}  // namespace ink::truth
