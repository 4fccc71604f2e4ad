#include <glm/geometric.hpp>

#include "catalogue/catalogue_scenes.h"
#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"

namespace ink::catalogue {
namespace {

/// The straight bar from `a` to `b`, round: twelve sides bend less than a crease.
scene::Mesh bar(const glm::dvec3& a, const glm::dvec3& b, double radius) {
    const TubeNode ends[] = {{a, radius}, {b, radius}};
    return make_tube(ends, 12);
}

/// A space frame: two square grids of balls, the lower half a step aside, joined by bars. Every bar
/// ends inside its two balls and touches no other bar.
class SpaceFrame {
  public:
    SpaceFrame(Stage& stage, glm::ivec2 size) : stage_(stage), size_(size) {}

    void build() {
        const glm::ivec2 low = size_ - 1;
        place_layer(size_, upper(0, 0));
        place_layer(low, lower(0, 0));
        for (int j = 0; j < low.y; ++j) {
            for (int i = 0; i < low.x; ++i) {
                for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
                    join("brace", lower(i, j), upper(i + di, j + dj), 0.0035);
            }
        }
    }

  private:
    [[nodiscard]] glm::dvec3 upper(int i, int j) const {
        return {i - 0.5 * (size_.x - 1), 0, j - 0.5 * (size_.y - 1)};
    }
    [[nodiscard]] glm::dvec3 lower(int i, int j) const {
        return upper(i, j) + glm::dvec3(0.5, -0.75, 0.5);
    }

    void place_layer(glm::ivec2 count, const glm::dvec3& first) {
        for (int j = 0; j < count.y; ++j) {
            for (int i = 0; i < count.x; ++i) {
                const glm::dvec3 at = first + glm::dvec3(i, 0, j);
                stage_.place(ball_, "ball", Pose{at});
                if (i + 1 < count.x) join("chord", at, at + glm::dvec3(1, 0, 0), 0.006);
                if (j + 1 < count.y) join("chord", at, at + glm::dvec3(0, 0, 1), 0.006);
            }
        }
    }

    /// The bar ends 0.015 short of the balls' middles.
    void join(const char* name, const glm::dvec3& a, const glm::dvec3& b, double radius) {
        const glm::dvec3 short_by = glm::normalize(b - a) * 0.015;
        stage_.add(name, bar(a + short_by, b - short_by, radius));
    }

    Stage& stage_;
    glm::ivec2 size_;
    std::uint32_t ball_ = stage_.mesh("ball", make_icosphere(0.03, 2));
};

}  // namespace

scene::Scene make_truss_scene() {
    Stage stage;
    SpaceFrame(stage, {4, 3}).build();
    stage.view(Shot{"three_quarter", 34, 34});
    stage.view(EyeShot{"below", {-2.5, -1.75, 2.5}, {0, -0.375, 0}, 42});
    return stage.finish();
}

scene::Scene make_bars_scene() {
    // In the view "front" at 1280 x 720 a unit of the bars' fronts is 64 px, so a bar of w / 64
    // units is w px wide. It is as deep as it is wide: its sides add at most a fifth to that.
    constexpr double kUnit_px = 64;
    constexpr double kDistance = 45;
    constexpr double kFov_deg = 14.250032697803595;  // twice the arc tangent of 360 / 64 / 45
    Stage stage;
    stage.add("panel", make_sheet({-9.5, -5.25, -0.25}, {19, 0, 0}, {0, 10.5, 0}));
    for (int i = 0; i < 16; ++i) {
        const double width = (0.05 + 0.01 * i) / kUnit_px;
        // Each bar lies elsewhere within its pixel than its neighbour.
        const double x = 1.0 * i - 7.5 + 0.0071 * i;
        stage.add("upright", make_box({x, 0.5, -width}, {x + width, 4.5, 0}));
        const double left = 4.0 * (i % 4) - 7.5;
        const double y = -0.75 - 1.0 * (i / 4) + 0.0037 * i;
        stage.add("level", make_box({left, y, -width}, {left + 3, y + width, 0}));
    }
    stage.view(EyeShot{"front", {0, 0, kDistance}, {0, 0, 0}, kFov_deg});
    stage.view(Shot{"three_quarter", 24, 14});
    return stage.finish();
}

}  // namespace ink::catalogue
