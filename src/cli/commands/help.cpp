#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "core/error.h"
#include "core/param.h"

namespace ink::cli {
namespace {

/// The help of the command called `name`, of the program for "".
std::string help_of(const CLI::App& program, const std::string& name) {
    // Not program.help(), which would show the help of the command that runs: this one.
    const auto formatter = program.get_formatter();
    if (name.empty())
        return formatter->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal);
    for (const CLI::App* command : program.get_subcommands({}))
        if (command->get_name() == name) return command->help(program.get_name());
    throw core::Error("help",
                      fmt::format("there is no command '{}'", name),
                      core::known_names(command_names(program), name));
}

}  // namespace

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({}))
        names.push_back(command->get_name());
    return names;
}

void add_help_command(CLI::App& app) {
    auto name = std::make_shared<std::string>();
    auto* command = app.add_subcommand("help", "Print the help of a command, as --help does");
    command->add_option("command", *name, "A command (default: the program itself)")
        ->type_name("COMMAND");
    command->footer(
        "Example: inkbench help compare\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([name, &app] { fmt::print("{}", help_of(app, *name)); });
}

}  // namespace ink::cli
