// Decaudin's operators and the four-float Laplacian on every SIMD target against their formulas.

#include <gtest/gtest.h>

#include <vector>

#include "edge/decaudin_filter.h"
#include "edge/edge_image.h"
#include "edge/laplacian_f32x4.h"
#include "guarded.h"
#include "plain_filters.h"

namespace ink::edge {
namespace {

/// Four channels of one size with a margin of three pixels.
class Planes {
  public:
    Planes(int width_px, int height_px, unsigned seed) {
        for (unsigned i = 0; i < 4; ++i) {
            planes_.emplace_back(width_px, height_px, static_cast<int>(seed % 19), 0.0F);
            fill_adversarially(planes_.back().pixels(), seed * 4 + i);
        }
    }
    [[nodiscard]] FloatPlanes views() {
        FloatPlanes views;
        for (std::size_t i = 0; i < 4; ++i)
            views.origin[i] = planes_[i].view().data;
        views.stride = planes_[0].view().stride;
        return views;
    }
    [[nodiscard]] core::ImageView<float> view(std::size_t i) { return planes_[i].view(); }

  private:
    std::vector<Guarded<float>> planes_;
};

std::vector<DecaudinChannel> channels_of(Planes& planes, const DecaudinK& k) {
    std::vector<DecaudinChannel> channels;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto view = planes.view(i);
        channels.push_back({view.data, view.stride, {k.k * (1 + static_cast<float>(i)), k.place}});
    }
    return channels;
}

/// p of one channel from a g of its own, one pixel wider than the image.
core::Image<float> plain_p(const DecaudinChannel& channel, int width_px, int height_px) {
    core::Image<float> g(width_px + 2, height_px + 2);
    for (int y = 0; y < g.height_px(); ++y) {
        for (int x = 0; x < g.width_px(); ++x) {
            const float* at = channel.origin + (y - 1) * channel.stride + x - 1;
            g.at(x, y) = plain::decaudin_g_at(at, channel.stride);
        }
    }
    core::Image<float> p(width_px, height_px);
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x)
            p.at(x, y) = plain::decaudin_p_at(g.row(y + 1) + x + 1, g.width_px(), channel.k);
    }
    return p;
}

EdgeImage plain_decaudin(const std::vector<DecaudinChannel>& channels,
                         DecaudinJoin join,
                         int width_px,
                         int height_px) {
    core::Image<float> joined(width_px, height_px, 0.0F);
    for (const DecaudinChannel& channel : channels) {
        const auto p = plain_p(channel, width_px, height_px);
        for (std::size_t i = 0; i < p.size(); ++i)
            joined.data()[i] = plain::join(joined.data()[i], p.data()[i], join);
    }
    EdgeImage out(width_px, height_px);
    for (std::size_t i = 0; i < out.size(); ++i)
        out.data()[i] = plain::decaudin_response(joined.data()[i], join);
    return out;
}

void check_decaudin(int width_px, int height_px, DecaudinJoin join, const DecaudinK& k) {
    Planes planes(width_px, height_px, static_cast<unsigned>(width_px));
    const auto channels = channels_of(planes, k);
    const EdgeImage expected = plain_decaudin(channels, join, width_px, height_px);
    Guarded<std::uint8_t> out(width_px, height_px, width_px % 61, 171);
    decaudin(channels, join, out.view());
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x)
            ASSERT_EQ(out.view().at(x, y), expected.at(x, y))
                << x << "," << y << " of width " << width_px;
    }
    ASSERT_TRUE(out.is_margin_whole()) << "width " << width_px;
}

TEST(DecaudinSimd, EveryWidthIsThePlainFilterAndNothingBesideIsWritten) {
    on_every_target([] {
        for (int width = 0; width <= 200; ++width) {
            const auto join = static_cast<DecaudinJoin>(width % 3);
            const auto place = width % 2 == 0 ? KPlace::inside : KPlace::outside;
            check_decaudin(width, 1 + width % 5, join, {1.3F, place});
            if (testing::Test::HasFatalFailure()) return;
        }
    });
}

