// Roberts, Sobel, blur, jumps and threshold on every SIMD target against their plain formulas.

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "edge/binomial_blur.h"
#include "edge/bit_mask.h"
#include "edge/side_differences.h"
#include "edge/sobel.h"
#include "guarded.h"
#include "plain_filters.h"

namespace ink::edge {
namespace {

/// Runs `filter(in, out)` over all widths and holds it to `plain(at, stride)`.
template <class T, class Filter, class Plain>
void expect_every_width(Filter filter, Plain plain) {
    on_every_target([&] {
        for (int width = 0; width <= 200; ++width) {
            const auto seed = static_cast<unsigned>(width);
            Guarded<T> in(width, 1 + width % 4, width % 67, T{0});
            fill_adversarially(in.pixels(), seed + seed / 7);
            Guarded<T> out(width, 1 + width % 4, width % 61, T{77});
            filter(in.view(), out.view());
            const auto view = in.view();
            for (int y = 0; y < view.height_px; ++y) {
                for (int x = 0; x < width; ++x) {
                    ASSERT_EQ(out.view().at(x, y), plain(view.row(y) + x, view.stride))
                        << x << "," << y << " of width " << width;
                }
            }
            ASSERT_TRUE(out.is_margin_whole()) << "width " << width;
        }
    });
}

TEST(Operators, RobertsIsThePlainCross) {
    expect_every_width<float>([](auto in, auto out) { roberts(in, out); }, plain::roberts_at);
}

TEST(Operators, SobelFirstIsThePlainFormula) {
    expect_every_width<float>([](auto in, auto out) { sobel(in, Differential::first, out); },
                              plain::sobel_first_at);
}

TEST(Operators, SobelSecondIsThePlainFormula) {
    expect_every_width<float>([](auto in, auto out) { sobel(in, Differential::second, out); },
                              plain::sobel_second_at);
}

TEST(SideDifferences, AreThePlainFormula) {
    for (const Sides sides : {Sides::square, Sides::forward}) {
        for (const int gain_bits : {0, 6, 8}) {
            expect_every_width<std::uint8_t>(
                [&](auto in, auto out) { side_differences(in, out, sides, gain_bits); },
                [&](const std::uint8_t* at, std::ptrdiff_t stride) {
                    return plain::side_difference_at(at, stride, sides, gain_bits);
                });
        }
    }
}

TEST(DepthJumps, AreThePlainFormulaAndLeaveOtherPixels) {
    for (const Sides sides : {Sides::square, Sides::forward}) {
        for (const DepthJump& jump : {DepthJump{0.01F, 0, 2}, {0.1F, 0.05F, 0.5F}, {1e-7F, 0, 1}}) {
            expect_every_width<float>(
                [&](auto in, auto out) {
                    core::Image<std::uint8_t> marks(out.width_px, out.height_px, 77);
                    add_depth_jumps(in, marks.view(), sides, jump);
                    for (int y = 0; y < out.height_px; ++y)
                        std::copy_n(marks.row(y), out.width_px, out.row(y));
                },
                [&](const float* at, std::ptrdiff_t stride) {
                    return plain::has_depth_jump_at(at, stride, sides, jump) ? 255.0F : 77.0F;
                });
        }
    }
}

TEST(DepthJumps, AreStepsNotPlanesNorBends) {
    const auto marked = [](const std::vector<float>& q) {
        // The same in all rows.
        std::vector<float> rows;
        for (int y = 0; y < 4; ++y)
            rows.insert(rows.end(), q.begin(), q.end());
        const int stride = static_cast<int>(q.size());
        std::vector<std::uint8_t> out(q.size() - 3, 0);
        const int width = stride - 3;
        add_depth_jumps({rows.data() + stride + 1, width, 1, stride},
                        {out.data(), width, 1, width},
                        Sides::square,
                        {0.01F, 0, 2});
        return out;
    };
    using Marks = std::vector<std::uint8_t>;
    EXPECT_EQ(marked({4, 5, 6, 7, 8, 9, 10}), Marks(4, 0));           // a plane
    EXPECT_EQ(marked({4, 4, 4, 4, 8, 12, 16}), Marks(4, 0));          // a bend
    EXPECT_EQ(marked({4, 4, 4, 6, 6, 6, 6}), (Marks{0, 255, 0, 0}));  // a step
    EXPECT_EQ(marked({4, 4.5, 5, 6.25, 6.5, 6.75, 7}), (Marks{0, 255, 0, 0}));
    EXPECT_EQ(marked({4, 4.5, 5, 5.75, 6, 6.25, 6.5}), Marks(4, 0));        // less than twice 0.5
    EXPECT_EQ(marked({4, 4, 4, 4.04F, 4.04F, 4.04F, 4.04F}), Marks(4, 0));  // less than 1 in 100
}

template <class T>
class Blur : public testing::Test {};
using Codes = testing::Types<std::uint8_t, std::uint16_t>;
TYPED_TEST_SUITE(Blur, Codes);

TYPED_TEST(Blur, IsThePlainFormulaForEveryNumberOfBits) {
    using T = TypeParam;
    for (int bits = 0; bits <= 8 * static_cast<int>(sizeof(T)); bits += 4) {
        expect_every_width<T>([&](auto in, auto out) { binomial_blur(in, out, bits); },
                              [&](const T* at, std::ptrdiff_t stride) {
                                  return plain::blurred_at(at, stride, bits);
                              });
    }
}

TEST(Operators, SobelFirstIsOpenCvsTwoSobelsInTheInterior) {
    constexpr int kWidth = 97;
    constexpr int kHeight = 31;
    core::Image<float> image(kWidth, kHeight);
    std::vector<float> pixels(image.size());
    fill_adversarially(pixels, 3);
    std::copy(pixels.begin(), pixels.end(), image.data());
    const cv::Mat values(kHeight, kWidth, CV_32F, image.data());
    cv::Mat dx;
    cv::Mat dy;
    cv::Sobel(values, dx, CV_64F, 1, 0);
    cv::Sobel(values, dy, CV_64F, 0, 1);
    core::Image<float> out(kWidth, kHeight);
    const core::ImageView<const float> inner{image.row(1) + 1, kWidth - 2, kHeight - 2, kWidth};
    sobel(inner,
          Differential::first,
          core::ImageView<float>{out.row(1) + 1, kWidth - 2, kHeight - 2, kWidth});
    for (int y = 1; y + 1 < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
            const double sum = std::abs(dx.at<double>(y, x)) + std::abs(dy.at<double>(y, x));
            ASSERT_NEAR(out.at(x, y), sum / 8, 1e-6);
        }
    }
}

TEST(Roberts, AOnePixelStepIsOneWide) {
    const float rows[2][6] = {{9, 9, 9, 60, 60, 60}, {9, 9, 9, 60, 60, 60}};
    float out[5];
    roberts({rows[0], 5, 1, 6}, {out, 5, 1, 5});
    EXPECT_EQ(std::vector<float>(out, out + 5), (std::vector<float>{0, 0, 102, 0, 0}));
}

TEST(Sobel, AOnePixelStepIsTwoWideInBothDifferentials) {
    float rows[3][8];
    for (auto& row : rows) {
        for (int x = 0; x < 8; ++x)
            row[x] = x < 4 ? 20 : 60;
    }
    float out[6];
    sobel({rows[1] + 1, 6, 1, 8}, Differential::first, {out, 6, 1, 6});
    EXPECT_EQ(std::vector<float>(out, out + 6), (std::vector<float>{0, 0, 20, 20, 0, 0}));
    sobel({rows[1] + 1, 6, 1, 8}, Differential::second, {out, 6, 1, 6});
    EXPECT_EQ(std::vector<float>(out, out + 6), (std::vector<float>{0, 0, 40, 40, 0, 0}));
}

TEST(ThresholdSimd, IsTheComparisonAtEveryResponseAndWidth) {
    for (const int at_least : {1, 2, 127, 128, 254, 255}) {
        expect_every_width<std::uint8_t>(
            [&](auto in, auto out) { threshold(in, at_least, out); },
            [&](const std::uint8_t* at, std::ptrdiff_t) { return *at >= at_least ? 1 : 0; });
    }
}

}  // namespace
}  // namespace ink::edge
