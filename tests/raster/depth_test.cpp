#include "raster/depth/depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/raster/gather_sink.h"

namespace ink::raster {
namespace {

constexpr DepthRange kRange{0.5, 100};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct NamedEncoding {
    DepthEncoding encoding;
    const char* name;
    bool is_affine;  ///< in 1/w, but for its steps
};
constexpr std::array kEncodings{
    NamedEncoding{DepthEncoding::inverse, "inverse", true},
    NamedEncoding{DepthEncoding::linear, "linear", false},
    NamedEncoding{DepthEncoding::log, "log", false},
    NamedEncoding{DepthEncoding::zbuffer24, "zbuffer24", true},
    NamedEncoding{DepthEncoding::zbuffer16, "zbuffer16", true},
    NamedEncoding{DepthEncoding::reversed_float, "reversed_float", true}};

TEST(EncodeDepth, RunsFromOneAtNearToZeroAtFar) {
    for (const auto& [encoding, name, is_affine] : kEncodings) {
        EXPECT_NEAR(encode_depth(encoding, 0.5, kRange), 1, 1e-15) << name;
        const double at_far = encoding == DepthEncoding::reversed_float ? 0.005F : 0;
        EXPECT_NEAR(encode_depth(encoding, 100, kRange), at_far, 1e-15) << name;
        EXPECT_GT(encode_depth(encoding, 3, kRange), encode_depth(encoding, 4, kRange)) << name;
    }
}

TEST(EncodeDepth, FollowsTheFormulas) {
    EXPECT_DOUBLE_EQ(encode_depth(DepthEncoding::inverse, 2, kRange), 0.5 * (100 / 2.0 - 1) / 99.5);
    EXPECT_DOUBLE_EQ(encode_depth(DepthEncoding::linear, 2, kRange), 98 / 99.5);
    EXPECT_DOUBLE_EQ(encode_depth(DepthEncoding::log, 2, kRange), std::log(50) / std::log(200));
    EXPECT_EQ(encode_depth(DepthEncoding::reversed_float, 3, kRange), static_cast<float>(0.5 / 3));
    const double z16 = encode_depth(DepthEncoding::zbuffer16, 2, kRange) * 65535;
    EXPECT_NEAR(z16, std::round(65535 * 0.5 * 49 / 99.5), 1e-9);
}

TEST(EncodeDepth, InfinityIsTheLimit) {
    EXPECT_NEAR(encode_depth(DepthEncoding::inverse, kInfinity, kRange), -0.5 / 99.5, 1e-15);
    EXPECT_EQ(encode_depth(DepthEncoding::reversed_float, kInfinity, kRange), 0);
    EXPECT_EQ(encode_depth(DepthEncoding::linear, kInfinity, kRange), -kInfinity);
    EXPECT_EQ(encode_depth(DepthEncoding::log, kInfinity, kRange), -kInfinity);
    EXPECT_TRUE(std::isfinite(encode_depth(DepthEncoding::zbuffer24, kInfinity, kRange)));
}

/// OpenGL 4.6, section 13.8 and 2.3.5: d = (1/n - 1/w) / (1/n - 1/f), stored as round(d (2^b - 1)).
std::uint32_t opengl_depth_turned_over(double w, double steps) {
    const double d = (1 / kRange.near - 1 / w) / (1 / kRange.near - 1 / kRange.far);
    return static_cast<std::uint32_t>(steps - std::round(d * steps));
}

TEST(QuantisedDepth, IsOpenGlsWindowDepthWithNearHigh) {
    const QuantisedDepth z24(DepthFormat::z24, kRange.near, kRange.far);
    const QuantisedDepth z16(DepthFormat::z16, kRange.near, kRange.far);
    for (const double w : {0.5, 0.75, 1.0, 3.3, 17.0, 60.0}) {
        EXPECT_EQ(z24.of(1 / w), opengl_depth_turned_over(w, 16777215)) << w;
        EXPECT_EQ(z16.of(1 / w), opengl_depth_turned_over(w, 65535)) << w;
    }
    EXPECT_EQ(z24.of(2), 16777215U);
    EXPECT_EQ(z16.of(2), 65535U);
}

TEST(QuantisedDepth, AStepStandsForTheMiddleOfWhatRoundsToIt) {
    for (const DepthFormat format : {DepthFormat::z24, DepthFormat::z16}) {
        const QuantisedDepth depth(format, kRange.near, kRange.far);
        for (const double step : {1.0, 2.0, 777.0, depth.steps() - 1}) {
            const double q = depth.q_of(static_cast<std::uint32_t>(step));
            EXPECT_EQ(depth.of(q - 0.49 / depth.scale()), step);
            EXPECT_EQ(depth.of(q + 0.49 / depth.scale()), step);
        }
    }
}

TEST(QuantisedDepth, WhatLiesBeyondFarIsStillNearerThanTheSky) {
    const QuantisedDepth z16(DepthFormat::z16, kRange.near, kRange.far);
    EXPECT_EQ(z16.of(1 / 100.0), 1U);
    EXPECT_EQ(z16.of(1e-9), 1U);
    EXPECT_EQ(z16.of(1e9), 65535U) << "and nothing before near overflows";
}

TEST(DepthFormat, APassWritesEachFormatByItsFormula) {
    TestMesh mesh;
    mesh.add_triangle({-9, -9, 4}, {99, -9, 4}, {-9, 99, 4});
    for (const DepthFormat format : {DepthFormat::z24, DepthFormat::z16}) {
        PassFormat pass;
        pass.depth = format;
        const auto drawn = gathered<std::uint8_t, std::uint32_t>(pass, mesh.input(), 8, 8);
        const double steps = format == DepthFormat::z24 ? 16777215 : 65535;
        EXPECT_EQ(drawn.depth.at(3, 3), opengl_depth_turned_over(4, steps));
    }
    EXPECT_EQ(gathered<std::uint8_t>({}, mesh.input(), 8, 8).depth.at(3, 3), 0.25F);
}

/// One column of a floor: the view's middle ray meets it at distance 1 under `angle_rad`.
struct Floor {
    static constexpr int kHeight_px = 480;
    static constexpr double kFocal_px = 660;  // 40 degrees of height
    static constexpr DepthRange kVisible{0.25, 25};

