#include "harness/truths/compare_truths.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>

#include "core/byte_stream.h"
#include "core/kept_file.h"
#include "core/keyed_lists.h"
#include "core/parallel.h"
#include "core/whole_file.h"
#include "crosscheck/line_probe.h"
#include "truth/model.h"
#include "truth/truth_cache.h"

namespace ink::harness {
namespace {

constexpr double kSpacing_px = 1.0 / 8;
constexpr std::size_t kChunk = 128;  ///< curves or points a task

std::size_t class_index(truth::LineClass c) {
    return std::find(truth::kLineClasses.begin(), truth::kLineClasses.end(), c) -
           truth::kLineClasses.begin();
}

glm::dvec2 begin_of(const truth::Curve& curve) {
    return {curve.begin.x_px, curve.begin.y_px};
}

glm::dvec2 end_of(const truth::Curve& curve) {
    return {curve.end.x_px, curve.end.y_px};
}

/// Things by the pixels that they may concern: built whole, then asked.
class PixelLists {
  public:
    /// Calls `boxes_of(item, add)` twice for each item, which calls `add(low, high)` for the boxes
    /// that hold all it concerns.
    template <class BoxesOf>
    PixelLists(const scene::View& view, std::size_t item_count, const BoxesOf& boxes_of)
        : width_(view.width_px + 2),
          height_(view.height_px + 2),
          items_(static_cast<std::size_t>(width_) * height_, [&](auto take) {
              for (std::uint32_t item = 0; item < item_count; ++item) {
                  boxes_of(item, [&](const glm::dvec2& low, const glm::dvec2& high) {
                      for (int y = row(low.y); y <= row(high.y); ++y) {
                          for (int x = column(low.x); x <= column(high.x); ++x)
                              take(static_cast<std::size_t>(y) * width_ + x, item);
                      }
                  });
              }
          }) {}
    /// Whether `accepts(item)` for one of those in the pixel of `p`.
    template <class Accepts>
    [[nodiscard]] bool any(const glm::dvec2& p, Accepts accepts) const {
        const std::size_t pixel = static_cast<std::size_t>(row(p.y)) * width_ + column(p.x);
        return std::ranges::any_of(items_.of(pixel), accepts);
    }

  private:
    [[nodiscard]] int column(double x) const {
        return static_cast<int>(std::clamp(std::floor(x) + 1, 0.0, width_ - 1.0));
    }
    [[nodiscard]] int row(double y) const {
        return static_cast<int>(std::clamp(std::floor(y) + 1, 0.0, height_ - 1.0));
    }

    int width_;
    int height_;
    core::KeyedLists<std::uint32_t> items_;  ///< by pixel
};

/// Whether the curve passes the point within `reach_px`, and not just ends or begins there.
bool passes(const truth::Curve& curve, const glm::dvec2& p, double reach_px) {
    const glm::dvec2 a = begin_of(curve), ab = end_of(curve) - a;
    const double along = glm::dot(p - a, ab), length2 = glm::dot(ab, ab);
    if (along <= 0 || along >= length2) return false;
    return std::abs(ab.x * (p - a).y - ab.y * (p - a).x) <= reach_px * std::sqrt(length2);
}

bool is_on_frame(const glm::dvec2& p, const scene::View& view) {
    return p.x < kFrame_px || p.y < kFrame_px || p.x > view.width_px - kFrame_px ||
           p.y > view.height_px - kFrame_px;
}

/// Calls `add(low, high)` for boxes that hold what is in a curve's reach.
template <class Add>
void for_boxes_of(const truth::Curve& curve, const Add& add) {
    const glm::dvec2 a = begin_of(curve), b = end_of(curve);
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::length(b - a))));
    for (int i = 0; i < pieces; ++i) {
        const glm::dvec2 from = glm::mix(a, b, static_cast<double>(i) / pieces);
        const glm::dvec2 to = glm::mix(a, b, static_cast<double>(i + 1) / pieces);
        add(glm::min(from, to) - kAgreement_px, glm::max(from, to) + kAgreement_px);
    }
}

/// A curve as samples, each for its share of the length.
struct Sampling {
    glm::dvec2 a, b;
    double length = 0;
    int count = 1;

    explicit Sampling(const truth::Curve& curve)
        : a(begin_of(curve)), b(end_of(curve)), length(glm::length(b - a)) {
        count = std::max(1, static_cast<int>(std::ceil(length / kSpacing_px)));
    }
    [[nodiscard]] glm::dvec2 at(int i) const { return glm::mix(a, b, (i + 0.5) / count); }
};

