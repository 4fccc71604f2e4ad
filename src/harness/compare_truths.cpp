#include "harness/compare_truths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/parallel.h"
#include "crosscheck/line_probe.h"
#include "crosscheck/open_places.h"

namespace ink::harness {
namespace {

constexpr double kSpacing_px = 1.0 / 8;
constexpr std::size_t kChunk = 1024;  ///< samples or points a task

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
    explicit PixelLists(const scene::View& view)
        : width_(view.width_px + 2), height_(view.height_px + 2) {}

    void add(const glm::dvec2& low, const glm::dvec2& high, std::uint32_t item) {
        for (int y = row(low.y); y <= row(high.y); ++y) {
            for (int x = column(low.x); x <= column(high.x); ++x)
                entries_.emplace_back(static_cast<std::uint32_t>(y * width_ + x), item);
        }
    }
    void finish() {
        first_.assign(static_cast<std::size_t>(width_) * height_ + 1, 0);
        for (const auto& [pixel, item] : entries_)
            ++first_[pixel + 1];
        for (std::size_t i = 1; i < first_.size(); ++i)
            first_[i] += first_[i - 1];
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        items_.resize(entries_.size());
        for (const auto& [pixel, item] : entries_)
            items_[next[pixel]++] = item;
    }
    /// Whether `accepts(item)` for one of those in the pixel of `p`.
    template <class Accepts>
    [[nodiscard]] bool any(const glm::dvec2& p, Accepts accepts) const {
        const std::size_t pixel = static_cast<std::size_t>(row(p.y)) * width_ + column(p.x);
        for (std::size_t i = first_[pixel]; i < first_[pixel + 1]; ++i) {
            if (accepts(items_[i])) return true;
        }
        return false;
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
    std::vector<std::pair<std::uint32_t, std::uint32_t>> entries_;
    std::vector<std::uint32_t> items_;  ///< by pixel
    std::vector<std::size_t> first_;    ///< of each pixel, into them
};

double distance_to(const truth::Curve& curve, const glm::dvec2& p) {
    const glm::dvec2 a = begin_of(curve), ab = end_of(curve) - a;
    const double length2 = glm::dot(ab, ab);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0;
    return glm::length(p - (a + t * ab));
}

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

/// A curve's pixels: those of its samples, which lie closer than the reach, and what is in reach.
void add_curve(const truth::Curve& curve, std::uint32_t item, PixelLists& lists) {
    const glm::dvec2 a = begin_of(curve), b = end_of(curve);
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::length(b - a))));
    for (int i = 0; i < pieces; ++i) {
        const glm::dvec2 from = glm::mix(a, b, static_cast<double>(i) / pieces);
        const glm::dvec2 to = glm::mix(a, b, static_cast<double>(i + 1) / pieces);
        lists.add(glm::min(from, to) - kAgreement_px, glm::max(from, to) + kAgreement_px, item);
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

/// Calls `is_covered(i)` for each i, on many threads, and returns what it said.
template <class IsCovered>
std::vector<char> ask_all(std::size_t count, int threads, const IsCovered& is_covered) {
    std::vector<char> answers(count);
    core::parallel_for((count + kChunk - 1) / kChunk, threads, [&](std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * kChunk);
        for (std::size_t i = chunk * kChunk; i < end; ++i)
            answers[i] = is_covered(i);
    });
    return answers;
}

