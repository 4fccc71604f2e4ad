#include "edge/laplacian.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "edge/edge_image.h"
#include "tests/edge/plain_filters.h"
#include "tests/edge/random_image.h"

namespace ink::edge {
namespace {

template <class T>
class LaplacianOf : public testing::Test {};
using Codes = testing::Types<std::uint8_t, std::uint16_t>;
TYPED_TEST_SUITE(LaplacianOf, Codes);

TYPED_TEST(LaplacianOf, EqualsOpenCvInTheInterior) {
    constexpr int kDepth = sizeof(TypeParam) == 1 ? CV_8U : CV_16U;
    constexpr int kMax = (1 << (8 * sizeof(TypeParam))) - 1;
    auto image = random_image<TypeParam>(61, 40, {0, kMax}, 2);
    const cv::Mat codes(40, 61, CV_MAKETYPE(kDepth, 1), image.data());
    cv::Mat theirs;
    cv::Laplacian(codes, theirs, CV_64F, 1);

    // OpenCV's kernel has the other sign: 0 1 0 / 1 -4 1 / 0 1 0.
    const LaplacianResponse r{Response::positive, 0, sizeof(TypeParam) == 1 ? -2 : -10, 8, false};
    EdgeImage ours(59, 38);
    laplacian({image.row(1) + 1, 59, 38, 61}, ours.view(), r);
    for (int y = 1; y < 39; ++y) {
        for (int x = 1; x < 60; ++x) {
            const int l = static_cast<int>(-theirs.at<double>(y, x));
            ASSERT_EQ(ours.at(x - 1, y - 1), std::min(std::max(l, 0) >> -r.scale_bits, 255));
        }
    }
}

TEST(Laplacian, AOnePixelStepIsTwoWideInAbsoluteAndOneInPositive) {
    const std::vector<std::uint8_t> row = {40, 40, 40, 40, 90, 90, 90, 90};
    std::vector<std::uint8_t> out(6);
    const auto filtered = [&](Response response) {
        // No way from row to row: all are this one.
        laplacian({row.data() + 1, 6, 1, 0}, {out.data(), 6, 1, 6}, {response});
        return out;
    };
    EXPECT_EQ(filtered(Response::absolute), (std::vector<std::uint8_t>{0, 0, 48, 48, 0, 0}));
    EXPECT_EQ(filtered(Response::positive), (std::vector<std::uint8_t>{0, 0, 0, 48, 0, 0}));
}

TEST(Laplacian, ClippingTwoBitsSilencesUpToThree) {
    for (int l = -3; l <= 3; ++l)
        EXPECT_EQ(respond(l, {}), 0);
    EXPECT_EQ(respond(4, {}), 4);
    EXPECT_EQ(respond(-4, {}), 4);
}

TEST(Laplacian, LiteralWrapTurnsASmallNegativeIntoAStrongLine) {
    LaplacianResponse literal;
    literal.response = Response::wrap;
    EXPECT_EQ(respond(3, literal), 0);
    EXPECT_EQ(respond(-1, literal), 252);
}

TEST(Laplacian, AWrappedCodeIsReadTheShortWayRound) {
    LaplacianResponse wrapping{Response::absolute, 0, 0, 8, true};
    EXPECT_EQ(respond(255, wrapping), 1);
    EXPECT_EQ(respond(-255, wrapping), 1);
    EXPECT_EQ(respond(128, wrapping), 128);
    wrapping.code_bits = 4;
    EXPECT_EQ(respond(15, wrapping), 1);
}

TEST(Laplacian, NoWidthWritesNothing) {
    const std::uint8_t in[3] = {1, 2, 3};
    std::uint8_t out = 7;
    laplacian({in + 1, 0, 1, 0}, {&out, 0, 1, 0}, {});
    EXPECT_EQ(out, 7);
}

}  // namespace
}  // namespace ink::edge
