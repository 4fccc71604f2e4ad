#include "score/motion.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "score/drawing.h"
#include "score/pixel_list.h"

namespace ink::score {
namespace {

constexpr double kPiece_px = 0.5;

Feature feature_of(const truth::Curve& curve) {
    Feature feature{.line_class = curve.line_class, .edge = curve.edge};
    if (curve.edge == truth::kNoEdge) {
        feature.face0 = std::min(curve.face0, curve.face1);
        feature.face1 = std::max(curve.face0, curve.face1);
    }
    return feature;
}

/// 1 for each pixel with one of `lines` (not 0) in reach.
edge::Mask near_lines(const core::Image<std::uint8_t>& lines, double tolerance_px) {
    return reach_of(PixelList(lines), Disk(tolerance_px)).bytes();
}

/// 1 for each pixel in which a line is asked for.
edge::Mask asked_pixels(const ScoringTruth& truth, const ScoreOptions& options) {
    edge::Mask asked = near_lines(truth.labels, options.tolerance_px);
    clear_band(asked, options.band_px);
    for (std::size_t i = 0; i < asked.size() && !truth.ignore.is_empty(); ++i) {
        if (truth.ignore.data()[i] != 0) asked.data()[i] = 0;
    }
    return asked;
}

/// Counts the pops of one run, and takes its end from its caller.
class Run {
  public:
    void take(double share, const PopRules& rules) {
        ++frames_;
        if (share >= rules.shown_share) {
            if (was_shown_ && is_dropped_) ++pops_;
            was_shown_ = true;
            is_dropped_ = false;
        } else if (share <= rules.dropped_share) {
            is_dropped_ = true;
        }
    }
    void add_to(PopCount& count, const PopRules& rules) const {
        if (frames_ < rules.min_frames) return;
        count += {.pops = pops_, .runs = 1, .steps = frames_ - 1};
    }
    std::size_t last_frame = 0;

