#include "crosscheck/edge_probes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/parallel.h"
#include "crosscheck/line_names.h"
#include "crosscheck/screen_segment.h"

namespace ink::crosscheck {
namespace {

constexpr double kSpacing_px = 0.375;
constexpr double kAside_px = 1.0 / 1024;
constexpr double kBeside_px = 0.5;     ///< how far to either side of a visible edge is looked
constexpr double kShortest_px = 1e-6;  ///< an edge that points at the eye has no sides
constexpr std::size_t kChunk = 256;

/// The two samples at one place of an edge.
struct Probe {
    glm::dvec2 p_px{0};
    Sample left, right;
    bool is_line = false;
};

/// Looks along one edge after another.
class Prober {
  public:
    Prober(const SampleCells& cells, const SightRays& rays, EdgeProbes& out)
        : cells_(cells), rays_(rays), mesh_(rays.mesh()), out_(out) {}

    void follow(std::uint32_t edge) {
        edge_ = edge;
        if (!project_edge(mesh_, mesh_.topology().edges[edge], line_)) return;
        const glm::dvec2 along = line_.b - line_.a;
        const double length = glm::length(along);
        if (!(length > kShortest_px)) return;
        aside_ = glm::dvec2(-along.y, along.x) / length;
        count_ = std::max(1, static_cast<int>(std::ceil(length / kSpacing_px)));
        spacing_px_ = length / count_;
        std::optional<Probe> last;
        for (int i = 0; i < count_; ++i) {
            const bool is_hidden = cells_.is_hidden(line_.at(part(i)), line_.q_at(part(i)));
            // Where it comes out or goes under, the hidden place next to it is looked at too.
            if (is_hidden && !(last && last->is_line)) {
                last.reset();
                continue;
            }
            const Probe here = look(i);
            if (here.is_line && !last && i > 0) last = look(i - 1);
            if (last) add_ways(*last, here);
            last = here;
        }
    }

  private:
    [[nodiscard]] double part(int i) const { return (i + 0.5) / count_; }

    Sample look_at(const glm::dvec2& p_px) {
        ++out_.counts.rays;
        return {p_px, rays_.look(p_px)};
    }

    Probe look(int i) {
        Probe probe;
        probe.p_px = line_.at(part(i));
        probe.left = look_at(probe.p_px - kAside_px * aside_);
        probe.right = look_at(probe.p_px + kAside_px * aside_);
        ++out_.counts.probes;
        if (is_joined(mesh_, probe.left, probe.right)) return probe;
        probe.is_line = true;
        add_points(probe);
        if (i % 2 == 0) {
            add_way(probe.left, look_at(probe.p_px - kBeside_px * aside_));
            add_way(probe.right, look_at(probe.p_px + kBeside_px * aside_));
        }
        return probe;
    }

    void add_ways(const Probe& last, const Probe& here) {
        if (!last.is_line && !here.is_line) return;
        add_way(last.left, here.left);
        add_way(last.right, here.right);
    }

    void add_points(const Probe& probe) {
        const Between between = name_between(rays_, probe.left, probe.right);
        out_.counts.defects += between.is_defect;
        out_.counts.near_cuts += between.is_near_cut;
        out_.counts.unexplained += !between.is_explained;
        const glm::ivec2 cell = cells_.cell_of(probe.p_px);
        for (int i = 0; i < between.count; ++i) {
            const NamedLine& line = between.lines[i];
            const bool is_other = line.edge != edge_ && line.edge != kNothing;
            out_.points.push_back(
                {cell, {probe.p_px.x, probe.p_px.y, line.line_class, is_other ? 0 : spacing_px_}});
        }
    }

    void add_way(const Sample& from, const Sample& to) {
        if (!is_joined(mesh_, from, to)) out_.ways.push_back({from, to});
    }

    const SampleCells& cells_;
    const SightRays& rays_;
    const ClipMesh& mesh_;
    EdgeProbes& out_;
    std::uint32_t edge_ = kNothing;
    ScreenSegment line_;
    glm::dvec2 aside_{0};
    int count_ = 0;
    double spacing_px_ = 0;
};

}  // namespace

EdgeProbes probe_edges(const SampleCells& cells, const SightRays& rays, int threads) {
    const ClipMesh& mesh = rays.mesh();
    const std::size_t count = mesh.topology().edges.size();
    std::vector<EdgeProbes> parts((count + kChunk - 1) / kChunk);
    core::parallel_for(parts.size(), threads, [&](std::size_t chunk) {
        Prober prober(cells, rays, parts[chunk]);
        const std::size_t end = std::min(count, (chunk + 1) * kChunk);
        for (std::size_t e = chunk * kChunk; e < end; ++e) {
            const auto edge = static_cast<std::uint32_t>(e);
            if (mesh.is_feature(edge)) prober.follow(edge);
        }
    });
    EdgeProbes all;
    for (const EdgeProbes& part : parts) {
        all.points.insert(all.points.end(), part.points.begin(), part.points.end());
        all.ways.insert(all.ways.end(), part.ways.begin(), part.ways.end());
        all.counts += part.counts;
    }
    return all;
}

}  // namespace ink::crosscheck
