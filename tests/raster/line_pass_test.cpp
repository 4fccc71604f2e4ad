#include "raster/lines/line_pass.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "line_reference.h"
#include "raster/pass/view_transform.h"

namespace ink::raster {
namespace {

constexpr int kWidth_px = 120;
constexpr int kHeight_px = 90;

scene::View test_view() {
    scene::View view;
    view.camera.eye_world = {0, 0, 0};
    view.camera.near = 1;
    view.camera.far = 9;
    view.width_px = kWidth_px;
    view.height_px = kHeight_px;
    return view;
}

/// Lines between points given as (x_px, y_px, w), and what they are drawn into.
struct Sheet {
    std::vector<glm::dvec3> p_world;
    std::vector<Line> lines;
    DepthImage depth;
    core::Image<std::uint8_t> out{kWidth_px, kHeight_px};

    explicit Sheet(DepthFormat format = DepthFormat::z24, double q_behind = 0) {
        depth.start(format, test_view().camera.near, test_view().camera.far, kWidth_px, kHeight_px);
        depth.bits().fill(q_behind == 0                ? 0
                          : format == DepthFormat::q32 ? FloatBits(depth).of(q_behind)
                                                       : StepBits(depth).of(q_behind));
    }
    void add(const glm::dvec3& from, const glm::dvec3& to) {
        const scene::Projection projection(test_view());
        for (const glm::dvec3& p : {from, to})
            p_world.push_back(projection.ray_world(p.x, p.y) * p.z);
        const auto count = static_cast<std::uint32_t>(p_world.size());
        lines.push_back({count - 2, count - 1});
    }
    [[nodiscard]] LineInput input() const {
        LineInput result;
        result.p_world = p_world;
        result.lines = lines;
        result.view = test_view();
        return result;
    }
    LineCounts draw(const LineInput& input) {
        LinePass pass;
        return pass.draw(input, depth, out);
    }
    [[nodiscard]] std::set<Pixel> inked() const {
        std::set<Pixel> result;
        for (int y = 0; y < kHeight_px; ++y) {
            for (int x = 0; x < kWidth_px; ++x) {
                if (out.at(x, y) != 0) result.insert({x, y});
            }
        }
        return result;
    }
    [[nodiscard]] ScreenVertex screen(std::uint32_t vertex) const {
        return to_screen(ViewTransform(test_view()).to_clip(p_world[vertex]));
    }
};

TEST(LinePass, DrawsThePixelsOfTheReferenceThatLieInTheImage) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> x(-40, kWidth_px + 40);
    std::uniform_real_distribution<double> y(-40, kHeight_px + 40);
    for (int i = 0; i < 60; ++i) {
        Sheet sheet;
        sheet.add({x(random), y(random), 2}, {x(random), y(random), 3});
        LineInput input = sheet.input();
        input.width_px = i % 5 + 1;
        sheet.draw(input);
        std::set<Pixel> expected;
        for (const Pixel& p : reference_line(sheet.screen(0), sheet.screen(1), i % 5 + 1)) {
            if (sheet.out.contains(p.first, p.second)) expected.insert(p);
        }
        EXPECT_EQ(sheet.inked(), expected) << i;
    }
}

/// q runs from 1/2 at x = 10.25 to 1/5 at x = 100.75, whatever the row.
TEST(LinePass, KeepsDepthTheSameAcrossTheWidth) {
    Sheet sheet;
    sheet.add({10.25, 20, 2}, {100.75, 60, 5});
    LineInput input = sheet.input();
    input.width_px = 5;
    for (const int nearer : {-1, 1}) {
        for (int column = 12; column < 100; ++column) {
            const double q = 0.5 + (0.2 - 0.5) * (column + 0.5 - 10.25) / (100.75 - 10.25);
            for (int y = 0; y < kHeight_px; ++y)
                sheet.depth.bits().at(column, y) = StepBits(sheet.depth).of(q) + nearer;
        }
        sheet.out.fill(0);
        sheet.draw(input);
        for (int column = 12; column < 100; ++column) {
            int rows = 0;
            for (int y = 0; y < kHeight_px; ++y)
                rows += sheet.out.at(column, y) != 0 ? 1 : 0;
            EXPECT_EQ(rows, nearer < 0 ? 5 : 0);
        }
    }
}

TEST(LinePass, IsSeenAtEqualDepthAndNotBehind) {
    for (const DepthFormat format : {DepthFormat::q32, DepthFormat::z24, DepthFormat::z16}) {
        for (const double q_behind : {0.25, 0.26}) {
            Sheet sheet(format, q_behind);
            sheet.add({10, 10.2, 4}, {50, 30.3, 4});
            sheet.draw(sheet.input());
            EXPECT_EQ(sheet.inked().empty(), q_behind > 0.25);
        }
    }
}

/// 7 steps of z16 are less than what the line lies behind by, 9 are not; of z24 neither is.
TEST(LinePass, IsBiasedByUnits) {
    for (const int units : {7, 9}) {
        Sheet sheet(DepthFormat::z16, 0.25);
        const double step = (1 - 1.0 / 9) / 65535;
        sheet.add({10, 10.2, 1 / (0.25 - 8 * step)}, {50, 30.3, 1 / (0.25 - 8 * step)});
        LineInput input = sheet.input();
        input.offset.units = -units;
        sheet.draw(input);
        EXPECT_EQ(sheet.inked().empty(), units == 7);
    }
}

/// From a pixel of the image past the eye: as far as the frame, along the row where it lies.
TEST(LinePass, IsCutAtTheNearPlane) {
    Sheet sheet;
    sheet.add({30.1, 45.5, 3}, {30.1, 45.5, 3});
    sheet.p_world[1] += glm::dvec3{-1, 0, 5};  // behind the eye, to the left
    sheet.draw(sheet.input());
    const auto inked = sheet.inked();
    ASSERT_FALSE(inked.empty());
    for (const auto& [x, y] : inked)
        EXPECT_LE(x, 30);
    EXPECT_EQ(inked.begin()->first, 0);
}

TEST(LinePass, LeavesOutWhatIsNoLineOfTheImage) {
    Sheet sheet;
    sheet.add({-30, 5, 2}, {-10, 80, 2});    // left of the image
    sheet.add({30, 5, 0.5}, {60, 80, 0.9});  // before the near plane
    sheet.p_world.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    sheet.lines.push_back({0, 4});
    EXPECT_EQ(sheet.draw(sheet.input()).lines, 3U);
    EXPECT_TRUE(sheet.inked().empty());
}

/// Short lines before and behind a wall with a hole in it.
TEST(LinePass, PassesOverHiddenLinesWithoutChangingTheImage) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> x(-10, kWidth_px + 10);
    std::uniform_real_distribution<double> y(-10, kHeight_px + 10);
    std::uniform_real_distribution<double> by(-9, 9);
    std::uniform_real_distribution<double> w(1.5, 6);
    for (const DepthFormat format : {DepthFormat::q32, DepthFormat::z24, DepthFormat::z16}) {
        for (const double units : {0.0, -300.0}) {
            Sheet sheet(format, 0.4);
            for (int at = 30; at < 60; ++at)
                std::fill_n(sheet.depth.bits().row(at) + 40, 30, 0U);
            for (int i = 0; i < 4000; ++i) {
                const glm::dvec3 from{x(random), y(random), w(random)};
                // Some at the wall's own depth, where a step decides.
                const double w_to = i % 3 == 0 ? 2.5 : from.z + 0.05 * by(random);
                sheet.add(from, {from.x + by(random), from.y + by(random), w_to});
            }
            LineInput input = sheet.input();
            input.width_px = 3;
            input.offset = {-1, units};
            const LineCounts counts = sheet.draw(input);
            EXPECT_GT(counts.hidden, 500U);
            const auto quick = sheet.out;
            sheet.out.fill(0);
            input.skips_hidden = false;
            EXPECT_EQ(sheet.draw(input).hidden, 0U);
            EXPECT_TRUE(sheet.out == quick);
        }
    }
}

TEST(LinePass, RoundsItsWidthAsOpenGlDoes) {
    EXPECT_EQ(line_width_px(0), 1);
    EXPECT_EQ(line_width_px(1.49), 1);
    EXPECT_EQ(line_width_px(1.5), 2);
    EXPECT_EQ(line_width_px(3.2), 3);
}

TEST(LinePass, GivesTheSameImageOnEveryThreadCount) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-60, kWidth_px + 60);
    std::uniform_real_distribution<double> y(-60, kHeight_px + 60);
    std::uniform_real_distribution<double> w(0.8, 8);
    for (const DepthFormat format : {DepthFormat::q32, DepthFormat::z16}) {
        Sheet first(format);
        for (int i = 0; i < 3000; ++i)
            first.add({x(random), y(random), w(random)}, {x(random), y(random), w(random)});
        LineInput input = first.input();
        input.width_px = 3;
        LinePass pass;
        for (const int threads : {1, 2, 5}) {
            Sheet sheet(format);
            input.threads = threads;
            pass.draw(input, sheet.depth, sheet.out);
            if (threads == 1) first.out = sheet.out;
            EXPECT_TRUE(sheet.out == first.out) << threads;
        }
    }
}

}  // namespace
}  // namespace ink::raster
