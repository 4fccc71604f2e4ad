#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace ink::cli {

/// The whole command line of inkbench with all its commands, nothing parsed yet.
[[nodiscard]] std::unique_ptr<CLI::App> make_program();

/// What is wrong with a command line, in one line that ends with the help to see: of the command
/// that was under way, if one was. An option that does not exist comes with the nearest one.
[[nodiscard]] std::string complaint(const CLI::App& program, const CLI::ParseError& error);

}  // namespace ink::cli
