#include "truth/trace_lines.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>
#include <optional>
#include <string>

#include "core/parallel.h"
#include "scene/topology.h"
#include "truth/touching.h"
#include "truth/visibility.h"

namespace ink::truth {
namespace {

constexpr double kSpacing_px = 1.0 / 4;     ///< samples are at most this far apart
constexpr double kBisected_px = 1.0 / 512;  ///< a change lies in an interval no longer than this

// The first and last sample stand this far inside: at a vertex itself many faces touch the point,
// and whether one of them hides it says nothing about the line.
constexpr double kInset_px = 1.0 / 1024;

constexpr std::size_t kChunk = 64;  ///< edges or crossings a task

/// What can change along a line. `plain`: visible, and not a contour.
enum class State : std::uint8_t { hidden, plain, against_sky, against_other, against_self };

/// A segment in the world: a mesh edge, or a crossing of two faces.
struct Segment {
    std::uint32_t edge = kNoEdge;        ///< kNoEdge for a crossing
    const Crossing* crossing = nullptr;  ///< null for an edge
    glm::dvec3 a_world{0}, b_world{0};
    glm::dvec3 a_clip{0}, b_clip{0};
};

/// A stretch of a segment inside the picture, parameterised by s in 0..1, uniform on the screen.
struct ScreenLine {
    Segment segment;
    LineClass line_class = LineClass::none;
    double t_begin = 0, t_end = 1;  ///< parameters on the segment
    double w_begin = 0, w_end = 0;
    glm::dvec2 begin_px{0}, end_px{0};
    double length_px = 0;

    /// The parameter on the segment s of the way along on the screen: 1/w is linear in s.
    [[nodiscard]] double segment_parameter(double s) const {
        const double along = s * w_begin / ((1 - s) * w_end + s * w_begin);
        return t_begin + along * (t_end - t_begin);
    }
    [[nodiscard]] LinePoint line_point(double s) const {
        const double t = segment_parameter(s);
        return {segment.edge,
                segment.a_world + t * (segment.b_world - segment.a_world),
                w_at(s),
                segment.crossing};
    }
    [[nodiscard]] double w_at(double s) const {
        return w_begin * w_end / ((1 - s) * w_end + s * w_begin);
    }
    [[nodiscard]] CurvePoint point_at(double s) const {
        return {begin_px.x + s * (end_px.x - begin_px.x),
                begin_px.y + s * (end_px.y - begin_px.y),
                w_at(s)};
    }
};

/// Keeps of [t0, t1] the part where the linear function with these end values is not negative.
/// False if nothing is left (Liang and Barsky 1984).
bool clip_to_positive(double at_0, double at_1, double& t0, double& t1) {
    if (at_0 >= 0 && at_1 >= 0) return true;
    if (at_0 < 0 && at_1 < 0) return false;
    const double root = at_0 / (at_0 - at_1);
    if (at_0 < 0) {
        t0 = std::max(t0, root);
    } else {
        t1 = std::min(t1, root);
    }
    return t0 < t1;
}

std::optional<ScreenLine> clip(const EyeView& eye,
                               const Segment& segment,
                               const ClassStretch& stretch) {
    const glm::dvec3& a = segment.a_clip;
    const glm::dvec3& b = segment.b_clip;
    double t0 = stretch.t_begin, t1 = stretch.t_end;
    const double width = eye.width_px, height = eye.height_px;
    if (!clip_to_positive(a.z - eye.near, b.z - eye.near, t0, t1) ||
        !clip_to_positive(a.x, b.x, t0, t1) ||
        !clip_to_positive(width * a.z - a.x, width * b.z - b.x, t0, t1) ||
        !clip_to_positive(a.y, b.y, t0, t1) ||
        !clip_to_positive(height * a.z - a.y, height * b.z - b.y, t0, t1)) {
        return std::nullopt;
    }
    const glm::dvec3 begin = t0 == 0 ? a : a + t0 * (b - a);
    const glm::dvec3 end = t1 == 1 ? b : a + t1 * (b - a);
    ScreenLine line{
        .segment = segment, .line_class = stretch.line_class, .t_begin = t0, .t_end = t1};
    line.w_begin = begin.z;
    line.w_end = end.z;
    line.begin_px = glm::dvec2(begin) / begin.z;
    line.end_px = glm::dvec2(end) / end.z;
    line.length_px = std::hypot(line.end_px.x - line.begin_px.x, line.end_px.y - line.begin_px.y);
    return line;
}

/// Follows one line and notes its visible pieces.
class LineTracer {
  public:
    LineTracer(const EyeView& eye, const Visibility& visibility, TracedLines& out)
        : eye_(eye), visibility_(visibility), out_(out) {}

