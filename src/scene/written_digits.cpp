#include "scene/written_digits.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ink::scene {
namespace {

constexpr int kMostDecimals = 12;

float largest_of(const Mesh& mesh) {
    float largest = 0;
    for (const glm::vec3& p : mesh.positions)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return largest;
}

/// Whether `x` is the float nearest to a whole number divided by `scale`.
bool is_written(float x, double scale) {
    return static_cast<float>(std::round(x * scale) / scale) == x;
}

}  // namespace

double written_rounding(const Mesh& mesh) {
    const float largest = largest_of(mesh);
    if (largest == 0) return 0;
    const double unit =
        static_cast<double>(std::nextafter(largest, std::numeric_limits<float>::infinity())) -
        static_cast<double>(largest);
    if (unit >= 1) return 0;
    int decimals = 0;
    double scale = 1;
    for (const glm::vec3& p : mesh.positions) {
        for (const float x : {p.x, p.y, p.z}) {
            while (!is_written(x, scale)) {
                scale = std::pow(10.0, ++decimals);
                if (decimals > kMostDecimals || unit * scale >= 1) return 0;
            }
        }
    }
    return 0.5 / scale;
}

double most_moved_world(const Instance& instance, double rounding) {
    const glm::dmat4& m = instance.world_from_object;
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    // Of the box that a point may have been rounded in, one of the corners is the farthest off.
    return rounding * std::max({glm::length(x + y + z),
                                glm::length(x + y - z),
                                glm::length(x - y + z),
                                glm::length(x - y - z)});
}

}  // namespace ink::scene
