#include "bench/options.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "core/error.h"

namespace ink::bench {
namespace {

/// What follows `name` in `word`, if it begins with it.
std::optional<std::string> value_of(const std::string& word, std::string_view name) {
    if (word.compare(0, name.size(), name) != 0) return std::nullopt;
    return word.substr(name.size());
}

int parse_count(const std::string& text) {
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 1)
        throw core::Error("--draws", "'" + text + "'", "a whole number from 1 on");
    return count;
}

}  // namespace

Options parse_options(int argc, char** argv) {
    Options options;
    options.library_words = {argv[0],
                             "--benchmark_repetitions=9",
                             "--benchmark_enable_random_interleaving=true",
                             "--benchmark_min_time=0.1"};
    bool is_json = true;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (const auto simd = value_of(word, "--simd=")) {
            options.simd = *simd;
        } else if (const auto draws = value_of(word, "--draws=")) {
            options.draws = parse_count(*draws);
        } else if (const auto model = value_of(word, "--model=")) {
            options.models.push_back(*model);
        } else {
            options.library_words.push_back(word);
        }
        if (const auto format = value_of(word, "--benchmark_format=")) options.format = *format;
        if (value_of(word, "--benchmark_out=")) options.has_json_file = true;
        if (const auto format = value_of(word, "--benchmark_out_format="))
            is_json = *format == "json";
    }
    options.has_json_file = options.has_json_file && is_json;
    return options;
}

}  // namespace ink::bench