void hold_curves(std::span<const truth::Curve> curves,
                 const crosscheck::SampledLines& crosscheck,
                 const scene::View& view,
                 int threads,
                 Agreement& result) {
    PixelLists lists(view);
    for (std::uint32_t i = 0; i < crosscheck.points.size(); ++i) {
        const glm::dvec2 p(crosscheck.points[i].x_px, crosscheck.points[i].y_px);
        lists.add(p - kAgreement_px, p + kAgreement_px, i);
    }
    lists.finish();
    struct Place {
        std::size_t curve;
        glm::dvec2 p_px;
        double length_px;
    };
    std::vector<Place> places;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        if (class_index(curves[c].line_class) == truth::kLineClasses.size()) continue;
        const Sampling samples(curves[c]);
        for (int i = 0; i < samples.count; ++i) {
            const glm::dvec2 p = samples.at(i);
            if (!is_on_frame(p, view)) places.push_back({c, p, samples.length / samples.count});
        }
    }
    const auto is_covered = ask_all(places.size(), threads, [&](std::size_t i) {
        return lists.any(places[i].p_px, [&](std::uint32_t item) {
            const crosscheck::SampledPoint& q = crosscheck.points[item];
            return q.line_class == curves[places[i].curve].line_class &&
                   glm::length(places[i].p_px - glm::dvec2(q.x_px, q.y_px)) <= kAgreement_px;
        });
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Place& place = places[i];
        const truth::LineClass line_class = curves[place.curve].line_class;
        ClassAgreement& agreement = result.by_class[class_index(line_class)];
        agreement.truth_px += place.length_px;
        if (is_covered[i] != 0) {
            agreement.truth_covered_px += place.length_px;
        } else {
            result.disagreements.push_back(
                {place.p_px.x, place.p_px.y, place.length_px, line_class, true, place.curve});
        }
    }
}

void hold_points(std::span<const truth::Curve> curves,
                 const crosscheck::SampledLines& crosscheck,
                 const scene::View& view,
                 int threads,
                 Agreement& result) {
    PixelLists lists(view);
    for (std::uint32_t i = 0; i < curves.size(); ++i)
        add_curve(curves[i], i, lists);
    lists.finish();
    const auto& points = crosscheck.points;
    const auto is_covered = ask_all(points.size(), threads, [&](std::size_t i) {
        const glm::dvec2 p(points[i].x_px, points[i].y_px);
        return lists.any(p, [&](std::uint32_t item) {
            return curves[item].line_class == points[i].line_class &&
                   distance_to(curves[item], p) <= kAgreement_px;
        });
    });
    for (std::size_t i = 0; i < points.size(); ++i) {
        const crosscheck::SampledPoint& point = points[i];
        const glm::dvec2 p(point.x_px, point.y_px);
        if (is_on_frame(p, view)) continue;
        ClassAgreement& agreement = result.by_class[class_index(point.line_class)];
        agreement.crosscheck_px += point.length_px;
        if (is_covered[i] != 0) {
            agreement.crosscheck_covered_px += point.length_px;
        } else {
            result.disagreements.push_back({p.x, p.y, point.length_px, point.line_class, false, 0});
        }
    }
}

}  // namespace

double ClassAgreement::truth_share() const {
    const double length = truth_px - truth_abstained_px;
    return length > 0 ? truth_covered_px / length : 1;
}

double ClassAgreement::crosscheck_share() const {
    const double length = crosscheck_px - crosscheck_abstained_px;
    return length > 0 ? crosscheck_covered_px / length : 1;
}

bool ClassAgreement::is_agreed() const {
    const auto is_covered = [](double length, double covered) {
        return length - covered <= std::max(kAllowedShare * length, kAgreement_px);
    };
    return is_covered(truth_px, truth_covered_px + truth_abstained_px) &&
           is_covered(crosscheck_px, crosscheck_covered_px + crosscheck_abstained_px);
}

bool Agreement::is_agreed() const {
    return total().is_agreed() &&
           std::all_of(by_class.begin(), by_class.end(), [](const ClassAgreement& c) {
               return c.is_agreed();
           });
}

ClassAgreement Agreement::total() const {
    ClassAgreement sum;
    for (const ClassAgreement& c : by_class) {
        sum.truth_px += c.truth_px;
        sum.truth_covered_px += c.truth_covered_px;
        sum.crosscheck_px += c.crosscheck_px;
        sum.crosscheck_covered_px += c.crosscheck_covered_px;
        sum.truth_abstained_px += c.truth_abstained_px;
        sum.crosscheck_abstained_px += c.crosscheck_abstained_px;
    }
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

}  // namespace ink::harness
