#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/run_data.h"

namespace ink::report {

/// A command, and what it gives.
struct NextCommand {
    std::string what;
    std::string line;  ///< as a shell reads it
};

/// What a reader can do with the answer of a comparison.
struct TakeHome {
    std::string method;   ///< what the answer's method does, in a sentence; "" where nobody says
    std::string address;  ///< of its page, seen from a folder; "" where that is not there
    std::vector<NextCommand> commands;  ///< on the run's first model; none without an answer
};
[[nodiscard]] TakeHome take_home(const experiment::RunData& run,
                                 const std::filesystem::path& page_folder);

}  // namespace ink::report
