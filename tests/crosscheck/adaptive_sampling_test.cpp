#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "catalogue/catalogue.h"
#include "crosscheck/dense_sampling.h"
#include "tests/truth/shapes.h"

// The cross-check looks closely at few pixels only. That it misses nothing thereby is shown against
// looking closely at all of them.

namespace ink::crosscheck {
namespace {

constexpr double kNear_px = 0.25;

/// Points of one class in cells of 1 px, so that a neighbour is found without trying all.
class PointGrid {
  public:
    PointGrid(const std::vector<SampledPoint>& points, truth::LineClass line_class) {
        for (const SampledPoint& p : points) {
            if (p.line_class == line_class) cells_[cell_of(p.x_px, p.y_px)].push_back(p);
        }
    }
    [[nodiscard]] bool has_near(const SampledPoint& p) const {
        const auto [x, y] = cell_of(p.x_px, p.y_px);
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto found = cells_.find({x + dx, y + dy});
                if (found == cells_.end()) continue;
                for (const SampledPoint& q : found->second) {
                    if (std::hypot(p.x_px - q.x_px, p.y_px - q.y_px) <= kNear_px) return true;
                }
            }
        }
        return false;
    }

  private:
    static std::pair<int, int> cell_of(double x, double y) {
        return {static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
    }
    std::map<std::pair<int, int>, std::vector<SampledPoint>> cells_;
};

/// Expects all but one in a thousand of the points of each class to have one of the same class in
/// `others` close by.
void expect_covered(const std::vector<SampledPoint>& points,
                    const std::vector<SampledPoint>& others) {
    for (const truth::LineClass line_class : truth::kLineClasses) {
        const PointGrid grid(others, line_class);
        std::size_t total = 0, missed = 0;
        for (const SampledPoint& p : points) {
            if (p.line_class != line_class) continue;
            ++total;
            if (!grid.has_near(p)) ++missed;
        }
        EXPECT_LE(1000 * missed, total)
            << missed << " of " << total << " of " << truth::name(line_class);
    }
}

SamplingOptions options_for(bool everywhere) {
    return {.everywhere = everywhere, .threads = 2};
}

class AdaptiveSampling : public testing::TestWithParam<const char*> {};

TEST_P(AdaptiveSampling, FindsWhatLookingEverywhereFinds) {
    constexpr std::size_t kWide_px = 240, kHigh_px = 135;
    const scene::Scene scene = catalogue::make_catalogue_scene(GetParam());
    const scene::Topology topology = scene::weld(scene);
    for (const scene::Camera& camera : scene.cameras) {
        SCOPED_TRACE(camera.name);
        const scene::View view{camera, kWide_px, kHigh_px};
        const SampledLines adaptive = sample_lines(topology, view, options_for(false));
        const SampledLines full = sample_lines(topology, view, options_for(true));
        ASSERT_GT(full.points.size(), 1000U);
        expect_covered(full.points, adaptive.points);
        EXPECT_GE(full.counts.rays, 64 * kWide_px * kHigh_px) << "8 x 8 a pixel";
        EXPECT_LT(adaptive.counts.rays, full.counts.rays);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue,
                         AdaptiveSampling,
                         testing::Values("blocks", "horizon", "fence", "torus", "room", "soup"),
                         [](const auto& test) { return std::string(test.param); });

class AdaptiveRays : public testing::TestWithParam<const char*> {};

// What is saved grows with the image, for lines are long and not wide. These have the most line.
TEST_P(AdaptiveRays, AreAFifthOfThoseOfLookingEverywhere) {
    const scene::Scene scene = catalogue::make_catalogue_scene(GetParam());
    const auto camera =
        std::find_if(scene.cameras.begin(), scene.cameras.end(), [](const scene::Camera& c) {
            return c.name == "three_quarter";
        });
    ASSERT_NE(camera, scene.cameras.end());
    const SampledLines adaptive =
        sample_lines(scene::weld(scene), {*camera, 1280, 720}, options_for(false));
    EXPECT_GT(adaptive.points.size(), 10000U);
    EXPECT_LE(5 * adaptive.counts.rays, 64U * 1280 * 720);
}

INSTANTIATE_TEST_SUITE_P(Catalogue,
                         AdaptiveRays,
                         testing::Values("blocks", "horizon", "fence", "soup"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace ink::crosscheck
