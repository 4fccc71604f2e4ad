#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace ink::experiment {

/// What a block of a comparison spends its time on.
enum class WorkStage {
    prepare,       ///< methods are made ready for a scene
    draw,          ///< drawing, timed or not
    truth,         ///< tracing it and holding it against the cross-check, or reading both
    score,         ///< counts at every tolerance and threshold, bins
    causes,        ///< why wrong pixels are wrong
    cancellation,  ///< what declared codes must miss
    images,        ///< PNG files
    writing,       ///< tables and images to disk
};
inline constexpr std::size_t kStageCount = 8;

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

/// Adds to a stage the seconds that it lives. They are taken from the stage `within` which it
/// lives, if there is one.
class StageTimer {
  public:
    StageTimer(StageTimes& times, WorkStage stage, std::optional<WorkStage> within = {})
        : times_(times), stage_(stage), within_(within) {}
    ~StageTimer() {
        const std::chrono::duration<double> lived = std::chrono::steady_clock::now() - begin_;
        times_.add(stage_, lived.count());
        if (within_) times_.add(*within_, -lived.count());
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

  private:
    StageTimes& times_;
    WorkStage stage_;
    std::optional<WorkStage> within_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace ink::experiment
