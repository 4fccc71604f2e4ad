#include "scene/scene_statistics.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

#include "scene/box.h"
#include "scene/components.h"
#include "scene/near_points.h"
#include "scene/precision/weld_tolerance.h"

namespace ink::scene {
namespace {

constexpr double kNearShare = 1e-2;  ///< of the radius: two parallel faces this near are near
constexpr double kSteps = 8192;      // of a normal's component
constexpr std::size_t kNeighbours = 8;

/// A face by the plane it lies in; opposite normals are one direction.
struct Sheet {
    std::array<int, 3> direction{};
    double offset = 0;
    const Face* face = nullptr;
    std::uint32_t component = 0;
};

Sheet sheet_of(const Topology& topology, std::uint32_t f, std::uint32_t component) {
    glm::dvec3 n = glm::normalize(topology.area_vector(f));
    Sheet sheet;
    sheet.face = &topology.faces[f];
    sheet.component = component;
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
    sheet.offset = glm::dot(rounded, topology.p_world[sheet.face->vertices[0]]);
    return sheet;
}

/// Whether the boxes of two faces share an area, the axis along which they look left out.
bool stand_before_each_other(const Topology& topology, const Sheet& a, const Sheet& b) {
    const auto most = std::ranges::max_element(a.direction, {}, [](int d) { return std::abs(d); });
    const auto box = [&](const Face& face) {
        Box of_face;
        for (const std::uint32_t v : face.vertices)
            of_face.add(topology.p_world[v]);
        return of_face;
    };
    const Box box_a = box(*a.face), box_b = box(*b.face);
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == most - a.direction.begin()) continue;
        const double low = std::max(box_a.low[axis], box_b.low[axis]);
        if (!(low < std::min(box_a.high[axis], box_b.high[axis]))) return false;
    }
    return true;
}

/// Pairs of faces of two components, parallel within about 1e-4 rad, whose boxes share an
/// area when one is slid onto the other's plane, and whose planes are within kNearShare of
/// `radius`. Each face is only held against the eight nearest of its direction, so that a heap of
/// sheets costs O(n log n): `pairs` is a lower bound, the least gap is that of neighbours.
NearSheets find_near_sheets(const Topology& topology, const Components& components, double radius) {
    std::vector<Sheet> sheets;
    sheets.reserve(topology.faces.size());
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f)
        sheets.push_back(sheet_of(topology, f, components.component_of[f]));
    std::ranges::sort(
        sheets, {}, [](const Sheet& a) { return std::tie(a.direction, a.offset, a.face); });
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

constexpr std::size_t kMostPairs = 1'000'000;

double length_of(const Topology& topology, const Edge& edge) {
    return glm::length(topology.p_world[edge.b] - topology.p_world[edge.a]);
}

void add(EdgeTally& tally, double length_world) {
    ++tally.count;
    tally.length_world += length_world;
}

void add_deviation(SceneStatistics& statistics, double deviation) {
    const double bin_rad = std::numbers::pi / kDeviationBins;
    const auto bin = std::min(kDeviationBins - 1, static_cast<int>(deviation / bin_rad));
    ++statistics.deviations[static_cast<std::size_t>(bin)];
}

void add_pair_edge(const Topology& topology, const Edge& edge, SceneStatistics& statistics) {
    const auto faces = topology.faces_of(edge);
    const Face& face = topology.faces[faces[0]];
    const Face& other = topology.faces[faces[1]];
    const double length_world = length_of(topology, edge);
    const double deviation = deviation_rad(topology, edge, faces[0], faces[1]);
    if (deviation >= statistics.crease_rad) {
        add(statistics.creases, length_world);
        add_deviation(statistics, deviation);
        const bool is_first = statistics.creases.count == 1;
        statistics.least_crease_rad =
            is_first ? deviation : std::min(statistics.least_crease_rad, deviation);
        return;
    }
    if (face.object != other.object) add(statistics.seams, length_world);
    if (deviation < kFlat_rad) return add(statistics.flat, length_world);
    add(statistics.smooth, length_world);
    add_deviation(statistics, deviation);
    statistics.largest_smooth_rad = std::max(statistics.largest_smooth_rad, deviation);
    if (!is_consistent(topology, edge)) add(statistics.inside_out, length_world);
}