    void trace(const ScreenLine& line) {
        line_ = &line;
        blocker_ = kNoFace;
        const double inset = std::min(0.25, kInset_px / line.length_px);
        const int steps = std::max(1, static_cast<int>(std::ceil(line.length_px / kSpacing_px)));
        double s = line.length_px <= kBisected_px ? 0.5 : inset;
        State state = state_at(s);
        begin_s_ = 0;
        for (int i = 1; i <= steps && line.length_px > kBisected_px; ++i) {
            const double next_s = i == steps ? 1 - inset : static_cast<double>(i) / steps;
            const State next = state_at(next_s);
            bisect(s, state, next_s, next);
            s = next_s;
            state = next;
        }
        emit(begin_s_, 1, state);
    }

  private:
    State state_at(double s) {
        const LinePoint point = line_->line_point(s);
        ++out_.samples;
        if (!visibility_.is_visible(point, blocker_, out_.rays)) return State::hidden;
        if (line_->line_class != LineClass::contour) return State::plain;
        switch (visibility_.kind_behind(point, out_.rays)) {
            case ContourKind::other_object:
                return State::against_other;
            case ContourKind::self:
                return State::against_self;
            default:
                return State::against_sky;
        }
    }

    /// Finds every change of state that halving meets between two samples.
    void bisect(double low, State at_low, double high, State at_high) {
        while (at_low != at_high) {
            double near_end = low, far_end = high;
            State beyond = at_high;
            while ((far_end - near_end) * line_->length_px > kBisected_px) {
                const double middle = near_end + (far_end - near_end) / 2;
                const State state = state_at(middle);
                if (state == at_low) {
                    near_end = middle;
                } else {
                    far_end = middle;
                    beyond = state;
                }
            }
            const double change = near_end + (far_end - near_end) / 2;
            emit(begin_s_, change, at_low);
            begin_s_ = change;
            low = far_end;
            at_low = beyond;
        }
    }

    void emit(double begin, double end, State state) {
        if (state == State::hidden) return;
        Curve curve;
        curve.line_class = line_->line_class;
        curve.edge = line_->segment.edge;
        if (const Crossing* crossing = line_->segment.crossing) {
            curve.face0 = crossing->face0;
            curve.face1 = crossing->face1;
        }
        curve.kind = state == State::against_sky     ? ContourKind::sky
                     : state == State::against_other ? ContourKind::other_object
                     : state == State::against_self  ? ContourKind::self
                                                     : ContourKind::none;
        curve.begin = line_->point_at(begin);
        curve.end = line_->point_at(end);
        curve.bend_rad = line_->segment.crossing != nullptr ? bend_of_crossing()
                                                            : bend(begin + (end - begin) / 2);
        out_.curves.push_back(curve);
    }

    /// How far the two seen faces deviate from flat; of a contour its first two faces.
    [[nodiscard]] float bend(double s) const {
        const scene::Topology& topology = eye_.model.topology;
        const std::uint32_t e = line_->segment.edge;
        const scene::Edge& edge = topology.edges[e];
        const bool is_outline =
            line_->line_class == LineClass::contour || line_->line_class == LineClass::boundary;
        if (eye_.model.is_touched[e] != 0 && !is_outline) {
            return static_cast<float>(seen_bend_rad(eye_, e, line_->segment_parameter(s)));
        }
        if (edge.face_count < 2) return 0;
        const SeenFaces seen = eye_.seen_faces(edge);
        if (seen.left == kNoFace || seen.right == kNoFace) {
            const auto faces = topology.faces_of(edge);
            return static_cast<float>(scene::bend_rad(topology, edge, faces[0], faces[1]));
        }
        return static_cast<float>(scene::bend_rad(topology, edge, seen.left, seen.right));
    }

    /// The same of a crossing. One face is seen on either side, both from where the eye is, so it
    /// is the angle between the normals that face the eye.
    [[nodiscard]] float bend_of_crossing() const {
        const Crossing& crossing = *line_->segment.crossing;
        const auto& p = eye_.model.topology.p_world;
        const auto normal_of = [&](std::uint32_t f) {
            const auto& v = eye_.model.topology.faces[f].vertices;
            return glm::cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]) *
                   static_cast<double>(eye_.facing[f]);
        };
        const glm::dvec3 n0 = normal_of(crossing.face0), n1 = normal_of(crossing.face1);
        return static_cast<float>(std::atan2(glm::length(glm::cross(n0, n1)), glm::dot(n0, n1)));
    }

    const EyeView& eye_;
    const Visibility& visibility_;
    TracedLines& out_;
    const ScreenLine* line_ = nullptr;
    std::uint32_t blocker_ = kNoFace;
    double begin_s_ = 0;
};

