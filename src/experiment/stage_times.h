#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string>

namespace ink::experiment {

/// What a block of a comparison spends its time on.
enum class WorkStage {
    prepare,       ///< methods are made ready for a scene
    draw,          ///< drawing, timed or not
    truth,         ///< tracing it and holding it against the cross-check, or reading both
    score,         ///< counts at every tolerance and threshold, offsets, widths, bins
    causes,        ///< why wrong pixels are wrong
    cancellation,  ///< what declared codes must miss
    images,        ///< PNG files
    writing,       ///< tables and images to disk
    waiting,       ///< for another lane that was timed
};
inline constexpr std::size_t kStageCount = 9;

/// Seconds by stage, of one block or of many.
class StageTimes {
  public:
    void add(WorkStage stage, double seconds) {
        seconds_[static_cast<std::size_t>(stage)] += seconds;
    }
    void add(const StageTimes& other);

    /// "score 31 %, draw 25 %, ...": what took most first, nothing below a percent; "" of no time.
    [[nodiscard]] std::string text() const;

  private:
    std::array<double, kStageCount> seconds_{};
};

/// Adds to a stage the seconds that it lives, less those in which its lane stood still
/// (core::waited_s).
class StageTimer {
  public:
    StageTimer(StageTimes& times, WorkStage stage);
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

  private:
    StageTimes& times_;
    WorkStage stage_;
    std::chrono::steady_clock::time_point begin_;
    double waited_before_s_;
};

}  // namespace ink::experiment
