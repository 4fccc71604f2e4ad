#include <algorithm>
#include <functional>
#include <utility>

#include "core/parallel.h"
#include "harness/cell.h"
#include "harness/median_interval.h"
#include "harness/outside_method.h"
#include "harness/timing.h"

namespace ink::harness {
namespace {

/// The methods of a view while they take turns.
class Turns {
  public:
    Turns(std::vector<std::unique_ptr<PreparedMethod>>& methods,
          const scene::View& view,
          const MeasureOptions& options,
          std::vector<edge::EdgeImage>& images)
        : methods_(methods),
          options_(options),
          frame_{view, options.threads, options.skips},
          images_(images),
          times_(methods.size()),
          spent_s_(methods.size(), 0),
          is_done_(methods.size(), false),
          again_(view.width_px, view.height_px) {
        images_.assign(methods.size(), again_);
    }

    /// Each draws its image. Not timed but for what has a clock of its own.
    void begin() {
        for (std::size_t i = 0; i < methods_.size(); ++i) {
            if (i > 0) core::pause();
            const auto* outside = dynamic_cast<OutsideMethod*>(&methods_[i]->method());
            if (outside == nullptr) {
                (void)draw(i, images_[i]);
                continue;
            }
            measure([&] { (void)draw(i, images_[i]); });
            if (!is_done_[i] && outside->draw_ns()) times_[i].draw_ns = {*outside->draw_ns()};
            is_done_[i] = true;
        }
    }

    [[nodiscard]] bool is_done() const {
        return std::all_of(is_done_.begin(), is_done_.end(), [](bool is) { return is; });
    }

    /// Round after round, until all are done.
    void repeat() {
        measure([&] { repeat_rounds(); });
    }

    [[nodiscard]] std::vector<DrawTimes> take_times() { return std::move(times_); }

  private:
    void measure(const std::function<void()>& work) const {
        options_.is_alone ? core::run_alone(work) : work();
    }

    void repeat_rounds() {
        for (int round = 1; round <= options_.max_repetitions && !is_done(); ++round) {
            for (std::size_t i = 0; i < methods_.size(); ++i)
                if (!is_done_[i]) repeat(i);
        }
    }

    void repeat(std::size_t i) {
        const std::int64_t ns = draw(i, again_);
        if (is_done_[i]) return;
        if (!(again_ == images_[i])) return fail(i, "failed: two drawings of one view differ");
        DrawTimes& times = times_[i];
        times.draw_ns.push_back(ns);
        times.skips = methods_[i]->method().skip_counts();
        spent_s_[i] += static_cast<double>(ns) * 1e-9;
        is_done_[i] =
            static_cast<int>(times.draw_ns.size()) >= options_.min_repetitions &&
            (spent_s_[i] > options_.budget_s || is_median_known(times.draw_ns, options_.precision));
    }

    /// Nanoseconds that a drawing takes; one that throws is the method's last.
    std::int64_t draw(std::size_t i, edge::EdgeImage& out) {
        std::int64_t ns = 0;
        std::string failure = methods_[i]->failure();
        if (failure.empty()) {
            failure =
                failure_of([&] { ns = time_ns([&] { methods_[i]->method().draw(frame_, out); }); });
        }
        if (!failure.empty()) fail(i, failure);
        return ns;
    }

    void fail(std::size_t i, const std::string& failure) {
        times_[i] = {{}, failure, {}};
        is_done_[i] = true;
    }

    std::vector<std::unique_ptr<PreparedMethod>>& methods_;
    const MeasureOptions& options_;
    method::Frame frame_;
    std::vector<edge::EdgeImage>& images_;
    std::vector<DrawTimes> times_;
    std::vector<double> spent_s_;
    std::vector<bool> is_done_;
    edge::EdgeImage again_;
};

}  // namespace

std::vector<DrawTimes> draw_in_turns(std::vector<std::unique_ptr<PreparedMethod>>& methods,
                                     const scene::View& view,
                                     const MeasureOptions& options,
                                     std::vector<edge::EdgeImage>& images) {
    Turns turns(methods, view, options, images);
    turns.begin();
    if (options.max_repetitions > 0 && !turns.is_done()) turns.repeat();
    return turns.take_times();
}

}  // namespace ink::harness
