#include "edge/binomial_blur.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "random_image.h"

namespace ink::edge {
namespace {

template <class T>
class BinomialBlur : public testing::Test {};
using Codes = testing::Types<std::uint8_t, std::uint16_t>;
TYPED_TEST_SUITE(BinomialBlur, Codes);

TYPED_TEST(BinomialBlur, EqualsOpenCvsFilterInTheInterior) {
    constexpr int kDepth = sizeof(TypeParam) == 1 ? CV_8U : CV_16U;
    constexpr int kMax = (1 << (8 * sizeof(TypeParam))) - 1;
    auto image = random_image<TypeParam>(50, 30, {0, kMax}, 3);
    const cv::Mat codes(30, 50, CV_MAKETYPE(kDepth, 1), image.data());
    const cv::Mat kernel = (cv::Mat_<double>(3, 3) << 1, 2, 1, 2, 4, 2, 1, 2, 1) / 16;
    cv::Mat theirs;
    cv::filter2D(codes, theirs, CV_64F, kernel);

    core::Image<TypeParam> ours(48, 28);
    binomial_blur({image.row(1) + 1, 48, 28, 50}, ours.view(), 0);
    for (int y = 1; y < 29; ++y) {
        for (int x = 1; x < 49; ++x) {
            ASSERT_EQ(ours.at(x - 1, y - 1), std::floor(theirs.template at<double>(y, x) + 0.5));
        }
    }
}

TYPED_TEST(BinomialBlur, WrappedCodesBlurLikeTheRampTheyStandFor) {
    constexpr int kBits = 8 * sizeof(TypeParam);
    const auto ramp = random_image<std::uint16_t>(40, 3, {200, 240}, 4);
    core::Image<TypeParam> wrapped(40, 3);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 40; ++x) {
            // The same values, moved so that about half of them lie beyond the top.
            wrapped.at(x, y) = static_cast<TypeParam>(ramp.at(x, y) + (1 << kBits) - 220);
        }
    }
    core::Image<std::uint16_t> plain(38, 1);
    core::Image<TypeParam> ours(38, 1);
    binomial_blur({ramp.row(1) + 1, 38, 1, 40}, plain.view(), 0);
    binomial_blur({wrapped.row(1) + 1, 38, 1, 40}, ours.view(), kBits);
    for (int x = 0; x < 38; ++x) {
        ASSERT_EQ(ours.at(x, 0), static_cast<TypeParam>(plain.at(x, 0) + (1 << kBits) - 220));
    }
}

}  // namespace
}  // namespace ink::edge
