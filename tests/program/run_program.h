#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/core/temp_folder.h"

namespace ink::program {

/// The words of a command line, one by one or as a user types them, with spaces between.
class Words : public std::vector<std::string> {
  public:
    using std::vector<std::string>::vector;
    Words(const char* line) : Words(std::string(line)) {}
    Words(const std::string& line);

    Words& operator+=(const Words& more) {
        insert(end(), more.begin(), more.end());
        return *this;
    }
    friend Words operator+(Words words, const Words& more) { return words += more; }
};

/// What a user sees of one run.
struct Outcome {
    int exit_code = 0;  ///< 128 + signal if it was killed
    std::string out;
    std::string err;
};

/// A folder of its own for one test, gone with it. The program runs in `work()`; what it keeps
/// between runs goes to a folder beside, so that `work()` shows exactly what a user would find.
class Desk {
  public:
    Desk();

    [[nodiscard]] std::filesystem::path work() const { return root_ / "work"; }

    /// Runs the built `inkbench` with these arguments and waits. It is killed after five minutes.
    [[nodiscard]] Outcome run(const Words& arguments) const;

    /// Runs another program (a path) as `run` does, in the same place and surroundings.
    [[nodiscard]] Outcome run_other(const std::string& program, const Words& arguments) const;

    /// As `run`, but sends SIGINT (Ctrl-C) as soon as `is_time` says so; asked every few
    /// milliseconds.
    [[nodiscard]] Outcome run_until(const Words& arguments,
                                    const std::function<bool()>& is_time) const;

    /// As `run`, but sends SIGKILL (kill -9): exit code 137.
    [[nodiscard]] Outcome kill_when(const Words& arguments,
                                    const std::function<bool()>& is_time) const;

    /// Writes a file into `work()`; returns its name.
    std::string write(const std::string& name, const std::string& content) const;
    [[nodiscard]] std::string read(const std::string& name) const;

    /// Every file and folder in `work()`, with the size of files: equal before and after means that
    /// nothing was left behind.
    [[nodiscard]] std::map<std::string, std::uintmax_t> inventory() const;

  private:
    [[nodiscard]] Outcome run_with_signal(const std::string& program,
                                          const Words& arguments,
                                          const std::function<bool()>& is_time,
                                          int signal) const;

    core::TempFolder root_;
};

/// `err` without the lines of progress that long work leaves in a log, "compare: 3/9, 8 s left,
/// ...".
[[nodiscard]] std::string without_progress(const std::string& err);

/// Runs it and expects success without a word on stderr but progress; what it printed.
std::string expect_done(const Desk& desk, const Words& words);

/// The same of a command that prints JSON.
nlohmann::json expect_json(const Desk& desk, const Words& words);

/// Runs it and expects what every wrong command line gives: exit code 2, nothing printed, nothing
/// left behind, and one line on stderr, which is returned.
std::string refusal(const Desk& desk, const Words& words);

/// The same; the line must name all of `parts`.
void expect_refused(const Desk& desk, const Words& words, const Words& parts);

/// A wrong command line, or the end of one, and what the line about it must name.
struct Wrong {
    Words words;
    Words parts;
};
/// Each of them behind `begin`.
void expect_all_refused(const Desk& desk, const Words& begin, const std::vector<Wrong>& wrong);

/// Every command.
inline constexpr const char* kCommands[] = {
    "compare",  "advise", "draw",   "truth",        "score",      "explain", "figures",
    "timedemo", "tune",   "stress", "run",          "merge",      "report",  "page",
    "diff",     "bake",   "export", "entrant-test", "new-method", "list",    "help"};

/// A cube and a triangle as model files.
inline constexpr const char* kCubeObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n";
inline constexpr const char* kTriangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// The rows of a CSV file (RFC 4180), each from column to field.
using Table = std::vector<std::map<std::string, std::string>>;
[[nodiscard]] Table parse_csv(const std::string& text);

/// rows.csv of the run in `folder`.
[[nodiscard]] Table rows_of(const Desk& desk, const std::string& folder = "out");

/// The rows of one method.
[[nodiscard]] Table only(Table rows, const std::string& method);

/// What a page of `inkbench report` shows: the JSON that its scripts read. A test fails by the
/// exception where the page holds none.
[[nodiscard]] nlohmann::json page_data(const std::string& page);

/// The table of that name of the first run of the page in `folder`; null if it has none.
[[nodiscard]] nlohmann::json page_table(const Desk& desk,
                                        const std::string& folder,
                                        const std::string& name);

/// The rows of a study in rows.csv of the run in `out`.
[[nodiscard]] Table rows_of_study(const Desk& desk, const std::string& study);

/// The table `name` of the run in `folder`, each line with what rows.csv says of its cell; where
/// both have a column, the table's own. Throws std::runtime_error for a cell that rows.csv has not.
[[nodiscard]] Table table_of_run(const Desk& desk,
                                 const std::string& folder,
                                 const std::string& name);

}  // namespace ink::program
