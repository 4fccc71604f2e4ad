#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace ink::cli {

/// The words that may stand for a value, by its type as --help calls it ("METHODS").
using ValueWords = std::map<std::string, std::vector<std::string>>;

/// A script by which bash completes the commands of `program`, their options, and the values of
/// options and arguments whose type is in `words` or is a choice "a|b|c"; file names elsewhere.
/// Lists a,b are completed at their last part. zsh takes it through bashcompinit.
[[nodiscard]] std::string bash_completions(const CLI::App& program, const ValueWords& words);

}  // namespace ink::cli
