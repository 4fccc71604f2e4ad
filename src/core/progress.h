#pragma once

#include <chrono>
#include <string>

namespace ink::core {

/// One line on stderr that says how far long work is and how long it will take.
///
/// Silent unless stderr is a terminal, so logs and pipes stay clean. Draws at most ten times a
/// second and wipes its line when it goes. Not thread-safe: one thread reports.
class Progress {
  public:
    /// `total` steps are to come; `label` says of what ("compare"). 0 steps draw nothing.
    Progress(std::string label, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `done` steps are finished and `what` is under way.
    void report(int done, const std::string& what);

  private:
    std::string label_;
    int total_;
    bool is_terminal_;
    bool is_drawn_ = false;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point last_;
};

}  // namespace ink::core
