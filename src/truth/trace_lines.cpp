#include "truth/trace_lines.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>
#include <string>
#include <utility>

#include "scene/topology.h"
#include "truth/crossings/touching.h"
#include "truth/pilots.h"
#include "truth/visibility.h"

namespace ink::truth {
namespace {

/// The sine of an angle; those that cross flatter may be moved much, but along both of them.
constexpr double kFlattest = 1.0 / 8;

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

/// How far the rounding of two faces may have moved the line in which they cross: the more, the
/// flatter they do.
double doubt_of(const scene::Topology& topology, const Crossing& crossing) {
    double rounding = 0;
    const auto normal_of = [&](std::uint32_t f) {
        rounding += topology.rounding_of(f);
        return glm::normalize(topology.area_vector(f));
    };
    const glm::dvec3 n0 = normal_of(crossing.face0), n1 = normal_of(crossing.face1);
    const double sine = glm::length(glm::cross(n0, n1));
    return crossing.error + rounding / std::max(sine, kFlattest);
}

constexpr double kSpacing_px = 1.0 / 4;     ///< samples are at most this far apart
constexpr double kBisected_px = 1.0 / 512;  ///< a change lies in an interval no longer than this

// The first and last sample stand this far inside: at a vertex itself many faces touch the point,
// and whether one of them hides it says nothing about the line.
constexpr double kInset_px = 1.0 / 1024;

constexpr std::size_t kChunk = 64;  ///< edges or crossings a task

/// What can change along a line.
struct State {
    bool is_visible = false;
    ContourKind kind = ContourKind::none;  ///< of a visible contour

    [[nodiscard]] bool operator==(const State&) const = default;
};

/// Follows one line and notes its visible pieces, and hidden ones if asked.
class LineTracer {
  public:
    LineTracer(const EyeView& eye, const Visibility& visibility, Hidden hidden, TracedLines& out)
        : eye_(eye), visibility_(visibility), keeps_hidden_(hidden == Hidden::keep), out_(out) {}