void count_edges(const Topology& topology, SceneStatistics& statistics) {
    for (const Edge& edge : topology.edges) {
        if (edge.face_count == 2) {
            add_pair_edge(topology, edge, statistics);
        } else {
            add(edge.face_count == 1 ? statistics.boundary : statistics.nonmanifold,
                length_of(topology, edge));
        }
    }
    for (const Face& face : topology.faces) {
        statistics.loose_triangles += std::ranges::all_of(
            face.edges, [&](auto e) { return topology.edges[e].face_count == 1; });
    }
}

std::size_t count_cracked_corners(const Topology& topology) {
    std::vector<glm::dvec3> corners;
    std::vector<bool> is_taken(topology.p_world.size(), false);
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 1) continue;
        for (const std::uint32_t v : {edge.a, edge.b}) {
            if (!is_taken[v]) corners.push_back(topology.p_world[v]);
            is_taken[v] = true;
        }
    }
    if (corners.empty()) return 0;
    std::vector<std::uint32_t> all(corners.size());
    std::iota(all.begin(), all.end(), 0U);
    NearPoints near(corners);
    near.add(all, kCrackShare * box_of(corners).diagonal());
    std::vector<glm::dvec3> places = near.representatives();
    // Both sides of a crack count: all but those that stayed alone at their place.
    std::ranges::sort(places, {}, [](const glm::dvec3& p) { return std::tie(p.x, p.y, p.z); });
    std::size_t cracked = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        cracked += (i > 0 && places[i] == places[i - 1]) ||
                   (i + 1 < places.size() && places[i] == places[i + 1]);
    }
    return cracked;
}

/// Half the diagonal of each object's own box, the largest over the smallest that is not 0.
double extent_ratio(const Topology& topology) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Box& box : object_boxes(topology)) {
        if (box.is_empty()) continue;
        const double size = box.diagonal();
        least = std::min(least, size);
        most = std::max(most, size);
    }
    return most > 0 ? most / least : 1;
}

/// Share of the length of lines (edges that are neither smooth nor flat) that components have which
/// are thinner than `least`. Area over length of lines: a bar of four sides is as wide as that.
double thin_share(const Topology& topology,
                  const Components& components,
                  double crease_rad,
                  double least) {
    struct Size {
        double area = 0, lines = 0;
    };
    std::vector<Size> sizes(components.components.size());
    for (std::uint32_t f = 0; f < topology.faces.size(); ++f)
        sizes[components.component_of[f]].area += glm::length(topology.area_vector(f)) / 2;
    for (const Edge& edge : topology.edges) {
        const auto faces = topology.faces_of(edge);
        if (edge.face_count != 2 || deviation_rad(topology, edge, faces[0], faces[1]) >= crease_rad)
            sizes[components.component_of[faces[0]]].lines += length_of(topology, edge);
    }
    double thin = 0, all = 0;
    for (const Size& size : sizes) {
        all += size.lines;
        if (size.area < least * size.lines) thin += size.lines;
    }
    return all > 0 ? thin / all : 0;
}

void count_components(const Topology& topology, SceneStatistics& statistics) {
    const Components found = find_components(topology);
    statistics.components = found.components.size();
    for (const Component& component : found.components) {
        statistics.watertight_components += component.is_watertight;
        statistics.convex_components += component.is_convex;
    }
    statistics.overlapping_components = count_overlapping_components(found.components, kMostPairs);
    statistics.thin_share =
        thin_share(topology, found, statistics.crease_rad, kThinShare * statistics.bounds.radius);
    statistics.near_sheets = find_near_sheets(topology, found, statistics.bounds.radius);
}

}  // namespace

SceneStatistics make_scene_statistics(const PreparedScene& scene, double crease_rad) {
    const auto welded = scene.topology();
    const Topology& topology = *welded;
    SceneStatistics statistics;
    statistics.crease_rad = crease_rad;
    statistics.triangles = topology.faces.size();
    statistics.vertices = topology.p_world.size();
    statistics.objects = scene->instances.size();
    statistics.bounds = scene.bounds();
    if (topology.faces.empty()) return statistics;
    std::set<std::uint32_t> materials;
    for (const Face& face : topology.faces)
        materials.insert(face.material);
    statistics.materials = materials.size();
    count_edges(topology, statistics);
    statistics.crease_proposal = propose_crease(topology);
    count_components(topology, statistics);
    statistics.cracked_corners = count_cracked_corners(topology);
    statistics.extent_ratio = extent_ratio(topology);
    return statistics;
}

}  // namespace ink::scene
