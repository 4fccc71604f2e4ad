#include "core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace ink::core {
namespace {

constexpr auto kRedrawEvery = std::chrono::milliseconds(100);
constexpr auto kLineEvery = std::chrono::seconds(10);
constexpr std::size_t kMostChars = 60;  // of what is under way: a line must fit a terminal
constexpr int kMostSeconds = 100;       // above, minutes are exact enough

}  // namespace

ProgressDisplay& progress_display() {
    static ProgressDisplay display{.is_terminal = isatty(STDERR_FILENO) != 0 &&
                                                  moves_cursor(std::getenv("TERM"))};
    return display;
}

bool moves_cursor(const char* terminal) {
    const std::string_view name = terminal == nullptr ? "" : terminal;
    return !name.empty() && name != "dumb";
}

std::string rough_time(double seconds) {
    const double s = std::max(seconds, 0.0);
    if (s < kMostSeconds) return fmt::format("{:.0f} s", s);
    const auto minutes = static_cast<long long>(std::lround(s / 60));
    if (minutes < 60) return fmt::format("{} min", minutes);
    return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

Progress::Progress(std::string label, int total, ProgressDisplay& display)
    : label_(std::move(label)),
      total_(total),
      display_(display),
      start_(display.now()),
      last_drawn_(start_ - kRedrawEvery) {
    if (display_.last_line == std::chrono::steady_clock::time_point{}) display_.last_line = start_;
}

Progress::~Progress() {
    if (is_drawn_) std::fputs("\r\033[K", display_.stream);
}

void Progress::report(int done, const std::string& what) {
    if (display_.is_quiet || total_ <= 0) return;
    const auto now = display_.now();
    auto& last = display_.is_terminal ? last_drawn_ : display_.last_line;
    if (now - last < (display_.is_terminal ? kRedrawEvery : kLineEvery)) return;
    last = now;
    const double elapsed_s = std::chrono::duration<double>(now - start_).count();
    const std::string left =
        done > 0 ? fmt::format(", {} left", rough_time(elapsed_s / done * (total_ - done))) : "";
    is_drawn_ = display_.is_terminal;
    const std::string line =
        is_drawn_
            ? fmt::format(
                  "\r\033[K{} {}/{}{}  {}", label_, done, total_, left, what.substr(0, kMostChars))
            : fmt::format(
                  "{}: {}/{}{}{}{}\n", label_, done, total_, left, what.empty() ? "" : ", ", what);
    std::fputs(line.c_str(), display_.stream);  // a log that is full ends no work
    std::fflush(display_.stream);
}

}  // namespace ink::core
