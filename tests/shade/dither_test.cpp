#include "shade/compose.h"

#include <gtest/gtest.h>

namespace ink::shade {
namespace {

/// The level of a stored value whose format has `top` as its highest.
int level_of(int value, int top) {
    const int level = (value * top + 127) / 255;
    EXPECT_EQ((level * 255 + top / 2) / top, value) << "no level of " << top;
    return level;
}

TEST(Dither, TheMeanOverFourByFourIsTheColourWithinASixteenthOfALevel) {
    const std::array<int, 3> tops565 = {31, 63, 31};
    const std::array<int, 3> tops332 = {7, 7, 3};
    for (const DitherFormat format : {DitherFormat::rgb565, DitherFormat::rgb332}) {
        const auto& tops = format == DitherFormat::rgb565 ? tops565 : tops332;
        EXPECT_EQ(top_levels(format), tops);
        for (int v = 0; v < 256; ++v) {
            const auto byte = static_cast<std::uint8_t>(v);
            const auto result = dither(core::Image<Rgb>(4, 4, Rgb(byte)), format);
            for (int c = 0; c < 3; ++c) {
                const int top = tops[static_cast<std::size_t>(c)];
                int sum = 0;
                for (std::size_t i = 0; i < result.size(); ++i)
                    sum += level_of(result.data()[i][c], top);
                EXPECT_NEAR(sum / 16.0, v * top / 255.0, 1.0 / 16) << "value " << v;
            }
        }
    }
}

TEST(Dither, ALevelStaysAsItIs) {
    // Levels 1 of 3 and 2 of 3 are 85 and 170; 0 and 255 are levels of all.
    for (const int v : {0, 85, 170, 255}) {
        const core::Image<Rgb> image(5, 7, Rgb(0, 255, v));
        EXPECT_EQ(dither(image, DitherFormat::rgb332), image);
    }
}

TEST(Dither, NoneChangesNothing) {
    const core::Image<Rgb> image(3, 2, Rgb(1, 2, 3));
    EXPECT_EQ(dither(image, DitherFormat::none), image);
    EXPECT_TRUE(dither({}, DitherFormat::rgb565).is_empty());
}

}  // namespace
}  // namespace ink::shade
