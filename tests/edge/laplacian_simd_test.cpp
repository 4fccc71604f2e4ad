#include <gtest/gtest.h>

#include "edge/laplacian.h"
#include "guarded.h"
#include "plain_filters.h"

namespace ink::edge {
namespace {

template <class T>
class LaplacianSimd : public testing::Test {};
using Codes = testing::Types<std::uint8_t, std::uint16_t>;
TYPED_TEST_SUITE(LaplacianSimd, Codes);

template <class T>
void expect_plain(const core::ImageView<T>& codes,
                  const core::ImageView<std::uint8_t>& out,
                  const LaplacianResponse& r) {
    for (int y = 0; y < codes.height_px; ++y) {
        for (int x = 0; x < codes.width_px; ++x) {
            const T* at = codes.row(y) + x;
            ASSERT_EQ(out.at(x, y), respond(plain::laplacian_at(at, codes.stride), r));
            ASSERT_EQ(out.at(x, y), plain::response_at(at, codes.stride, r))
                << x << "," << y << " of width " << codes.width_px << ", response "
                << static_cast<int>(r.response) << " clip " << r.clip_bits << " scale "
                << r.scale_bits << " bits " << r.code_bits << " wraps " << r.code_wraps;
        }
    }
}

template <class T>
void check(int width_px, int height_px, unsigned seed, const LaplacianResponse& r) {
    Guarded<T> codes(width_px, height_px, static_cast<int>(seed % 67), 0);
    fill_adversarially(codes.pixels(), seed);
    Guarded<std::uint8_t> out(width_px, height_px, static_cast<int>(seed % 61), 171);
    laplacian(codes.view(), out.view(), r);
    expect_plain(codes.view(), out.view(), r);
    ASSERT_TRUE(out.is_margin_whole()) << "width " << width_px;
}

TYPED_TEST(LaplacianSimd, EveryWidthIsThePlainFilterAndNothingBesideIsWritten) {
    on_every_target([] {
        for (int width = 0; width <= 200; ++width) {
            for (unsigned seed = 0; seed < 3; ++seed) {
                const auto odd_seed = static_cast<unsigned>(width) * 3 + seed;
                check<TypeParam>(width, 1 + width % 7, odd_seed, {});
                if (testing::Test::HasFatalFailure()) return;
            }
        }
    });
}

TYPED_TEST(LaplacianSimd, EveryResponseIsThePlainFilter) {
    constexpr int kBits = 8 * sizeof(TypeParam);
    on_every_target([] {
        unsigned seed = 0;
        for (const Response response : {Response::absolute, Response::positive, Response::wrap}) {
            for (int clip = 0; clip <= 15; ++clip) {
                for (int scale = -15; scale <= 15; ++scale) {
                    check<TypeParam>(71, 2, ++seed, {response, clip, scale, kBits, false});
                    const int bits = 1 + static_cast<int>(seed) % kBits;
                    check<TypeParam>(71, 2, ++seed, {response, clip, scale, bits, true});
                    if (testing::Test::HasFatalFailure()) return;
                }
            }
        }
    });
}

TYPED_TEST(LaplacianSimd, EveryWayToLoseBitsInAHalvingIsThePlainFilter) {
    // All quadruples of neighbours two round the middle pixel, a cross every third column.
    constexpr int kCrosses = 5 * 5 * 5 * 5;
    Guarded<TypeParam> codes(3 * kCrosses, 1, 0, 100);
    const auto view = codes.view();
    for (int i = 0; i < kCrosses; ++i) {
        TypeParam* at = view.row(0) + 3 * i + 1;
        at[-1] = static_cast<TypeParam>(98 + i % 5);
        at[1] = static_cast<TypeParam>(98 + i / 5 % 5);
        at[-view.stride] = static_cast<TypeParam>(98 + i / 25 % 5);
        at[view.stride] = static_cast<TypeParam>(98 + i / 125);
    }
    on_every_target([&] {
        for (const Response response : {Response::absolute, Response::positive}) {
            for (const int clip : {0, 1, 2}) {
                const LaplacianResponse r{response, clip};
                Guarded<std::uint8_t> out(3 * kCrosses, 1, 0, 0);
                laplacian(view, out.view(), r);
                expect_plain(view, out.view(), r);
            }
        }
    });
}

}  // namespace
}  // namespace ink::edge
