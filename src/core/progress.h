#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

namespace ink::core {

/// Where lines of progress go, and when the last one went there.
struct ProgressDisplay {
    std::FILE* stream = stderr;
    /// A terminal on which a line can be drawn again; else a log, a pipe or a plain terminal, which
    /// gets whole lines, ten seconds apart.
    bool is_terminal = false;
    bool is_quiet = false;  ///< nothing at all is written
    std::function<std::chrono::steady_clock::time_point()> now = std::chrono::steady_clock::now;
    /// Of the last line of a log; at first, of the first work that was announced.
    std::chrono::steady_clock::time_point last_line = {};
};

/// The display of the process: stderr. The program may make it quiet before work begins; nobody
/// else changes it.
[[nodiscard]] ProgressDisplay& progress_display();

/// Whether a terminal of this name (what TERM says, or null) takes a line back that it shows: not
/// "dumb", nor one without a name.
[[nodiscard]] bool moves_cursor(const char* terminal);

/// How far long work is and how long it will take: `compare 12/81, 2 min left  torus view1`.
///
/// On a terminal one line that is drawn again at most ten times a second and wiped when the work is
/// done. Elsewhere `compare: 12/81, 2 min left, torus view1`, at most one line in ten seconds from
/// all work of the process together, so that short work says nothing. Lines come only when somebody
/// reports: a step that takes a minute is silent for so long. Not thread-safe: one thread reports.
class Progress {
  public:
    /// `total` steps are to come; `label` says of what ("compare"). 0 steps draw nothing. The
    /// display must outlive the work.
    Progress(std::string label, int total, ProgressDisplay& display = progress_display());
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `done` steps are finished and `what` is under way ("" for nothing to be named).
    void report(int done, const std::string& what);

  private:
    std::string label_;
    int total_;
    ProgressDisplay& display_;
    bool is_drawn_ = false;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point last_drawn_;
};

/// A time that is left, as people say it: "8 s", "4 min", "2 h 5 min". Negative counts as 0.
[[nodiscard]] std::string rough_time(double seconds);

}  // namespace ink::core