/// How far a point is from the line on which a curve lies.
double distance_to_line(const glm::dvec2& p, const truth::Curve& curve) {
    const glm::dvec2 a = begin_of(curve), ab = end_of(curve) - a, ap = p - a;
    const double length = glm::length(ab);
    return length > 0 ? std::abs(ab.x * ap.y - ab.y * ap.x) / length : glm::length(ap);
}

/// Of two classes the one that comes first, if it is any.
truth::LineClass first_of(truth::LineClass a, truth::LineClass b) {
    return a == truth::LineClass::none ? b : std::min(a, b);
}

/// Calls `hold(i, part)` for each i, on many threads, and adds up the parts in order.
template <class Hold>
void hold_all(std::size_t count, int threads, Agreement& result, const Hold& hold) {
    const auto parts = core::parallel_parts<Agreement>(
        count, kChunk, threads, [&](std::size_t begin, std::size_t end, Agreement& part) {
            for (std::size_t i = begin; i < end; ++i)
                hold(i, part);
        });
    for (const Agreement& part : parts) {
        for (std::size_t c = 0; c < result.by_class.size(); ++c)
            result.by_class[c] += part.by_class[c];
        result.disagreements.insert(
            result.disagreements.end(), part.disagreements.begin(), part.disagreements.end());
    }
}

void hold_curves(std::span<const truth::Curve> curves,
                 const crosscheck::SampledLines& crosscheck,
                 const scene::View& view,
                 int threads,
                 Agreement& result) {
    const auto& points = crosscheck.points;
    const PixelLists lists(view, points.size(), [&](std::uint32_t i, const auto& add) {
        const glm::dvec2 p(points[i].x_px, points[i].y_px);
        add(p - kAgreement_px, p + kAgreement_px);
    });
    hold_all(curves.size(), threads, result, [&](std::size_t c, Agreement& part) {
        const truth::LineClass line_class = curves[c].line_class;
        if (class_index(line_class) == truth::kLineClasses.size()) return;
        ClassAgreement& agreement = part.by_class[class_index(line_class)];
        const Sampling samples(curves[c]);
        const double length_px = samples.length / samples.count;
        for (int i = 0; i < samples.count; ++i) {
            const glm::dvec2 p = samples.at(i);
            if (is_on_frame(p, view)) continue;
            agreement.truth_px += length_px;
            truth::LineClass beside = truth::LineClass::none;
            const bool is_covered = lists.any(p, [&](std::uint32_t item) {
                const glm::dvec2 q(points[item].x_px, points[item].y_px);
                if (glm::length(p - q) > kAgreement_px) return false;
                if (points[item].line_class == line_class) return true;
                if (distance_to_line(q, curves[c]) <= kThinnest_px)
                    beside = first_of(beside, points[item].line_class);
                return false;
            });
            if (is_covered) {
                agreement.truth_covered_px += length_px;
            } else {
                part.disagreements.push_back(
                    {p.x, p.y, length_px, line_class, true, c, true, beside, curves[c].edge});
            }
        }
    });
}

void hold_points(std::span<const truth::Curve> curves,
                 const crosscheck::SampledLines& crosscheck,
                 const scene::View& view,
                 int threads,
                 Agreement& result) {
    const PixelLists lists(view, curves.size(), [&](std::uint32_t i, const auto& add) {
        for_boxes_of(curves[i], add);
    });
    const auto& points = crosscheck.points;
    hold_all(points.size(), threads, result, [&](std::size_t i, Agreement& part) {
        const crosscheck::SampledPoint& point = points[i];
        const glm::dvec2 p(point.x_px, point.y_px);
        if (is_on_frame(p, view)) return;
        ClassAgreement& agreement = part.by_class[class_index(point.line_class)];
        agreement.crosscheck_px += point.length_px;
        truth::LineClass beside = truth::LineClass::none;
        const bool is_covered = lists.any(p, [&](std::uint32_t item) {
            const truth::Curve& curve = curves[item];
            const double away = distance_to_segment(p, begin_of(curve), end_of(curve));
            if (away > kAgreement_px) return false;
            if (curve.line_class == point.line_class) return true;
            if (away <= kThinnest_px) beside = first_of(beside, curve.line_class);
            return false;
        });
        if (is_covered) {
            agreement.crosscheck_covered_px += point.length_px;
        } else {
            part.disagreements.push_back(
                {p.x, p.y, point.length_px, point.line_class, false, 0, true, beside});
        }
    });
}

