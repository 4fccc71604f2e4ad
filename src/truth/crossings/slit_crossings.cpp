#include "truth/crossings/crossings.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "scene/box.h"
#include "truth/crossings/continuation.h"

namespace ink::truth {
namespace {

constexpr double kShortestSlit = 8;  ///< tolerances; a shorter part only ends at borders
constexpr int kHalvings = 60;

double distance_to_edge(const scene::Topology& topology, std::uint32_t e, const glm::dvec3& p) {
    const scene::Edge& edge = topology.edges[e];
    return scene::distance_to_segment(p, topology.p_world[edge.a], topology.p_world[edge.b]);
}

/// A part of a crossing: begin + t (end - begin), t_begin <= t <= t_end.
struct Part {
    double t_begin = 0;
    double t_end = 0;
    [[nodiscard]] double length() const { return t_end - t_begin; }
};

glm::dvec3 point_of(const Crossing& crossing, double t) {
    return crossing.begin_world + t * (crossing.end_world - crossing.begin_world);
}

/// The part of a crossing within `reach` of an edge; empty where the edge is no border. The
/// distance of a point that moves straight on from a segment is a convex function: the part is one
/// stretch.
Part part_beside(const scene::Topology& topology,
                 std::uint32_t e,
                 const Crossing& crossing,
                 double reach) {
    if (topology.edges[e].face_count != 1) return {};
    const auto distance = [&](double t) {
        return distance_to_edge(topology, e, point_of(crossing, t));
    };
    const double at_begin = distance(0), at_end = distance(1);
    if (at_begin <= reach && at_end <= reach) return {0, 1};
    const double length = glm::length(crossing.end_world - crossing.begin_world);
    if ((at_begin + at_end - length) / 2 > reach) return {};
    double low = 0, high = 1;
    for (int i = 0; i < kHalvings; ++i) {
        const double t0 = low + (high - low) / 3, t1 = high - (high - low) / 3;
        if (distance(t0) < distance(t1)) {
            high = t1;
        } else {
            low = t0;
        }
    }
    const double nearest = at_begin <= reach ? 0 : at_end <= reach ? 1 : (low + high) / 2;
    if (distance(nearest) > reach) return {};
    /// Where it comes within reach on the way from `out`, which is beyond it, to the nearest.
    const auto change = [&](double out) {
        double in = nearest;
        for (int i = 0; i < kHalvings; ++i)
            (distance((in + out) / 2) <= reach ? in : out) = (in + out) / 2;
        return in;
    };
    return {at_begin <= reach ? 0 : change(0), at_end <= reach ? 1 : change(1)};
}

/// Where on the line of a crossing a point of an edge lies, 0 at its begin and 1 at its end.
double parameter_of(const Crossing& crossing,
                    const scene::Topology& topology,
                    std::uint32_t e,
                    double t) {
    const scene::Edge& edge = topology.edges[e];
    const glm::dvec3 p = glm::mix(topology.p_world[edge.a], topology.p_world[edge.b], t);
    const glm::dvec3 along = crossing.end_world - crossing.begin_world;
    return glm::dot(p - crossing.begin_world, along) / glm::dot(along, along);
}

/// The longest of some stretches, joined where they leave less than `gap` between them.
Part longest_of(std::vector<Part> stretches, double gap) {
    std::ranges::sort(stretches, {}, &Part::t_begin);
    Part longest, run;
    for (const Part& next : stretches) {
        if (run.length() > 0 && next.t_begin - run.t_end < gap) {
            run.t_end = std::max(run.t_end, next.t_end);
        } else {
            run = next;
        }
        if (run.length() > longest.length()) longest = run;
    }
    return longest;
}

/// The longest part of the crossing that runs within two tolerances of a border of either face,
/// beyond which the surface goes on in the same object.
Part slit(const scene::Topology& topology,
          std::span<const Continuation> continuations,
          std::span<const double> tolerances,
          const Crossing& crossing) {
    const std::uint32_t object = topology.faces[crossing.face0].object;
    if (object != topology.faces[crossing.face1].object) return {};
    const double reach = 2 * tolerances[object];
    const double length = glm::length(crossing.end_world - crossing.begin_world);
    Part longest;
    for (const std::uint32_t f : {crossing.face0, crossing.face1}) {
        for (const std::uint32_t e : topology.faces[f].edges) {
            const Part beside = part_beside(topology, e, crossing, reach);
            if (beside.length() <= longest.length()) continue;
            std::vector<Part> stretches;
            for (const Continuation& c : continuations_of(continuations, e)) {
                if (topology.faces[c.face].object != object) continue;
                const auto [low, high] =
                    std::minmax({parameter_of(crossing, topology, e, c.t_begin),
                                 parameter_of(crossing, topology, e, c.t_end)});
                const Part part{std::max(low, beside.t_begin), std::min(high, beside.t_end)};
                if (part.length() > 0) stretches.push_back(part);
            }
            const Part part = longest_of(std::move(stretches), kShortestSlit * reach / length);
            if (part.length() > longest.length()) longest = part;
        }
    }
    return longest;
}

/// How far a crossing runs from the nearest border of a face.
double distance_to_border(const scene::Topology& topology,
                          const scene::Face& face,
                          const Crossing& crossing) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t e : face.edges) {
        if (topology.edges[e].face_count != 1) continue;
        least = std::min(least,
                         std::max(distance_to_edge(topology, e, crossing.begin_world),
                                  distance_to_edge(topology, e, crossing.end_world)));
    }
    return least;
}

}  // namespace

void mark_slit_crossings(const scene::Topology& topology,
                         std::span<const Continuation> continuations,
                         std::span<const double> tolerances,
                         std::vector<Crossing>& crossings) {
    std::vector<Crossing> result;
    result.reserve(crossings.size());
    for (const Crossing& crossing : crossings) {
        Part part = slit(topology, continuations, tolerances, crossing);
        const double length = glm::length(crossing.end_world - crossing.begin_world);
        const double shortest =
            kShortestSlit * tolerances[topology.faces[crossing.face0].object] / length;
        if (part.length() > 0 && part.t_begin < shortest) part.t_begin = 0;
        if (part.length() > 0 && part.t_end > 1 - shortest) part.t_end = 1;
        const bool is_whole = part.t_begin == 0 && part.t_end == 1;
        if (!is_whole && !(part.length() > shortest)) {
            result.push_back(crossing);
            continue;
        }
        const auto add = [&](double t_begin, double t_end) -> Crossing& {
            Crossing& piece = result.emplace_back(crossing);
            if (t_begin > 0) piece.begin_world = point_of(crossing, t_begin);
            if (t_end < 1) piece.end_world = point_of(crossing, t_end);
            return piece;
        };
        if (part.t_begin > 0) add(0, part.t_begin);
        Crossing& beside = add(part.t_begin, part.t_end);
        beside.slit_world =
            std::min(distance_to_border(topology, topology.faces[crossing.face0], beside),
                     distance_to_border(topology, topology.faces[crossing.face1], beside));
        if (part.t_end < 1) add(part.t_end, 1);
    }
    crossings = std::move(result);
}

}  // namespace ink::truth
