#pragma once

#include <string>
#include <vector>

namespace ink::bench {

/// What `ink_bench` takes beside Google Benchmark's own flags.
struct Options {
    std::string simd;  ///< the instruction set to force; empty: the best
    int draws = 0;     ///< frames and passes run exactly so often; 0: as the library sees fit
    std::vector<std::string> models;         ///< model files to time as well
    std::string format = "console";          ///< of stdout: console, json or csv
    bool has_json_file = false;              ///< JSON goes to a file as well
    std::vector<std::string> library_words;  ///< the program's name, our defaults, the user's flags
};

/// Splits the command line. Ours: `--simd=NAME`, `--draws=N`, `--model=FILE` (as often as wanted).
/// The library's flags come with defaults before them, which any flag of the user's overrides:
/// 9 repetitions, interleaved at random, 0.1 s each. Throws core::Error for a wrong value of ours.
[[nodiscard]] Options parse_options(int argc, char** argv);

}  // namespace ink::bench
