#include "crosscheck/edge_probes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "core/parallel.h"
#include "crosscheck/clip_mesh.h"
#include "crosscheck/line_names.h"

namespace ink::crosscheck {
namespace {

/// A line on the image with q = 1/w at its ends; between them q is linear in px.
struct ScreenSegment {
    glm::dvec2 a{0}, b{0};
    double q_a = 0, q_b = 0;

    [[nodiscard]] glm::dvec2 at(double s) const { return a + s * (b - a); }
    [[nodiscard]] double q_at(double s) const { return q_a + s * (q_b - q_a); }
};

/// A stretch of a segment.
struct Range {
    double begin = 0, end = 1;
    [[nodiscard]] bool is_empty() const { return begin > end; }
};

/// Where a + s (b - a) lies between low and high, within `range`.
Range clip(Range range, double a, double b, double low, double high) {
    if (a == b) return a >= low && a <= high ? range : Range{1, 0};
    const auto [first, last] = std::minmax({(low - a) / (b - a), (high - a) / (b - a)});
    return {std::max(range.begin, first), std::min(range.end, last)};
}

/// The part of a mesh edge that lies beyond the near plane and inside the image; false if there is
/// none.
bool project_edge(const ClipMesh& mesh, const scene::Edge& edge, ScreenSegment& segment) {
    glm::dvec3 a = mesh.p_clip()[edge.a], b = mesh.p_clip()[edge.b];
    const double near = mesh.view().camera.near;
    if (a.z < near && b.z < near) return false;
    const glm::dvec3 cut = a + (b - a) * ((near - a.z) / (b.z - a.z));
    if (a.z < near) a = cut;
    if (b.z < near) b = cut;
    const ScreenSegment all{glm::dvec2(a) / a.z, glm::dvec2(b) / b.z, 1 / a.z, 1 / b.z};
    Range inside = clip({}, all.a.x, all.b.x, 0, mesh.view().width_px);
    inside = clip(inside, all.a.y, all.b.y, 0, mesh.view().height_px);
    if (inside.is_empty()) return false;
    segment = {
        all.at(inside.begin), all.at(inside.end), all.q_at(inside.begin), all.q_at(inside.end)};
    return true;
}

constexpr double kSpacing_px = 0.375;
constexpr double kAside_px = 1.0 / 1024;
constexpr double kBeside_px = 0.5;     ///< how far to either side of a visible edge is looked
constexpr double kShortest_px = 1e-6;  ///< an edge that points at the eye has no sides
constexpr std::size_t kProbesOfChunk = 256;
constexpr std::size_t kPlaces = 1024;  ///< looked at together: what fits the cache

/// One place of an edge: the samples at both sides of it, and those farther off where it shows a
/// line and is one of every other.
struct Probe {
    glm::dvec2 p_px{0};
    Sample left, right;
    bool is_line = false;
    Sample far_left, far_right;
};

/// An edge on the image and which of its places are not hidden.
struct ProbedEdge {
    std::uint32_t edge = kNothing;
    ScreenSegment line;
    glm::dvec2 aside{0};  ///< unit
    int count = 0;        ///< of places
    double spacing_px = 0;
    std::size_t first = 0;  ///< into the places that are not hidden

    [[nodiscard]] double part(int i) const { return (i + 0.5) / count; }
};

/// Looks along one edge after another. First at all that is not hidden, many places together, as
/// that is quicker; then it goes along.
class Prober {
  public:
    Prober(const SampleCells& cells, const SightRays& rays, EdgeProbes& out)
        : cells_(cells), rays_(rays), mesh_(rays.mesh()), out_(out) {}

    void add(std::uint32_t edge) {
        ProbedEdge probed;
        probed.edge = edge;
        if (!project_edge(mesh_, mesh_.topology().edges[edge], probed.line)) return;
        const glm::dvec2 along = probed.line.b - probed.line.a;
        const double length = glm::length(along);
        if (!(length > kShortest_px)) return;
        probed.aside = glm::dvec2(-along.y, along.x) / length;
        probed.count = std::max(1, static_cast<int>(std::ceil(length / kSpacing_px)));
        probed.spacing_px = length / probed.count;
        probed.first = is_hidden_.size();
        edges_.push_back(probed);
        for (int i = 0; i < probed.count; ++i) {
            const double s = probed.part(i);
            is_hidden_.push_back(cells_.is_hidden(probed.line.at(s), probed.line.q_at(s)));
        }
    }

    /// Whether so many places are added that it is time to follow their edges.
    [[nodiscard]] bool is_full() const { return is_hidden_.size() >= kPlaces; }

    /// Follows the edges added since the last time.
    void follow_all() {
        look_ahead();
        for (const ProbedEdge& edge : edges_)
            follow(edge);
        edges_.clear();
        is_hidden_.clear();
        probes_.clear();
    }

  private:
    void follow(const ProbedEdge& edge) {
        edge_ = &edge;
        std::optional<Probe> last;
        for (int i = 0; i < edge.count; ++i) {
            // Where it comes out or goes under, the hidden place next to it is looked at too.
            if (is_hidden(edge, i) && !(last && last->is_line)) {
                last.reset();
                continue;
            }
            const Probe here = look(i);
            if (here.is_line && !last && i > 0) last = look(i - 1);
            if (last) add_ways(*last, here);
            last = here;
        }
    }

