#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ink::cli {

/// Adds --methods (or --method), which may be given again, to a command; `usual` says in words
/// what it takes when there are none. `method_list` or `one_method` reads the texts.
void add_method_options(CLI::App& command,
                        std::vector<std::string>& texts,
                        const std::string& usual = "all");

/// The same for a command that takes one method, `usual` if none is named; `one_method` reads it.
void add_one_method_option(CLI::App& command,
                           std::vector<std::string>& texts,
                           const std::string& usual,
                           const std::string& doc = "Method (see inkbench list methods)");

/// The registered methods that comma lists and globs mean, as one list a,b; "" for no texts.
///
/// Throws core::Error (where = "--methods") that lists the methods for an unknown name, a glob that
/// no method fits, and a list that names nothing.
[[nodiscard]] std::string method_list(const std::vector<std::string>& texts);

/// The one method that the texts mean, `usual` for no texts. Throws core::Error (where = `option`)
/// unless it is one.
[[nodiscard]] std::string one_method(const std::vector<std::string>& texts,
                                     const std::string& usual,
                                     const std::string& option = "--method");

/// The names of all registered methods.
[[nodiscard]] std::vector<std::string> method_words();

/// Adds --set, which may be given again; `doc` says what is set.
void add_set_option(CLI::App& command,
                    std::vector<std::string>& settings,
                    const std::string& doc = "A parameter: key=value or method.key=value");

}  // namespace ink::cli