/// Takes back what lies on another line that both have, if that is there and a curve is of its
/// edge's class.
void forgive_coincident(const scene::Topology& topology,
                        const scene::View& view,
                        const crosscheck::SamplingOptions& options,
                        Agreement& agreement) {
    std::vector<Disagreement*> beside;
    std::vector<crosscheck::ClaimedPoint> others;
    std::vector<crosscheck::ClaimedEdge> edges;
    for (Disagreement& d : agreement.disagreements) {
        const bool has_edge = !d.is_truth || d.edge != truth::kNoEdge;
        if (!d.is_confirmed || d.beside == truth::LineClass::none || !has_edge) continue;
        beside.push_back(&d);
        others.push_back({{d.x_px, d.y_px}, d.beside});
        edges.push_back({d.is_truth ? d.edge : 0, d.line_class});
    }
    const auto is_seen = crosscheck::see_claimed_lines(topology, view, options, others);
    const auto is_named = crosscheck::name_claimed_edges(topology, view, options, edges);
    for (std::size_t i = 0; i < beside.size(); ++i) {
        Disagreement& d = *beside[i];
        if (is_seen[i] == 0 || (d.is_truth && is_named[i] == 0)) continue;
        d.is_confirmed = false;
        agreement.by_class[class_index(d.line_class)].coincident_px += d.length_px;
    }
}

constexpr core::KeptKind kKind = {'i', 'n', 'k', 'w', 'i', 't', 'n', '4'};

template <class Stream, class Check>
void pass(Stream& of, Check& check) {
    constexpr std::size_t kBytes = 3 * sizeof(double) + 3 + sizeof(std::size_t);
    of.parts(check.agreement.by_class, check.counts, check.look_s);
    of.list(check.agreement.disagreements, kBytes, [](Stream& stream, auto& d) {
        stream.parts(
            d.x_px, d.y_px, d.length_px, d.line_class, d.is_truth, d.curve, d.is_confirmed);
    });
}

Crosscheck look(truth::SceneModel& scene, const scene::View& view, const truth::Truth& truth) {
    const auto begin = std::chrono::steady_clock::now();
    crosscheck::SamplingOptions options;
    options.crease_rad = scene.options().crease_rad;
    options.creases = scene.options().creases;
    options.threads = scene.options().threads;
    const crosscheck::SampledLines crosscheck =
        crosscheck::sample_lines(scene.model().topology, view, options);
    Crosscheck check;
    check.agreement = compare_truths(truth.curves, crosscheck, view, options.threads);
    judge_disagreements(scene.model().topology, view, options, check.agreement);
    check.counts = crosscheck.counts;
    check.look_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return check;
}

}  // namespace

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 ab = b - a;
    const double length2 = glm::dot(ab, ab);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0;
    return glm::length(p - (a + t * ab));
}

ClassAgreement& ClassAgreement::operator+=(const ClassAgreement& other) {
    truth_px += other.truth_px;
    truth_covered_px += other.truth_covered_px;
    crosscheck_px += other.crosscheck_px;
    crosscheck_covered_px += other.crosscheck_covered_px;
    truth_abstained_px += other.truth_abstained_px;
    crosscheck_abstained_px += other.crosscheck_abstained_px;
    coincident_px += other.coincident_px;
    return *this;
}

double ClassAgreement::truth_share() const {
    const double length = truth_px - truth_abstained_px;
    return length > 0 ? truth_covered_px / length : 1;
}

double ClassAgreement::crosscheck_share() const {
    const double length = crosscheck_px - crosscheck_abstained_px;
    return length > 0 ? crosscheck_covered_px / length : 1;
}

bool ClassAgreement::is_agreed() const {
    const auto is_covered = [](double length, double covered, double least) {
        return length - covered <= std::max(kAllowedShare * length, least);
    };
    return is_covered(truth_px, truth_covered_px + truth_abstained_px, kAgreement_px) &&
           is_covered(
               crosscheck_px, crosscheck_covered_px + crosscheck_abstained_px, kOneCrossing_px);
}

bool Agreement::is_agreed() const {
    return total().is_agreed() && std::ranges::all_of(by_class, &ClassAgreement::is_agreed);
}

ClassAgreement Agreement::total() const {
    ClassAgreement sum;
    for (const ClassAgreement& c : by_class)
        sum += c;
    return sum;
}