    [[nodiscard]] bool is_hidden(const ProbedEdge& edge, int i) const {
        return is_hidden_[edge.first + static_cast<std::size_t>(i)];
    }

    /// Takes the samples of all places that are not hidden.
    void look_ahead() {
        probe_of_.resize(is_hidden_.size());
        samples_.clear();
        for (const ProbedEdge& edge : edges_) {
            for (int i = 0; i < edge.count; ++i) {
                if (is_hidden(edge, i)) continue;
                probe_of_[edge.first + static_cast<std::size_t>(i)] = probes_.size();
                probes_.push_back(aimed(edge, i));
                samples_.push_back(probes_.back().left);
                samples_.push_back(probes_.back().right);
            }
        }
        look_at_all(rays_, samples_);
        for (std::size_t i = 0; i < probes_.size(); ++i) {
            probes_[i].left = samples_[2 * i];
            probes_[i].right = samples_[2 * i + 1];
        }
        look_aside();
    }

    /// Takes those farther off.
    void look_aside() {
        lines_.clear();
        samples_.clear();
        for (const ProbedEdge& edge : edges_) {
            for (int i = 0; i < edge.count; ++i) {
                if (is_hidden(edge, i)) continue;
                Probe& probe = probes_[probe_of_[edge.first + static_cast<std::size_t>(i)]];
                probe.is_line = !is_joined(mesh_, probe.left, probe.right);
                if (!probe.is_line || i % 2 != 0) continue;
                lines_.push_back(&probe);
                samples_.push_back(probe.far_left);
                samples_.push_back(probe.far_right);
            }
        }
        look_at_all(rays_, samples_);
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            lines_[i]->far_left = samples_[2 * i];
            lines_[i]->far_right = samples_[2 * i + 1];
        }
    }

    /// A place that has not been looked at yet.
    static Probe aimed(const ProbedEdge& edge, int i) {
        Probe probe;
        probe.p_px = edge.line.at(edge.part(i));
        probe.left.p_px = probe.p_px - kAside_px * edge.aside;
        probe.right.p_px = probe.p_px + kAside_px * edge.aside;
        probe.far_left.p_px = probe.p_px - kBeside_px * edge.aside;
        probe.far_right.p_px = probe.p_px + kBeside_px * edge.aside;
        return probe;
    }

    /// The same of one place that is hidden.
    [[nodiscard]] Probe look_at_hidden(int i) const {
        Probe probe = aimed(*edge_, i);
        probe.left.sight = rays_.look(probe.left.p_px);
        probe.right.sight = rays_.look(probe.right.p_px);
        probe.is_line = !is_joined(mesh_, probe.left, probe.right);
        if (probe.is_line && i % 2 == 0) {
            probe.far_left.sight = rays_.look(probe.far_left.p_px);
            probe.far_right.sight = rays_.look(probe.far_right.p_px);
        }
        return probe;
    }

    Probe look(int i) {
        const std::size_t place = edge_->first + static_cast<std::size_t>(i);
        const Probe probe = is_hidden_[place] ? look_at_hidden(i) : probes_[probe_of_[place]];
        out_.counts.rays += 2;
        ++out_.counts.probes;
        if (!probe.is_line) return probe;
        add_points(probe);
        if (i % 2 == 0) {
            out_.counts.rays += 2;
            add_way(probe.left, probe.far_left);
            add_way(probe.right, probe.far_right);
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
            const bool is_other = line.edge != edge_->edge && line.edge != kNothing;
            out_.points.push_back(
                {cell,
                 {probe.p_px.x, probe.p_px.y, line.line_class, is_other ? 0 : edge_->spacing_px}});
        }
    }

    void add_way(const Sample& from, const Sample& to) {
        if (!is_joined(mesh_, from, to)) out_.ways.push_back({from, to});
    }

    const SampleCells& cells_;
    const SightRays& rays_;
    const ClipMesh& mesh_;
    EdgeProbes& out_;
    std::vector<ProbedEdge> edges_;
    std::vector<bool> is_hidden_;        ///< per place
    std::vector<std::size_t> probe_of_;  ///< per place that is not hidden, into probes_
    std::vector<Probe> probes_;
    std::vector<Sample> samples_;  ///< looked at together
    std::vector<Probe*> lines_;    ///< probes that are looked aside from
    const ProbedEdge* edge_ = nullptr;
};

}  // namespace

EdgeProbes probe_edges(const SampleCells& cells, const SightRays& rays, int threads) {
    const ClipMesh& mesh = rays.mesh();
    const std::size_t count = mesh.topology().edges.size();
    const auto probe = [&](std::size_t begin, std::size_t end, EdgeProbes& part) {
        Prober prober(cells, rays, part);
        for (std::size_t e = begin; e < end; ++e) {
            const auto edge = static_cast<std::uint32_t>(e);
            if (mesh.is_feature(edge)) prober.add(edge);
            if (prober.is_full()) prober.follow_all();
        }
        prober.follow_all();
    };
    EdgeProbes all;
    for (const EdgeProbes& part :
         core::parallel_parts<EdgeProbes>(count, kProbesOfChunk, threads, probe)) {
        all.points.insert(all.points.end(), part.points.begin(), part.points.end());
        all.ways.insert(all.ways.end(), part.ways.begin(), part.ways.end());
        all.counts += part.counts;
    }
    return all;
}

}  // namespace ink::crosscheck
