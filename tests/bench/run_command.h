#pragma once

#include <filesystem>
#include <string>

namespace ink::bench_test {

struct Outcome {
    int exit_code = 0;
    std::string text;  ///< stdout and stderr as they came
};

/// Runs a line of shell and waits.
[[nodiscard]] Outcome run(const std::string& command);

/// A folder of its own for one test, gone with it.
class Desk {
  public:
    Desk();
    ~Desk();
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    /// The path of a file in it.
    [[nodiscard]] std::string path(const std::string& name) const {
        return (root_ / name).string();
    }
    /// Writes one; returns its path.
    std::string write(const std::string& name, const std::string& content) const;
    [[nodiscard]] std::string read(const std::string& name) const;

  private:
    std::filesystem::path root_;
};

}  // namespace ink::bench_test
