#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "harness/cells/cell.h"
#include "harness/clock/outside_method.h"
#include "harness/clock/timing.h"
#include "harness/clock/yardstick.h"

namespace ink::harness {
namespace {

/// After so many turns of a round the yardstick is timed again: often enough to run at the speed at
/// which the drawings ran, at a tenth of their time at most.
constexpr std::size_t kTurnsPerYardstick = 3;

/// Those who take turns, while they do.
class Round {
  public:
    Round(const PreparedMethods& methods,
          const scene::View& view,
          const MeasureOptions& options,
          std::vector<edge::EdgeImage>& images)
        : methods_(methods),
          view_(view),
          options_(options),
          images_(images),
          times_(methods.size()),
          is_done_(methods.size(), false),
          again_(view.width_px, view.height_px) {
        images_.assign(methods.size(), again_);
    }

    /// Each draws its image. Not timed but for what has a clock of its own.
    void begin() {
        for (std::size_t i = 0; i < methods_.size(); ++i) {
            (void)draw(i, images_[i]);
            const auto* outside = dynamic_cast<OutsideMethod*>(&methods_[i]->method());
            if (outside == nullptr) continue;
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
            for (std::size_t turn = 0; turn < methods_.size(); ++turn) {
                const std::size_t i = (static_cast<std::size_t>(round) + turn) % methods_.size();
                if (turn % kTurnsPerYardstick == 0) time_yardstick();
                if (!is_done_[i]) repeat(i);
            }
        }
    }

    /// Of each method.
    [[nodiscard]] std::vector<DrawTimes> take_times() {
        if (least_yardstick_ns_ > 0) time_yardstick();  // after the last
        for (DrawTimes& times : times_)
            times.yardstick_ns = least_yardstick_ns_;
        return std::move(times_);
    }

  private:
    /// The yardstick beside a drawing is the quicker one of those before and after.
    void time_yardstick() {
        const core::Spent spent = spent_on([&] { yardstick_.work(); });
        yardstick_ns_ = options_.threads == 1 ? spent.cpu_ns : spent.wall_ns;
        least_yardstick_ns_ =
            least_yardstick_ns_ == 0 ? yardstick_ns_ : std::min(least_yardstick_ns_, yardstick_ns_);
        for (const std::size_t i : drawn_since_) {
            std::int64_t& beside_ns = times_[i].yardsticks_ns.back();
            beside_ns = std::min(beside_ns, yardstick_ns_);
        }
        drawn_since_.clear();
    }

    template <class Work>
    core::Spent spent_on(Work work) const {
        return core::spent_on(work, worker_of(options_.threads), *options_.clock);
    }

    void repeat(std::size_t i) {
        const core::Spent spent = draw(i, again_);
        if (is_done_[i]) return;
        if (!(again_ == images_[i])) return fail(i, "failed: two drawings of one view differ");
        DrawTimes& times = times_[i];
        times.skips = methods_[i]->method().skip_counts();
        times.clock = clock_of(options_.threads);
        times.draws.push_back(spent);
        times.yardsticks_ns.push_back(yardstick_ns_);
        times.yardstick_ns = least_yardstick_ns_;
        drawn_since_.push_back(i);
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
    core::Spent draw(std::size_t i, edge::EdgeImage& out) {
        core::Spent spent;
        std::string failure = methods_[i]->failure();
        if (failure.empty()) {
            failure = failure_of([&] {
                spent = spent_on([&] {
                    methods_[i]->method().draw({view_, options_.threads, options_.skips}, out);
                });
                check_size(out);
            });
        }
        if (!failure.empty()) fail(i, failure);
        return spent;
    }

    void check_size(edge::EdgeImage& image) const {
        const int width_px = image.width_px();
        const int height_px = image.height_px();
        if (width_px == view_.width_px && height_px == view_.height_px) return;
        image = edge::EdgeImage(view_.width_px, view_.height_px);
        throw std::runtime_error(fmt::format("an image of {} x {} px", width_px, height_px));
    }

    void fail(std::size_t i, const std::string& failure) {
        times_[i] = {};
        times_[i].failure = failure;
        std::erase(drawn_since_, i);
        is_done_[i] = true;
    }

    const PreparedMethods& methods_;
    const scene::View& view_;
    const MeasureOptions& options_;
    std::vector<edge::EdgeImage>& images_;
    std::vector<DrawTimes> times_;
    Yardstick yardstick_;
    std::int64_t yardstick_ns_ = 0;         ///< the last
    std::int64_t least_yardstick_ns_ = 0;   ///< 0: none was timed
    std::vector<std::size_t> drawn_since_;  ///< who drew after the last, each once
    std::vector<bool> is_done_;
    edge::EdgeImage again_;
};

}  // namespace

std::vector<DrawTimes> draw_in_turns(const PreparedMethods& methods,
                                     const scene::View& view,
                                     const MeasureOptions& options,
                                     std::vector<edge::EdgeImage>& images) {
    Round round(methods, view, options, images);
    round.begin();
    if (options.max_repetitions > 0 && !round.is_done()) round.repeat();
    return round.take_times();
}

}  // namespace ink::harness
