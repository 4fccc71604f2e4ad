#include "truth/curve_facts.h"

#include <limits>

#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

scene::Mesh upright_quad(float x, float y, float z, bool is_front = true) {
    if (!is_front) y = -y;
    return quad({-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z});
}

/// Whether the inside of an outline round the middle of the image lies to the right of a piece,
/// going from begin to end with y down.
bool has_middle_right(const Curve& curve) {
    const double dx = curve.end.x_px - curve.begin.x_px, dy = curve.end.y_px - curve.begin.y_px;
    const double to_x = kWidth_px / 2.0 - curve.begin.x_px;
    const double to_y = kHeight_px / 2.0 - curve.begin.y_px;
    return dx * to_y - dy * to_x > 0;
}

TEST(CurveFacts, QuadBeforeTheSkyHasAnInfiniteGapAndOneFace) {
    for (const bool is_front : {true, false}) {
        const Truth truth = trace(scene_of({upright_quad(1, 0.5F, 0, is_front)}), view_from(4));
        ASSERT_EQ(truth.curves.size(), 4U);
        for (const Curve& curve : truth.curves) {
            EXPECT_EQ(curve.line_class, LineClass::boundary);
            EXPECT_EQ(curve.gap, kInfinity);
            EXPECT_LT(curve.face0, 2U);
            EXPECT_EQ(curve.face1, kNoTriangle);
            EXPECT_EQ(curve.empty_side, has_middle_right(curve) ? -1 : 1);
        }
    }
}

TEST(CurveFacts, GapBeforeASlantedWallIsTakenAlongTheViewDirection) {
    // The wall is the plane z = -3 - x / 2, seen from (0, 0, 4). The line of sight through (x, y,
    // 0) goes on as (x, y, 0) (1 + t) - (0, 0, 4 t): it meets the wall where 4 t = 3 + x (1 + t)
    // / 2.
    const scene::Mesh wall = quad({-4, -50, -1}, {50, -50, -28}, {50, 50, -28}, {-4, 50, -1});
    const Truth truth = trace(scene_of({upright_quad(0.8F, 0.5F, 0), wall}), view_from(4));
    int upright = 0;
    for (const Curve& curve : truth.curves) {
        if (std::abs(curve.begin.w - 4) > 1e-6) continue;  // the wall's own rim
        if (std::abs(curve.begin.x_px - curve.end.x_px) > 1e-6) continue;
        const double x = (curve.begin.x_px - kWidth_px / 2.0) / (kFocal_px / 4);
        const double t = (3 + x / 2) / (4 - x / 2);
        EXPECT_NEAR(curve.gap, 4 * t, 1e-5);
        ++upright;
    }
    EXPECT_EQ(upright, 2);
}

TEST(CurveFacts, BoxBeforeAWallHasItsGapFromTheFrontFace) {
    // Seen face-on, the front face's rim at z = 1 is the contour; the wall stands at -3. The own
    // side faces do not count as what lies behind.
    const scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1}), upright_quad(50, 50, -3)});
    const Truth truth = trace(scene, view_from(6));
    ASSERT_EQ(truth.curves.size(), 4U);
    const scene::Topology topology = scene::weld(scene);
    for (const Curve& curve : truth.curves) {
        EXPECT_EQ(curve.kind, ContourKind::other_object);
        EXPECT_NEAR(curve.gap, 4, 1e-6);
        // The first two triangles are the front face: it is seen, the side face is not.
        EXPECT_LT(topology.faces[curve.face0].triangle, 2U);
        EXPECT_GE(topology.faces[curve.face1].triangle, 2U);
        EXPECT_LT(topology.faces[curve.face1].triangle, 12U);
        EXPECT_EQ(curve.empty_side, has_middle_right(curve) ? -1 : 1);
        // The middle of a side of the front face is 1 off the axis and 5 away.
        EXPECT_NEAR(curve.view_angle_rad, std::atan2(1.0, 5.0), 1e-6);
    }
}

TEST(CurveFacts, BoxOnAFloorTouchesItWithoutAGap) {
    const scene::Mesh floor = quad({-50, -1, 50}, {50, -1, 50}, {50, -1, -50}, {-50, -1, -50});
    const scene::Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1}), floor});
    const Truth truth = trace(scene, view_from({0, 1, 8}, {0, 0, 0}));
    int standing = 0;
    for (const Curve& curve : truth.curves) {
        if (curve.line_class != LineClass::contour) continue;
        // The lower rim of the front face: both ends at z = 1 and y = -1, 2 px * 600 / 7.3 apart.
        const bool is_low =
            curve.begin.y_px > 300 && std::abs(curve.begin.y_px - curve.end.y_px) < 1;
        if (!is_low) continue;
        EXPECT_NEAR(curve.gap, 0, 1e-9);
        ++standing;
    }
    EXPECT_EQ(standing, 1);
}