  private:
    int frames_ = 0;
    std::int64_t pops_ = 0;
    bool was_shown_ = false;
    bool is_dropped_ = false;
};

/// The pixels of `now` that have none of `then` in reach.
PixelList new_pixels(const PixelList& now, const PixelList& then, const Disk& disk) {
    PixelList fresh = now;
    fresh.drop(within_reach(now, then, disk));
    return fresh;
}

/// How many of `pixels` have none of `others` in reach.
std::int64_t count_alone(const PixelList& pixels, const PixelList& others, const Disk& disk) {
    return static_cast<std::int64_t>(new_pixels(pixels, others, disk).size());
}

/// What is drawn in `now` and not in `then`.
struct Change {
    std::int64_t all = 0;
    std::int64_t unexcused = 0;
};

Change change(const MotionFrame& now, const MotionFrame& then, const Disk& disk) {
    const PixelList fresh = new_pixels(now.counted, then.drawn, disk);
    const PixelList fresh_truth = new_pixels(now.truth, then.truth, disk);
    return {static_cast<std::int64_t>(fresh.size()), count_alone(fresh, fresh_truth, disk)};
}

}  // namespace

std::vector<FeatureSight> see_features(std::span<const truth::Curve> curves,
                                       const edge::Mask& thinned,
                                       const ScoringTruth& truth,
                                       const ScoreOptions& options) {
    check(options);
    check_same_size(thinned, truth.labels);
    const edge::Mask asked = asked_pixels(truth, options);
    const edge::Mask reach = near_lines(thinned, options.tolerance_px);
    std::map<Feature, FeatureSight> sights;
    for (const truth::Curve& curve : curves) {
        const double dx = curve.end.x_px - curve.begin.x_px;
        const double dy = curve.end.y_px - curve.begin.y_px;
        const double length_px = std::sqrt(dx * dx + dy * dy);
        const int pieces = std::max(1, static_cast<int>(std::ceil(length_px / kPiece_px)));
        const Feature feature = feature_of(curve);
        for (int i = 0; i < pieces; ++i) {
            const double along = (i + 0.5) / pieces;
            const int x = static_cast<int>(std::floor(curve.begin.x_px + along * dx));
            const int y = static_cast<int>(std::floor(curve.begin.y_px + along * dy));
            if (!asked.contains(x, y) || asked.at(x, y) == 0) continue;
            FeatureSight& sight = sights[feature];
            sight.length_px += length_px / pieces;
            if (reach.at(x, y) != 0) sight.covered_px += length_px / pieces;
        }
    }
    std::vector<FeatureSight> result;
    for (auto& [feature, sight] : sights) {
        if (sight.length_px <= 0) continue;
        sight.feature = feature;
        result.push_back(sight);
    }
    return result;
}

PopCount& PopCount::operator+=(const PopCount& other) {
    pops += other.pops;
    runs += other.runs;
    steps += other.steps;
    return *this;
}

PopCount count_pops(std::span<const std::vector<FeatureSight>> frames, const PopRules& rules) {
    PopCount count;
    std::map<Feature, Run> runs;
    for (std::size_t t = 0; t < frames.size(); ++t) {
        for (const FeatureSight& sight : frames[t]) {
            if (sight.length_px < rules.min_length_px) continue;
            const auto [place, is_new] = runs.try_emplace(sight.feature);
            Run& run = place->second;
            if (!is_new && run.last_frame + 1 != t) {
                run.add_to(count, rules);
                run = Run{};
            }
            run.last_frame = t;
            run.take(sight.share(), rules);
        }
    }
    for (const auto& [feature, run] : runs)
        run.add_to(count, rules);
    return count;
}

MotionFrame motion_frame(const edge::Mask& thinned,
                         const ScoringTruth& truth,
                         const ScoreOptions& options) {
    TruthLists lists = checked_lists(thinned, truth, options);
    PixelList counted = counted_pixels(edge::BitMask(thinned), lists);
    return {PixelList(thinned), std::move(counted), std::move(lists.truth)};
}

Flicker& Flicker::operator+=(const Flicker& other) {
    appeared += other.appeared;
    disappeared += other.disappeared;
    excused += other.excused;
    n_counted += other.n_counted;
    return *this;
}

std::optional<double> Flicker::share() const {
    if (n_counted == 0) return std::nullopt;
    return static_cast<double>(appeared + disappeared) / static_cast<double>(n_counted);
}

Flicker flicker(std::span<const MotionFrame> frames, double tolerance_px) {
    const Disk disk(tolerance_px);
    Flicker sum;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        const MotionFrame& before = frames[i - 1];
        const MotionFrame& after = frames[i];
        const Change come = change(after, before, disk);
        const Change gone = change(before, after, disk);
        sum +=
            {.appeared = come.unexcused,
             .disappeared = gone.unexcused,
             .excused = come.all + gone.all - come.unexcused - gone.unexcused,
             .n_counted = static_cast<std::int64_t>(before.counted.size() + after.counted.size())};
    }
    return sum;
}

InkChange& InkChange::operator+=(const InkChange& other) {
    true_px += other.true_px;
    beyond_px += other.beyond_px;
    return *this;
}

InkChange ink_change(const core::Image<float>& drawn_before,
                     const InkTruth& before,
                     const core::Image<float>& drawn_after,
                     const InkTruth& after) {
    check_same_size(before.counts, after.counts);
    InkChange change;
    for (std::size_t i = 0; i < after.counts.size(); ++i) {
        if (before.counts.data()[i] == 0 || after.counts.data()[i] == 0) continue;
        const double drawn = double{drawn_after.data()[i]} - double{drawn_before.data()[i]};
        const double own = double{after.coverage.data()[i]} - double{before.coverage.data()[i]};
        change += {std::abs(own), std::abs(drawn - own)};
    }
    return change;
}

}  // namespace ink::score
