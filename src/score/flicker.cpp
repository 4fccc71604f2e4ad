#include "score/drawing.h"
#include "score/motion.h"

namespace ink::score {
namespace {

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

MotionFrame motion_frame(const edge::Mask& thinned,
                         const ScoringTruth& truth,
                         const ScoreOptions& options) {
    check(options);
    check_same_size(thinned, truth.labels);
    TruthLists lists = list_truth(truth, options);
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

}  // namespace ink::score
