#include "core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace ink::core {

Progress::Progress(std::string label, int total)
    : label_(std::move(label)),
      total_(total),
      is_terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      last_(start_ - std::chrono::seconds(1)) {}

Progress::~Progress() {
    if (is_drawn_) fmt::print(stderr, "\r\033[K");
}

void Progress::report(int done, const std::string& what) {
    const auto now = std::chrono::steady_clock::now();
    if (!is_terminal_ || total_ <= 0 || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    is_drawn_ = true;
    const double elapsed_s = std::chrono::duration<double>(now - start_).count();
    const std::string left =
        done > 0 ? fmt::format(", {:.0f} s left", elapsed_s / done * (total_ - done)) : "";
    fmt::print(stderr, "\r\033[K{} {}/{}{}  {}", label_, done, total_, left, what.substr(0, 60));
    std::fflush(stderr);
}

}  // namespace ink::core