double Agreement::disagreement_rate() const {
    const ClassAgreement sum = total();
    const double length = sum.truth_px + sum.crosscheck_px;
    const double uncovered =
        (sum.truth_px - sum.truth_covered_px - sum.truth_abstained_px) +
        (sum.crosscheck_px - sum.crosscheck_covered_px - sum.crosscheck_abstained_px);
    return length > 0 ? std::max(0.0, uncovered) / length : 0;
}

double Agreement::abstained_share() const {
    const ClassAgreement sum = total();
    const double length = sum.truth_px + sum.crosscheck_px;
    return length > 0 ? (sum.truth_abstained_px + sum.crosscheck_abstained_px) / length : 0;
}

Agreement compare_truths(std::span<const truth::Curve> curves,
                         const crosscheck::SampledLines& crosscheck,
                         const scene::View& view,
                         int threads) {
    Agreement result;
    hold_curves(curves, crosscheck, view, threads, result);
    hold_points(curves, crosscheck, view, threads, result);
    return result;
}

void judge_disagreements(const scene::Topology& topology,
                         const scene::View& view,
                         const crosscheck::SamplingOptions& options,
                         Agreement& agreement) {
    std::vector<crosscheck::ClaimedPoint> claims;
    for (const Disagreement& d : agreement.disagreements)
        claims.push_back({{d.x_px, d.y_px}, d.line_class});
    const std::vector<char> is_seen =
        crosscheck::see_claimed_lines(topology, view, options, claims);
    std::vector<std::size_t> confirmed;
    std::vector<crosscheck::ClaimedPoint> places;
    for (std::size_t i = 0; i < claims.size(); ++i) {
        Disagreement& d = agreement.disagreements[i];
        d.is_confirmed = (is_seen[i] != 0) != d.is_truth;
        if (!d.is_confirmed) continue;
        confirmed.push_back(i);
        places.push_back(claims[i]);
    }
    const std::vector<char> is_open = crosscheck::find_open_places(topology, view, options, places);
    for (std::size_t i = 0; i < confirmed.size(); ++i)
        agreement.disagreements[confirmed[i]].is_confirmed = is_open[i] == 0;
    forgive_coincident(topology, view, options, agreement);
    for (const Disagreement& d : agreement.disagreements) {
        if (d.is_confirmed) continue;
        ClassAgreement& c = agreement.by_class[class_index(d.line_class)];
        (d.is_truth ? c.truth_abstained_px : c.crosscheck_abstained_px) += d.length_px;
    }
}

double strip_length_px(std::span<const truth::Curve> curves, const Agreement& agreement) {
    double sum = 0;
    for (const Disagreement& d : agreement.disagreements) {
        if (!d.is_truth) continue;
        for (std::size_t c = 0; c < curves.size(); ++c) {
            if (c == d.curve || !passes(curves[c], {d.x_px, d.y_px}, kThinnest_px)) continue;
            sum += d.length_px;
            break;
        }
    }
    return sum;
}

std::string encode_check(const Crosscheck& check, const std::string& key) {
    return core::sealed(
        kKind, key, core::written_bytes([&](core::ByteWriter& out) { pass(out, check); }));
}

std::optional<Crosscheck> decode_check(std::string_view bytes, const std::string& key) {
    const auto payload = core::unsealed(bytes, kKind, key);
    if (!payload) return std::nullopt;
    core::ByteReader in(*payload);
    Crosscheck check;
    pass(in, check);
    const auto& all = check.agreement.disagreements;
    const bool has_classes = std::ranges::all_of(
        all, [](const Disagreement& d) { return d.line_class <= truth::LineClass::ignore; });
    return in.is_at_end() && has_classes ? std::optional(std::move(check)) : std::nullopt;
}

Crosscheck cached_crosscheck(truth::SceneModel& scene,
                             const scene::View& view,
                             const truth::Truth& truth,
                             const std::filesystem::path& cache_dir) {
    if (cache_dir.empty()) return look(scene, view, truth);
    const std::string key = truth::truth_key(scene.scene(), view, scene.options());
    const std::filesystem::path path = cache_dir / (key + ".crosscheck");
    if (const auto bytes = core::read_whole_file(path)) {
        if (auto check = decode_check(*bytes, key)) return std::move(*check);
    }
    Crosscheck check = look(scene, view, truth);
    core::keep_file(path, encode_check(check, key));
    return check;
}

}  // namespace ink::harness
