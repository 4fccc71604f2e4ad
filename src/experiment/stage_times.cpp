#include "experiment/stage_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace ink::experiment {
namespace {

constexpr std::array<const char*, kStageCount> kNames = {
    "prepare", "draw", "truth", "score", "causes", "cancellation", "images", "writing"};

}  // namespace

void StageTimes::add(const StageTimes& other) {
    for (std::size_t i = 0; i < kStageCount; ++i)
        seconds_[i] += other.seconds_[i];
}

std::string StageTimes::text() const {
    const double all = std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
    std::array<std::size_t, kStageCount> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return seconds_[a] > seconds_[b];
    });
    std::string text;
    for (const std::size_t i : order) {
        if (seconds_[i] < 0.01 * all || seconds_[i] == 0) break;
        text += fmt::format(
            "{}{} {:.0f} %", text.empty() ? "" : ", ", kNames[i], 100 * seconds_[i] / all);
    }
    return text;
}

}  // namespace ink::experiment