    void trace(const ScreenLine& line) {
        line_ = &line;
        blocker_ = kNoFace;
        look_ = Visibility::Look::quick;
        const double inset = std::min(0.25, kInset_px / line.length_px);
        const int steps = std::max(1, static_cast<int>(std::ceil(line.length_px / kSpacing_px)));
        double s = line.length_px <= kBisected_px ? 0.5 : inset;
        State state = state_at(s);
        begin_s_ = 0;
        for (int i = 1; i <= steps && line.length_px > kBisected_px; ++i) {
            const double next_s = i == steps ? 1 - inset : static_cast<double>(i) / steps;
            State next = state_at(next_s);
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
        if (!visibility_.is_visible(point, blocker_, out_.rays)) return {};
        if (line_->line_class != LineClass::contour) return {true};
        return {true, visibility_.kind_behind(point, look_, out_.rays)};
    }

    /// The state of a contour's sample by a closer look. What was seen of one object stays seen.
    State closer(double s, State state) {
        if (eye_.model.is_one_object && state.kind == ContourKind::self) return state;
        const LinePoint point = line_->line_point(s);
        return {true, visibility_.kind_behind(point, Visibility::Look::close, out_.rays)};
    }

    static bool is_contour(State state) { return state.kind != ContourKind::none; }

    /// Finds every change of state that halving meets between two samples. Where only what lies
    /// behind a contour changes, a closer look may find that it does not: a surface that ends right
    /// behind the line is met by chance. Then both states are set anew, and all of the line is
    /// looked at closely from there on.
    void bisect(double low, State at_low, double high, State& at_high) {
        while (at_low != at_high) {
            if (is_contour(at_low) && is_contour(at_high)) {
                const State low_before = std::exchange(at_low, closer(low, at_low));
                const State high_before = std::exchange(at_high, closer(high, at_high));
                if (at_low != low_before || at_high != high_before) look_ = Visibility::Look::close;
                if (at_low == at_high) return;
            }
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
        if (!state.is_visible && !keeps_hidden_) return;
        Curve curve;
        curve.line_class = line_->line_class;
        curve.edge = line_->segment.edge;
        if (const Crossing* crossing = line_->segment.crossing) {
            curve.face0 = crossing->face0;
            curve.face1 = crossing->face1;
        }
        curve.kind = state.kind;
        curve.begin = line_->point_at(begin);
        curve.end = line_->point_at(end);
        curve.deviation_rad = line_->segment.crossing != nullptr
                                  ? deviation_of_crossing()
                                  : deviation(begin + (end - begin) / 2);
        (state.is_visible ? out_.curves : out_.hidden).push_back(curve);
    }

    /// How far the two seen faces deviate from flat; of a contour its first two faces.
    [[nodiscard]] float deviation(double s) const {
        const scene::Topology& topology = eye_.model.topology;
        const std::uint32_t e = line_->segment.edge;
        const scene::Edge& edge = topology.edges[e];
        const bool is_outline =
            line_->line_class == LineClass::contour || line_->line_class == LineClass::boundary;
        if (eye_.model.is_touched[e] != 0 && !is_outline) {
            return static_cast<float>(seen_deviation_rad(eye_, e, line_->segment_parameter(s)));
        }
        if (edge.face_count < 2) return 0;
        const SeenFaces seen = eye_.seen_faces(edge);
        if (seen.left == kNoFace || seen.right == kNoFace) {
            const auto faces = topology.faces_of(edge);
            return static_cast<float>(scene::deviation_rad(topology, edge, faces[0], faces[1]));
        }
        return static_cast<float>(scene::deviation_rad(topology, edge, seen.left, seen.right));
    }

    /// The same of a crossing. One face is seen on either side, both from where the eye is, so it
    /// is the angle between the normals that face the eye.
    [[nodiscard]] float deviation_of_crossing() const {
        const Crossing& crossing = *line_->segment.crossing;
        const auto normal_of = [&](std::uint32_t f) {
            return eye_.model.topology.area_vector(f) * static_cast<double>(eye_.facing[f]);
        };
        const glm::dvec3 n0 = normal_of(crossing.face0), n1 = normal_of(crossing.face1);
        return static_cast<float>(std::atan2(glm::length(glm::cross(n0, n1)), glm::dot(n0, n1)));
    }

    const EyeView& eye_;
    const Visibility& visibility_;
    bool keeps_hidden_;
    TracedLines& out_;
    const ScreenLine* line_ = nullptr;
    std::uint32_t blocker_ = kNoFace;
    Visibility::Look look_ = Visibility::Look::quick;
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

/// Whether two pieces of a cracked surface cross there, overlapping by less than can be seen.
bool is_unseen_slit(const EyeView& eye, const Crossing& crossing) {
    const glm::dvec4 begin = eye.projection.to_homogeneous(crossing.begin_world);
    const glm::dvec4 end = eye.projection.to_homogeneous(crossing.end_world);
    return eye.is_unseen(crossing.slit_world, begin.z < end.z ? begin : end);
}

/// A face seen edge-on has no sides, so a crossing with it is none.
std::vector<const Crossing*> seen_crossings(const EyeView& eye) {
    std::vector<const Crossing*> crossings;
    for (const Crossing& crossing : eye.model.crossings.segments) {
        if (eye.facing[crossing.face0] != 0 && eye.facing[crossing.face1] != 0 &&
            !is_unseen_slit(eye, crossing)) {
            crossings.push_back(&crossing);
        }
    }
    return crossings;
}

void check_crossings(const Model& model) {
    if (!model.crossings.is_too_many) return;
    throw TooLarge(
        "more pairs of triangles touch than the search for crossings may look at; fewer objects "
        "that grow into each other, or a simpler mesh, would help");
}

/// What the tasks share.
struct Tracing {
    const EyeView& eye;
    const Visibility& visibility;
    Hidden hidden;
    std::vector<std::uint32_t> edges;
    std::vector<const Crossing*> crossings;
};

/// Traces the edges, then the crossings, numbered through, from `begin` to `end`.
TracedLines trace_chunk(const Tracing& tracing, std::size_t begin, std::size_t end) {
    TracedLines out;
    LineTracer tracer(tracing.eye, tracing.visibility, tracing.hidden, out);
    for (std::size_t i = begin; i < end; ++i) {
        if (i >= tracing.edges.size()) {
            const Crossing& crossing = *tracing.crossings[i - tracing.edges.size()];
            const auto line = clip_to_image(
                tracing.eye, segment_of(tracing.eye, crossing), {LineClass::intersection, 0, 1});
            if (line) tracer.trace(*line);
            continue;
        }
        const std::uint32_t e = tracing.edges[i];
        bool is_inside = false;
        for (const ClassStretch& stretch : line_stretches(tracing.eye, e)) {
            const auto line = clip_to_image(tracing.eye, segment_of(tracing.eye, e), stretch);
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
    Account(const TruthOptions& options, std::size_t tasks) : options_(options), tasks_(tasks) {}

    void add(const TracedLines& part) {
        samples_ += part.samples;
        rays_ += part.rays;
        const std::size_t done = ++done_;
        // Whoever comes while another thread reports need not wait: the next one will say more.
        const std::unique_lock lock(reporting_, std::try_to_lock);
        if (options_.progress && lock) options_.progress(done, tasks_);
    }
    /// Once it is, it stays so: whether it ends so does not depend on the order of the tasks.
    [[nodiscard]] bool is_overdrawn() const {
        return samples_ > options_.limits.samples || rays_ > options_.limits.rays;
    }

  private:
    const TruthOptions& options_;
    std::size_t tasks_;
    std::atomic<std::size_t> samples_{0}, rays_{0}, done_{0};
    std::mutex reporting_;
};

}  // namespace

double ScreenLine::segment_parameter(double s) const {
    const double along = s * h_begin / ((1 - s) * h_end + s * h_begin);
    return t_begin + along * (t_end - t_begin);
}

LinePoint ScreenLine::line_point(double s) const {
    const double t = segment_parameter(s);
    return {segment.edge,
            segment.a_world + t * (segment.b_world - segment.a_world),
            depth_at(s),
            segment.crossing,
            segment.noise_world,
            segment.doubt_world};
}

double ScreenLine::depth_at(double s) const {
    // In perspective h is the depth, and 1/h linear on the screen; else the depth is.
    if (h_begin == depth_begin && h_end == depth_end)
        return h_begin * h_end / ((1 - s) * h_end + s * h_begin);
    return depth_begin + s * (depth_end - depth_begin);
}

CurvePoint ScreenLine::point_at(double s) const {
    return {begin_px.x + s * (end_px.x - begin_px.x),
            begin_px.y + s * (end_px.y - begin_px.y),
            depth_at(s)};
}

WorldSegment segment_of(const EyeView& eye, std::uint32_t e) {
    const scene::Edge& edge = eye.model.topology.edges[e];
    const auto& p = eye.model.topology.p_world;
    return {.edge = e,
            .noise_world = rounding_between(p[edge.a], p[edge.b]),
            .a_world = p[edge.a],
            .b_world = p[edge.b],
            .a_clip = eye.p_clip[edge.a],
            .b_clip = eye.p_clip[edge.b]};
}

WorldSegment segment_of(const EyeView& eye, const Crossing& crossing) {
    const glm::dvec3 &a = crossing.begin_world, &b = crossing.end_world;
    return {.crossing = &crossing,
            .noise_world = rounding_between(a, b),
            .doubt_world = doubt_of(eye.model.topology, crossing),
            .a_world = a,
            .b_world = b,
            .a_clip = eye.projection.to_homogeneous(a),
            .b_clip = eye.projection.to_homogeneous(b)};
}

std::optional<ScreenLine> clip_to_image(const EyeView& eye,
                                        const WorldSegment& segment,
                                        const ClassStretch& stretch) {
    const glm::dvec4& a = segment.a_clip;
    const glm::dvec4& b = segment.b_clip;
    double t0 = stretch.t_begin, t1 = stretch.t_end;
    const double width = eye.width_px, height = eye.height_px;
    if (!clip_to_positive(eye.behind_near(a), eye.behind_near(b), t0, t1) ||
        !clip_to_positive(a.x, b.x, t0, t1) ||
        !clip_to_positive(width * a.z - a.x, width * b.z - b.x, t0, t1) ||
        !clip_to_positive(a.y, b.y, t0, t1) ||
        !clip_to_positive(height * a.z - a.y, height * b.z - b.y, t0, t1)) {
        return std::nullopt;
    }
    const glm::dvec4 begin = t0 == 0 ? a : a + t0 * (b - a);
    const glm::dvec4 end = t1 == 1 ? b : a + t1 * (b - a);
    ScreenLine line{
        .segment = segment, .line_class = stretch.line_class, .t_begin = t0, .t_end = t1};
    line.h_begin = begin.z;
    line.h_end = end.z;
    line.depth_begin = eye.projection.depth_of(begin.z / begin.w);
    line.depth_end = eye.projection.depth_of(end.z / end.w);
    line.begin_px = glm::dvec2(begin) / begin.z;
    line.end_px = glm::dvec2(end) / end.z;
    line.length_px = std::hypot(line.end_px.x - line.begin_px.x, line.end_px.y - line.begin_px.y);
    return line;
}

TracedLines trace_lines(const EyeView& eye,
                        const EyeScene& scene,
                        const TruthOptions& options,
                        Hidden hidden) {
    check_crossings(eye.model);
    const Visibility visibility(eye, scene);
    const Tracing tracing{eye, visibility, hidden, feature_edges(eye), seen_crossings(eye)};
    const std::size_t count = tracing.edges.size() + tracing.crossings.size();
    std::vector<TracedLines> parts((count + kChunk - 1) / kChunk);
    Account account(options, parts.size());
    const auto trace_part = [&](std::size_t chunk) {
        if (account.is_overdrawn()) return;
        const std::size_t begin = chunk * kChunk;
        parts[chunk] = trace_chunk(tracing, begin, std::min(count, begin + kChunk));
        account.add(parts[chunk]);
    };
    const auto samples_of = [&](std::size_t i) { return parts[i].samples; };
    const auto rays_of = [&](std::size_t i) { return parts[i].rays; };
    const bool is_whole =
        run_pilots_first(parts.size(), options.threads, trace_part, [&](std::size_t stride) {
            return will_exceed(parts.size(), stride, options.limits.samples, samples_of) ||
                   will_exceed(parts.size(), stride, options.limits.rays, rays_of);
        });
    if (!is_whole || account.is_overdrawn()) {
        throw TooLarge(std::to_string(count) + " lines need more than " +
                       std::to_string(options.limits.samples) + " samples or " +
                       std::to_string(options.limits.rays) +
                       " rays; fewer objects, a simpler mesh or a smaller image would help");
    }
    TracedLines all;
    for (const TracedLines& part : parts) {
        all.curves.insert(all.curves.end(), part.curves.begin(), part.curves.end());
        all.hidden.insert(all.hidden.end(), part.hidden.begin(), part.hidden.end());
        all.candidate_edges += part.candidate_edges;
        all.samples += part.samples;
        all.rays += part.rays;
    }
    return all;
}

}  // namespace ink::truth