TEST(DecaudinSimd, ImagesOfManyStripsAreThePlainFilter) {
    on_every_target([] { check_decaudin(2500, 37, DecaudinJoin::either, {0.9F}); });
}

TEST(DecaudinSimd, RowsOfPAreThePlainOperator) {
    on_every_target([] {
        for (int width = 0; width <= 200; ++width) {
            Planes planes(width, 3, static_cast<unsigned>(width));
            const auto in = planes.view(0);
            const DecaudinK k{0.7F, width % 2 == 0 ? KPlace::inside : KPlace::outside};
            Guarded<float> p(width, 1, width % 13, -1.0F);
            decaudin_p_row(in.row(0), in.row(1), in.row(2), p.view().data, width, k);
            for (int x = 0; x < width; ++x) {
                const float* at = in.row(1) + x;
                ASSERT_EQ(p.view().at(x, 0), plain::decaudin_p_at(at, in.stride, k));
            }
            ASSERT_TRUE(p.is_margin_whole());
        }
    });
}

void check_full(int width_px, int height_px, const FullLaplacianResponse& r) {
    Planes planes(width_px, height_px, static_cast<unsigned>(width_px));
    const FloatPlanes views = planes.views();
    Guarded<std::uint8_t> out(width_px, height_px, width_px % 61, 171);
    laplacian_f32x4(views, out.view(), r);
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x)
            ASSERT_EQ(out.view().at(x, y), plain::full_response_at(views, y * views.stride + x, r))
                << x << "," << y << " of width " << width_px;
    }
    ASSERT_TRUE(out.is_margin_whole()) << "width " << width_px;
}

TEST(LaplacianF32x4, EveryWidthIsThePlainFilterAndNothingBesideIsWritten) {
    on_every_target([] {
        for (int width = 0; width <= 200; ++width) {
            check_full(width, 1 + width % 3, {.full = 9, .threshold = 0.7F});
            check_full(
                width,
                1 + width % 3,
                {.sum = LaplacianSum::absolute_of_sum, .weights = {1, -0.5F, 0.25F, 3}, .full = 6});
            if (testing::Test::HasFatalFailure()) return;
        }
    });
}

TEST(LaplacianF32x4, SumsWhatChannelsShowAndDrawsNothingBelowTheThreshold) {
    // A step of 1 in one channel and of -1 in another: |L| is 1 in both, and their sum cancels.
    std::vector<float> step = {0, 0, 0, 1, 1, 1};
    std::vector<float> fall = {1, 1, 1, 0, 0, 0};
    std::vector<float> flat(6, 0.5F);
    std::array<float, 6 * 3> rows[3];
    const auto stack = [](const std::vector<float>& row) {
        std::array<float, 18> rows3{};
        for (std::size_t i = 0; i < 18; ++i)
            rows3[i] = row[i % 6];
        return rows3;
    };
    rows[0] = stack(step);
    rows[1] = stack(fall);
    rows[2] = stack(flat);
    const FloatPlanes planes{{&rows[0][7], &rows[1][7], &rows[2][7], &rows[2][7]}, 6};
    const auto filtered = [&](const FullLaplacianResponse& r) {
        std::vector<std::uint8_t> out(4);
        laplacian_f32x4(planes, {out.data(), 4, 1, 4}, r);
        return out;
    };
    EXPECT_EQ(filtered({.full = 4}), (std::vector<std::uint8_t>{0, 128, 128, 0}));
    EXPECT_EQ(filtered({.full = 4, .threshold = 2.1F}), (std::vector<std::uint8_t>{0, 0, 0, 0}));
    EXPECT_EQ(filtered({.sum = LaplacianSum::absolute_of_sum}),
              (std::vector<std::uint8_t>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace ink::edge