    /// Distances at the rows' centres, as far as they lie within kVisible.
    static std::vector<double> column(double angle_rad) {
        std::vector<double> w;
        for (int y = 0; y < kHeight_px; ++y) {
            // 1/w is affine on the screen: down by one focal length turns the ray by 45 degrees.
            const double down = (y + 0.5 - kHeight_px / 2.0) / kFocal_px;
            const double q = 1 + down / std::tan(angle_rad);
            if (q > 1 / kVisible.far && q < 1 / kVisible.near) w.push_back(1 / q);
        }
        return w;
    }
};

/// The largest |Laplacian| of codes along a column (across it, the floor is level).
template <class Code>
double largest_laplacian(const std::vector<double>& column, Code code) {
    double largest = 0;
    for (std::size_t i = 1; i + 1 < column.size(); ++i) {
        const double l = 2 * code(column[i]) - code(column[i - 1]) - code(column[i + 1]);
        largest = std::max(largest, std::abs(l));
    }
    return largest;
}

TEST(DepthEncodingTable, OnAPlaneTheLaplacianIsZeroExactlyForWhatIsAffineInOneOverW) {
    const std::vector<double> column = Floor::column(0.2);
    ASSERT_GT(column.size(), 100U);
    for (const auto& [encoding, name, is_affine] : kEncodings) {
        const double l = largest_laplacian(
            column, [&](double w) { return encode_depth(encoding, w, Floor::kVisible); });
        // Rounding four numbers to a step each leaves two steps at most.
        double rounding = 1e-14;
        if (encoding == DepthEncoding::zbuffer24) rounding = 2.001 / 16777215;
        if (encoding == DepthEncoding::zbuffer16) rounding = 2.001 / 65535;
        if (encoding == DepthEncoding::reversed_float) rounding = 2.001 * 0x1p-24;
        if (is_affine) {
            EXPECT_LT(l, rounding) << name;
        } else {
            EXPECT_GT(l, 1e-4) << name;
        }
    }
}

}  // namespace
}  // namespace ink::raster
