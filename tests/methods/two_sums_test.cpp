#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "buffers/code_layout.h"
#include "methods/registry.h"

namespace ink::methods {
namespace {

constexpr double kFacet_rad = 10 * std::numbers::pi / 180;

glm::dvec3 random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

/// A normal, and the one that a crease of this angle turns it to.
std::pair<glm::dvec3, glm::dvec3> random_crease(double angle_rad, std::mt19937_64& random) {
    const glm::dvec3 axis = random_direction(random);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, random_direction(random)));
    const glm::dvec3 v = glm::cross(axis, u);
    return {u, std::cos(angle_rad) * u + std::sin(angle_rad) * v};
}

/// Normals alone, without rounding, in weights of length 254 each.
buffers::Packer packer() {
    const buffers::Field first{.ranges = {.normal = {254, 0, 0}}};
    const buffers::Field second{.ranges = {.normal = {0, 203.2, -152.4}, .offset = 153},
                                .plane = 1};
    return {{raster::Store::u8, 2, {first, second}},
            buffers::DepthSign::near_high,
            buffers::Quantise::sum,
            raster::Overflow::saturate};
}

struct Missed {
    double by_one = 0;
    double by_two = 0;
};

/// The shares of random creases whose step is below the largest that a facet may cause.
Missed missed(double crease_rad) {
    constexpr int kCreases = 200'000;
    const buffers::Packer codes = packer();
    const double silent = 254 * std::sin(kFacet_rad / 2);
    std::mt19937_64 random(5);
    int one = 0, two = 0;
    for (int i = 0; i < kCreases; ++i) {
        const auto [n0, n1] = random_crease(crease_rad, random);
        const auto is_silent = [&](int plane) {
            return std::abs(codes.at_vertex(plane, 0, n0) - codes.at_vertex(plane, 0, n1)) <=
                   silent;
        };
        one += is_silent(0);
        two += is_silent(0) && is_silent(1);
    }
    return {static_cast<double>(one) / kCreases, static_cast<double>(two) / kCreases};
}

TEST(TwoSums, OrthogonalOnesMissTwoThirdsOfTheSquareOfWhatOneMisses) {
    for (const double crease_deg : {40.0, 60.0, 90.0, 120.0}) {
        const double crease_rad = crease_deg * std::numbers::pi / 180;
        const double share = std::sin(kFacet_rad / 2) / std::sin(crease_rad / 2);
        const Missed creases = missed(crease_rad);
        EXPECT_NEAR(creases.by_one, share, 0.005) << crease_deg;
        EXPECT_NEAR(creases.by_two / (share * share), 2.0 / 3, 0.06) << crease_deg;
    }
}

TEST(TwoSums, DefaultWeightsAreOrthogonalAndFillTheirBytes) {
    const core::ParamValues defaults = find_method("two_sums").complete({});
    double product = 0, first = 0, second = 0;
    for (const char* channel : {"depth", "nx", "ny", "nz"}) {
        const double a = std::stod(defaults.at(std::string("first_") + channel));
        const double b = std::stod(defaults.at(std::string("second_") + channel));
        product += a * b;
        first += std::abs(a);
        second += std::abs(b);
    }
    EXPECT_EQ(product, 0);
    EXPECT_EQ(first, 255);
    EXPECT_EQ(second, 255);
}

}  // namespace
}  // namespace ink::methods
