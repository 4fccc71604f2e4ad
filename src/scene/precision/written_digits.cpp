#include "scene/precision/written_digits.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/box.h"

namespace ink::scene {
namespace {

constexpr int kMostDecimals = 12;
constexpr double kFinest = 0.5;  ///< units of a decimal place: coarser floats do not tell it

/// 1/64 px (scene/precision/weld_tolerance.h) of a scene that is 256 px wide: of what is more, only
/// images smaller than that could make use.
constexpr double kMostWritten = 1.0 / 64 / 256;

float largest_of(const Mesh& mesh) {
    float largest = 0;
    for (const glm::vec3& p : mesh.positions)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return largest;
}

/// The distance of a positive float from the next.
double unit_of(float x) {
    return static_cast<double>(std::nextafter(x, std::numeric_limits<float>::infinity())) -
           static_cast<double>(x);
}

/// Whether `x` is the float nearest to a whole number divided by `scale`, or the one beside: not
/// every reader rounds well (Assimp adds the whole and the fraction as floats).
bool is_written(float x, double scale) {
    return std::abs(x - std::round(x * scale) / scale) <= 1.5 * unit_of(std::abs(x));
}

/// How far a rounding of each coordinate by at most `rounding` may have moved a vertex once the
/// instance is placed, world units.
double most_moved_world(const Instance& instance, double rounding) {
    const glm::dmat4& m = instance.world_from_object;
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    // Of the box that a point may have been rounded in, one of the corners is the farthest off.
    return rounding * std::max({glm::length(x + y + z),
                                glm::length(x + y - z),
                                glm::length(x - y + z),
                                glm::length(x - y - z)});
}

}  // namespace

double written_rounding(const Mesh& mesh) {
    const float largest = largest_of(mesh);
    if (largest == 0) return 0;
    const double unit = unit_of(largest);
    if (unit >= kFinest) return 0;
    int decimals = 0;
    double scale = 1;
    for (const glm::vec3& p : mesh.positions) {
        for (const float x : {p.x, p.y, p.z}) {
            while (!is_written(x, scale)) {
                scale = std::pow(10.0, ++decimals);
                if (decimals > kMostDecimals || unit * scale >= kFinest) return 0;
            }
        }
    }
    return 0.5 / scale;
}

std::vector<double> written_roundings(const Scene& scene, std::span<const glm::dvec3> p_world) {
    const double most = kMostWritten * box_of(p_world).diagonal();
    std::vector<double> of_mesh(scene.meshes.size());
    std::ranges::transform(scene.meshes, of_mesh.begin(), written_rounding);
    std::vector<double> of_object;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const double moved = most_moved_world(instance, of_mesh[instance.mesh]);
        if (moved == 0 || moved > most) continue;
        of_object.resize(scene.instances.size(), 0);
        of_object[i] = moved;
    }
    return of_object;
}

}  // namespace ink::scene
