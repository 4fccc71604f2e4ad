#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "harness/cell.h"
#include "harness/outside_method.h"
#include "harness/timing.h"
#include "harness/yardstick.h"

namespace ink::harness {
namespace {

/// After so many turns of a round the yardstick is timed again: often enough to meet what the
/// drawings meet, at a tenth of their time at most.
constexpr std::size_t kTurnsPerYardstick = 3;

/// A turn of one round.
struct Drawing {
    std::vector<core::Spent> draws;  ///< of the frames that count
    raster::SkipCounts skips = {};   ///< summed over them
};

void add(const raster::SkipCounts& counts, raster::SkipCounts& sums) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i].skipped += counts[i].skipped;
        sums[i].of += counts[i].of;
    }
}

/// Those who take turns, while they do.
class Round {
  public:
    Round(std::span<const Turn> turns,
          const Shot& shot,
          const MeasureOptions& options,
          std::vector<edge::EdgeImage>& images)
        : turns_(turns),
          shot_(shot),
          options_(options),
          images_(images),
          times_(turns.size()),
          is_done_(turns.size(), false),
          frame_image_(shot.view.width_px, shot.view.height_px),
          again_(shot.view.width_px, shot.view.height_px * frame_count()) {
        if (!shot.poses.empty()) posed_ = *shot.scene;
        images_.assign(turns.size(), again_);
    }

    /// Each draws its image. Not timed but for what has a clock of its own.
    void begin() {
        for (std::size_t i = 0; i < turns_.size(); ++i) {
            const auto* outside = dynamic_cast<OutsideMethod*>(&turns_[i].method->method());
            if (outside == nullptr) {
                const Drawing drawing = draw(i, images_[i]);
                // Later rounds of a sequence follow other turns: the first says what it leaves out.
                if (!shot_.poses.empty()) times_[i].skips = drawing.skips;
                continue;
            }
            (void)draw(i, images_[i]);
            if (!is_done_[i]) times_[i] = outside->times();
            is_done_[i] = true;
        }
    }

    [[nodiscard]] bool is_done() const {
        return std::all_of(is_done_.begin(), is_done_.end(), [](bool is) { return is; });
    }

    /// Round after round, until all are done.
    void repeat() {
        for (int round = 1; round <= options_.max_repetitions && !is_done(); ++round) {
            for (std::size_t turn = 0; turn < turns_.size(); ++turn) {
                const std::size_t i = (static_cast<std::size_t>(round) + turn) % turns_.size();
                if (turn % kTurnsPerYardstick == 0) time_yardstick();
                if (!is_done_[i]) repeat(i);
            }
        }
    }

    [[nodiscard]] std::vector<DrawTimes> take_times() {
        for (DrawTimes& times : times_)
            if (!yardstick_ns_.empty()) times.yardstick_ns = lower_quartile(yardstick_ns_);
        return std::move(times_);
    }

  private:
    [[nodiscard]] int frame_count() const {
        return std::max(1, static_cast<int>(shot_.poses.size()));
    }

    void time_yardstick() {
        const core::Spent spent = spent_on([&] { yardstick_.work(); });
        yardstick_ns_.push_back(options_.threads == 1 ? spent.cpu_ns : spent.wall_ns);
    }

    template <class Work>
    core::Spent spent_on(Work work) const {
        return core::spent_on(work, worker_of(options_.threads), *options_.clock);
    }

    void repeat(std::size_t i) {
        const Drawing drawing = draw(i, again_);
        if (is_done_[i]) return;
        if (!(again_ == images_[i])) return fail(i, "failed: two drawings of one view differ");
        DrawTimes& times = times_[i];
        if (shot_.poses.empty()) times.skips = drawing.skips;
        times.clock = clock_of(options_.threads);
        times.has_alike = shot_.poses.empty();
        for (const core::Spent& draw : drawing.draws)
            times.draws.push_back(draw);
        is_done_[i] = is_enough(times);
    }

    [[nodiscard]] bool is_enough(const DrawTimes& times) const {
        const std::vector<std::int64_t> draws_ns = times.draws_ns();
        if (draws_ns.size() < static_cast<std::size_t>(options_.min_repetitions)) return false;
        const auto sum_ns = std::accumulate(draws_ns.begin(), draws_ns.end(), std::int64_t{0});
        return 1e-9 * static_cast<double>(sum_ns) > options_.budget_s ||
               (options_.precision > 0 && lower_spread(draws_ns) <= options_.precision);
    }

    /// A turn; one that throws is the method's last.
    Drawing draw(std::size_t i, edge::EdgeImage& out) {
        Drawing drawing;
        std::string failure = turns_[i].method->failure();
        if (failure.empty()) {
            failure = failure_of([&] { drawing = draw_frames(turns_[i], out); });
        }
        if (!failure.empty()) fail(i, failure);
        return drawing;
    }

    Drawing draw_frames(const Turn& turn, edge::EdgeImage& out) {
        Drawing drawing;
        method::Method& method = turn.method->method();
        const bool is_still = shot_.poses.empty();
        edge::EdgeImage& image = is_still ? out : frame_image_;
        for (int frame = 0; frame < frame_count(); ++frame) {
            if (!is_still) {
                posed_->instances.front().world_from_object =
                    shot_.poses[static_cast<std::size_t>(frame)];
                method.pose(*posed_);
            }
            const core::Spent spent = spent_on([&] {
                method.draw({shot_.view, options_.threads, turn.skips}, image);
            });
            check_size(image);
            if (!is_still)
                std::copy_n(image.data(), image.size(), out.row(frame * shot_.view.height_px));
            if (frame == 0 && !is_still) continue;
            drawing.draws.push_back(spent);
            add(method.skip_counts(), drawing.skips);
        }
        return drawing;
    }

    void check_size(edge::EdgeImage& image) const {
        const int width_px = image.width_px();
        const int height_px = image.height_px();
        if (width_px == shot_.view.width_px && height_px == shot_.view.height_px) return;
        image = edge::EdgeImage(shot_.view.width_px, shot_.view.height_px);
        throw std::runtime_error(fmt::format("an image of {} x {} px", width_px, height_px));
    }

    void fail(std::size_t i, const std::string& failure) {
        times_[i] = {};
        times_[i].failure = failure;
        is_done_[i] = true;
    }

    std::span<const Turn> turns_;
    const Shot& shot_;
    const MeasureOptions& options_;
    std::vector<edge::EdgeImage>& images_;
    std::vector<DrawTimes> times_;
    Yardstick yardstick_;
    std::vector<std::int64_t> yardstick_ns_;
    std::vector<bool> is_done_;
    std::optional<scene::Scene> posed_;
    edge::EdgeImage frame_image_;
    edge::EdgeImage again_;
};

}  // namespace

std::vector<DrawTimes> draw_in_turns(std::span<const Turn> turns,
                                     const Shot& shot,
                                     const MeasureOptions& options,
                                     std::vector<edge::EdgeImage>& images) {
    Round round(turns, shot, options, images);
    round.begin();
    if (options.max_repetitions > 0 && !round.is_done()) round.repeat();
    return round.take_times();
}

std::vector<DrawTimes> draw_in_turns(const PreparedMethods& methods,
                                     const scene::View& view,
                                     const MeasureOptions& options,
                                     std::vector<edge::EdgeImage>& images) {
    return draw_in_turns(turns_of(methods, options), {view}, options, images);
}

std::vector<Turn> turns_of(const PreparedMethods& methods, const MeasureOptions& options) {
    std::vector<Turn> turns;
    for (const auto& method : methods)
        turns.push_back({method.get(), options.skips});
    return turns;
}

}  // namespace ink::harness