TEST(CurveFacts, TurnedCubeHasTheAnglesOfItsFaces) {
    // Turned by half a radian about the vertical: the front face's normal is (-sin, 0, cos) of it,
    // the right face's (cos, 0, sin).
    const double turn = -0.5;
    const scene::Scene scene = turned_cube(glm::rotate(glm::dmat4(1), turn, glm::dvec3(0, 1, 0)));
    const Truth truth = trace(scene, view_from(6));
    const auto turned = [&](double x, double z) {
        return glm::dvec3(
            x * std::cos(turn) + z * std::sin(turn), 0, -x * std::sin(turn) + z * std::cos(turn));
    };
    const auto angle = [](const glm::dvec3& normal, const glm::dvec3& p) {
        const glm::dvec3 to_point = p - glm::dvec3(0, 0, 6);
        return std::acos(std::abs(glm::dot(normal, to_point)) / glm::length(to_point));
    };
    const glm::dvec3 front = turned(0, 1), right = turned(1, 0);
    int creases = 0, upright = 0;
    for (const Curve& curve : truth.curves) {
        if (std::abs(curve.begin.x_px - curve.end.x_px) > 1e-6) continue;
        // The middles of upright edges lie at the height of the eye.
        if (curve.line_class == LineClass::crease) {
            const glm::dvec3 p = turned(1, 1);
            EXPECT_NEAR(curve.view_angle_rad, std::max(angle(front, p), angle(right, p)), 1e-6);
            EXPECT_EQ(curve.gap, 0);
            EXPECT_EQ(curve.empty_side, 0);
            EXPECT_NE(curve.face0, kNoTriangle);
            EXPECT_NE(curve.face1, kNoTriangle);
            ++creases;
            continue;
        }
        const bool is_left = curve.begin.x_px < kWidth_px / 2.0;
        const glm::dvec3 p = is_left ? turned(-1, 1) : turned(1, -1);
        EXPECT_NEAR(curve.view_angle_rad, angle(is_left ? front : right, p), 1e-6);
        EXPECT_EQ(curve.empty_side, has_middle_right(curve) ? -1 : 1);
        EXPECT_EQ(curve.gap, kInfinity);
        ++upright;
    }
    EXPECT_EQ(creases, 1);
    EXPECT_EQ(upright, 2);
}

TEST(CurveFacts, FacesOfACreaseAreLeftAndRightOfIt) {
    for (const double turn : {-0.5, 0.5}) {
        const scene::Scene scene =
            turned_cube(glm::rotate(glm::dmat4(1), turn, glm::dvec3(0, 1, 0)));
        const Truth truth = trace(scene, view_from(6));
        const scene::Topology topology = scene::weld(scene);
        int creases = 0;
        for (const Curve& curve : truth.curves) {
            if (curve.line_class != LineClass::crease) continue;
            const auto middle_x = [&](std::uint32_t f) {
                double sum = 0;
                for (const std::uint32_t v : topology.faces[f].vertices)
                    sum += project(topology.p_world[v], 6).x / 3;
                return sum;
            };
            // Going up the image (y falls), left on the image is left.
            const bool goes_up = curve.end.y_px < curve.begin.y_px;
            EXPECT_EQ(middle_x(curve.face0) < middle_x(curve.face1), goes_up);
            ++creases;
        }
        EXPECT_EQ(creases, 1);
    }
}

TEST(CurveFacts, SeamWithoutSharedVerticesHasTheFaceThatGoesOn) {
    // A tall tile beside two short ones: the tall one's side is a T-junction with both.
    scene::Mesh left, right;
    add_quad(left, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
    add_quad(right, {0, -1, 0}, {1, -1, 0}, {1, 0, 0}, {0, 0, 0});
    add_quad(right, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    const scene::Scene scene = scene_of({left, right});
    const Truth truth = trace(scene, view_from(4));
    const scene::Topology topology = scene::weld(scene);
    std::size_t seams = 0;
    for (const Curve& curve : truth.curves) {
        if (curve.line_class != LineClass::seam) continue;
        ASSERT_LT(curve.face0, topology.faces.size());
        ASSERT_LT(curve.face1, topology.faces.size());
        EXPECT_NE(topology.faces[curve.face0].object, topology.faces[curve.face1].object);
        EXPECT_EQ(curve.gap, 0);
        ++seams;
    }
    EXPECT_GE(seams, 1U);
}

}  // namespace
}  // namespace ink::truth
