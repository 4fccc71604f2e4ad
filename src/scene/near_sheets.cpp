#include "scene/near_sheets.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

namespace ink::scene {
namespace {

constexpr double kSteps = 8192;  // of a normal's component
constexpr std::size_t kNeighbours = 8;

/// A face by the plane it lies in; opposite normals are one direction.
struct Sheet {
    std::array<int, 3> direction{};
    double offset = 0;
    const Face* face = nullptr;
    std::uint32_t component = 0;
};

Sheet sheet_of(const Topology& topology, const Face& face) {
    const auto& [a, b, c] = face.vertices;
    const glm::dvec3 p = topology.p_world[a];
    glm::dvec3 n = glm::normalize(glm::cross(topology.p_world[b] - p, topology.p_world[c] - p));
    Sheet sheet;
    sheet.face = &face;
    std::array<int, 3>& d = sheet.direction;
    for (int i = 0; i < 3; ++i)
        d[static_cast<std::size_t>(i)] = static_cast<int>(std::lround(n[i] * kSteps));
    if (d < std::array<int, 3>{0, 0, 0}) {
        for (int& step : d)
            step = -step;
        n = -n;
    }
    // The rounded direction, so that faces of one plane get one offset.
    const glm::dvec3 rounded = glm::normalize(glm::dvec3(d[0], d[1], d[2]));
    sheet.offset = glm::dot(rounded, p);
    return sheet;
}

/// Whether the boxes of two faces share an area, the axis along which they look left out.
bool stand_before_each_other(const Topology& topology, const Sheet& a, const Sheet& b) {
    int view_direction = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(a.direction[static_cast<std::size_t>(i)]) >
            std::abs(a.direction[static_cast<std::size_t>(view_direction)])) {
            view_direction = i;
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == view_direction) continue;
        const auto span = [&](const Face& face) {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (const std::uint32_t v : face.vertices) {
                low = std::min(low, topology.p_world[v][axis]);
                high = std::max(high, topology.p_world[v][axis]);
            }
            return std::pair(low, high);
        };
        const auto [low_a, high_a] = span(*a.face);
        const auto [low_b, high_b] = span(*b.face);
        if (!(std::max(low_a, low_b) < std::min(high_a, high_b))) return false;
    }
    return true;
}

}  // namespace

NearSheets find_near_sheets(const Topology& topology, const Components& components, double radius) {
    std::vector<Sheet> sheets;
    sheets.reserve(topology.faces.size());
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        sheets.push_back(sheet_of(topology, topology.faces[f]));
        sheets.back().component = components.component_of[f];
    }
    std::sort(sheets.begin(), sheets.end(), [](const Sheet& a, const Sheet& b) {
        return std::tie(a.direction, a.offset, a.face) < std::tie(b.direction, b.offset, b.face);
    });
    NearSheets found;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        const std::size_t end = std::min(sheets.size(), i + 1 + kNeighbours);
        for (std::size_t j = i + 1; j < end; ++j) {
            const double gap = sheets[j].offset - sheets[i].offset;
            if (sheets[j].direction != sheets[i].direction || gap > kNearShare * radius) break;
            if (sheets[i].component == sheets[j].component) continue;
            if (!stand_before_each_other(topology, sheets[i], sheets[j])) continue;
            ++found.pairs;
            least = std::min(least, gap);
        }
    }
    if (found.pairs > 0) found.least_gap_share = radius > 0 ? least / radius : 0;
    return found;
}

}  // namespace ink::scene