std::vector<std::uint32_t> feature_edges(const EyeView& eye) {
    std::vector<std::uint32_t> edges;
    for (std::uint32_t e = 0; e < eye.edge_class.size(); ++e) {
        if (eye.edge_class[e] != LineClass::none || eye.model.is_touched[e] != 0) {
            edges.push_back(e);
        }
    }
    return edges;
}

/// A face seen edge-on has no sides, so a crossing with it is none.
std::vector<const Crossing*> seen_crossings(const EyeView& eye) {
    std::vector<const Crossing*> crossings;
    for (const Crossing& crossing : eye.model.crossings.segments) {
        if (eye.facing[crossing.face0] != 0 && eye.facing[crossing.face1] != 0) {
            crossings.push_back(&crossing);
        }
    }
    return crossings;
}

Segment segment_of(const EyeView& eye, std::uint32_t e) {
    const scene::Edge& edge = eye.model.topology.edges[e];
    const auto& p = eye.model.topology.p_world;
    return {e, nullptr, p[edge.a], p[edge.b], eye.p_clip[edge.a], eye.p_clip[edge.b]};
}

Segment segment_of(const EyeView& eye, const Crossing& crossing) {
    const glm::dvec3 &a = crossing.begin_world, &b = crossing.end_world;
    return {kNoEdge, &crossing, a, b, eye.projection.to_clip(a), eye.projection.to_clip(b)};
}

/// What the tasks share.
struct Tracing {
    const EyeView& eye;
    const Visibility& visibility;
    std::vector<std::uint32_t> edges;
    std::vector<const Crossing*> crossings;
};

/// Traces the edges, then the crossings, numbered through, from `begin` to `end`.
TracedLines trace_chunk(const Tracing& tracing, std::size_t begin, std::size_t end) {
    TracedLines out;
    LineTracer tracer(tracing.eye, tracing.visibility, out);
    for (std::size_t i = begin; i < end; ++i) {
        if (i >= tracing.edges.size()) {
            const Crossing& crossing = *tracing.crossings[i - tracing.edges.size()];
            const auto line = clip(
                tracing.eye, segment_of(tracing.eye, crossing), {LineClass::intersection, 0, 1});
            if (line) tracer.trace(*line);
            continue;
        }
        const std::uint32_t e = tracing.edges[i];
        bool is_inside = false;
        for (const ClassStretch& stretch : line_stretches(tracing.eye, e)) {
            const auto line = clip(tracing.eye, segment_of(tracing.eye, e), stretch);
            if (!line) continue;
            is_inside = true;
            tracer.trace(*line);
        }
        if (is_inside) ++out.candidate_edges;
    }
    return out;
}

/// What the tasks have spent together, and how far they are.
class Account {
  public:
    Account(const TruthTrace& trace, std::size_t tasks) : trace_(trace), tasks_(tasks) {}

    void add(const TracedLines& part) {
        samples_ += part.samples;
        rays_ += part.rays;
        const std::size_t done = ++done_;
        // Whoever comes while another thread reports need not wait: the next one will say more.
        const std::unique_lock lock(reporting_, std::try_to_lock);
        if (trace_.progress && lock) trace_.progress(done, tasks_);
    }
    /// Once it is, it stays so: whether it ends so does not hang on the order of the tasks.
    [[nodiscard]] bool is_overdrawn() const {
        return samples_ > trace_.limits.samples || rays_ > trace_.limits.rays;
    }

  private:
    const TruthTrace& trace_;
    std::size_t tasks_;
    std::atomic<std::size_t> samples_{0}, rays_{0}, done_{0};
    std::mutex reporting_;
};

}  // namespace

TracedLines trace_lines(const EyeView& eye, const EyeScene& scene, const TruthTrace& trace) {
    const Visibility visibility(eye, scene);
    const Tracing tracing{eye, visibility, feature_edges(eye), seen_crossings(eye)};
    const std::size_t count = tracing.edges.size() + tracing.crossings.size();
    std::vector<TracedLines> parts((count + kChunk - 1) / kChunk);
    Account account(trace, parts.size());
    core::parallel_for(parts.size(), trace.threads, [&](std::size_t chunk) {
        if (account.is_overdrawn()) return;
        const std::size_t begin = chunk * kChunk;
        parts[chunk] = trace_chunk(tracing, begin, std::min(count, begin + kChunk));
        account.add(parts[chunk]);
    });
    if (account.is_overdrawn()) {
        throw TooLarge(std::to_string(count) + " lines need more than " +
                       std::to_string(trace.limits.samples) + " samples or " +
                       std::to_string(trace.limits.rays) + " rays");
    }
    TracedLines all;
    for (const TracedLines& part : parts) {
        all.curves.insert(all.curves.end(), part.curves.begin(), part.curves.end());
        all.candidate_edges += part.candidate_edges;
        all.samples += part.samples;
        all.rays += part.rays;
    }
    return all;
}

}  // namespace ink::truth
