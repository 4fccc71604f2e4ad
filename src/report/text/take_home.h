#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "experiment/run_data.h"

namespace ink::report {

/// What a reader can do with the answer of a comparison.
struct TakeHome {
    std::string method;   ///< what the answer's method does, in a sentence; "" where nobody says
    std::string address;  ///< of its page, seen from a folder; "" where that is not there
    /// What each gives, and its line for a shell: on the run's first model; none without an answer.
    std::vector<std::pair<std::string, std::string>> commands;
};
[[nodiscard]] TakeHome take_home(const experiment::RunData& run,
                                 const std::filesystem::path& page_folder);

}  // namespace ink::report
