#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"

// Machined parts. A fillet meets its faces without a crease, so a part's creases can be counted.

namespace ink::catalogue {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

/// `count` steps along the quarter circle about `centre` from `from_rad` to `to_rad`, its first
/// point left out if `is_begun`.
void add_arc(std::vector<glm::dvec2>& outline,
             const glm::dvec2& centre,
             double radius,
             glm::dvec2 from_to_rad,
             int count,
             bool is_begun = false) {
    for (int i = is_begun ? 1 : 0; i <= count; ++i) {
        const double angle_rad = glm::mix(from_to_rad.x, from_to_rad.y, double(i) / count);
        outline.push_back(centre + glm::dvec2(std::cos(angle_rad), std::sin(angle_rad)) * radius);
    }
}

/// A rectangle of 2 `half`, its corners rounded by `radius`, at `height`: counter-clockwise seen
/// from above, from the middle of the side at +x.
Ring rounded_rectangle(const glm::dvec2& half, double radius, double height) {
    constexpr int kArc = 12;
    constexpr int kSide = 8;
    std::vector<glm::dvec2> outline;
    const glm::dvec2 inner = half - radius;
    for (int corner = 0; corner < 4; ++corner) {
        const glm::dvec2 centre{corner == 0 || corner == 3 ? inner.x : -inner.x,
                                corner < 2 ? inner.y : -inner.y};
        add_arc(outline, centre, radius, glm::dvec2(corner, corner + 1) * kQuarter, kArc);
        const glm::dvec2 from = outline.back();
        const glm::dvec2 to = corner == 0   ? glm::dvec2(-inner.x, half.y)
                              : corner == 1 ? glm::dvec2(-half.x, -inner.y)
                              : corner == 2 ? glm::dvec2(inner.x, -half.y)
                                            : glm::dvec2(half.x, inner.y);
        for (int i = 1; i < kSide; ++i)
            outline.push_back(glm::mix(from, to, double(i) / kSide));
    }
    Ring ring;
    for (const glm::dvec2& p : outline)
        ring.emplace_back(p.x, height, -p.y);
    return ring;
}

/// A circle at `height` with a point for each of `ring`'s, in the same directions from the middle.
Ring circle_like(const Ring& ring, double radius, double height) {
    Ring circle;
    for (const glm::dvec3& p : ring)
        circle.push_back(glm::normalize(glm::dvec3(p.x, 0, p.z)) * radius +
                         glm::dvec3(0, height, 0));
    return circle;
}

/// A plate with a bored boss: rounded along its upper edge, filleted round the boss. Its creases
/// are four: the plate's lower outline, the boss's rim, and the bore's two.
scene::Mesh flange() {
    constexpr double kThick = 0.5;
    constexpr double kRound = 0.15;
    constexpr double kFillet = 0.3;
    constexpr double kBoss = 0.6;
    constexpr double kHeight = 1.3;
    constexpr double kBore = 0.35;
    constexpr int kSteps = 8;
    const glm::dvec2 half{1.6, 1.1};
    const Ring lowest = rounded_rectangle(half, 0.4, 0);
    std::vector<Ring> rings{circle_like(lowest, kBore, 0), lowest};
    for (int i = 0; i <= kSteps; ++i) {
        const double angle_rad = kQuarter * i / kSteps;
        const double in = kRound * (1 - std::cos(angle_rad));
        const double height = kThick - kRound * (1 - std::sin(angle_rad));
        rings.push_back(rounded_rectangle(half - in, 0.4 - in, height));
    }
    for (int i = 0; i <= kSteps; ++i) {
        const double angle_rad = kQuarter * i / kSteps;
        rings.push_back(circle_like(lowest,
                                    kBoss + kFillet * (1 - std::sin(angle_rad)),
                                    kThick + kFillet * (1 - std::cos(angle_rad))));
    }
    rings.push_back(circle_like(lowest, kBoss, kHeight));
    rings.push_back(circle_like(lowest, kBore, kHeight));
    return loft(rings, {.along = true});
}

/// An angle of sheet metal, bent round a radius, its free ends rounded: two creases run round it.
scene::Mesh angle() {
    constexpr double kThick = 0.22;
    constexpr double kBend = 0.3;  // of the inner side
    constexpr int kSteps = 16;
    const glm::dvec2 bend{kThick + kBend, kThick + kBend};
    std::vector<glm::dvec2> outline;
    add_arc(outline, bend, kThick + kBend, {2 * kQuarter, 3 * kQuarter}, kSteps);
    add_arc(outline, {2 - kThick / 2, kThick / 2}, kThick / 2, {-kQuarter, kQuarter}, kSteps);
    add_arc(outline, bend, kBend, {3 * kQuarter, 2 * kQuarter}, kSteps);
    add_arc(outline, {kThick / 2, 1.6 - kThick / 2}, kThick / 2, {0, 2 * kQuarter}, kSteps);
    return extrude(outline, {-0.7, 0.7});
}

}  // namespace

scene::Scene make_bracket_scene() {
    Stage stage;
    stage.add("flange", flange(), {{-1.1, 0, 0}, {0, 14, 0}});
    stage.add("angle", angle(), {{1.25, 0, 0.2}, {0, -22, 0}});
    return stage.finish({{"front", 0, 16}, {"three_quarter", 32, 32}, {"behind", 150, 24}});
}

}  // namespace ink::catalogue
