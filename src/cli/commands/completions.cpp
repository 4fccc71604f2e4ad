#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/completions.h"
#include "cli/options/method_options.h"
#include "cli/options/scene_options.h"
#include "core/error.h"
#include "studies/stress/stress_axes.h"

namespace ink::cli {
namespace {

ValueWords value_words(const CLI::App& program) {
    ValueWords words;
    words["METHODS"] = words["METHOD"] = method_words();
    words["SCENES"] = words["SCENE"] = scene_words();
    words["SKIPS"] = skip_words();
    for (const studies::StressAxis& axis : studies::stress_axes())
        words["AXES"].push_back(axis.name);
    for (const CLI::App* command : program.get_subcommands({}))
        words["COMMAND"].push_back(command->get_name());
    return words;
}

}  // namespace

void add_completions_command(CLI::App& app) {
    auto shell = std::make_shared<std::string>();
    auto* command = app.add_subcommand(
        "completions", "Print the script by which a shell completes commands, options and names");
    command->add_option("shell", *shell, "The shell; zsh reads bash's script")
        ->type_name("bash|zsh")
        ->required();
    command->footer(
        "Example: source <(inkbench completions bash)\n"
        "For good: inkbench completions bash > "
        "~/.local/share/bash-completion/completions/inkbench\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([shell, &app] {
        if (*shell != "bash" && *shell != "zsh") {
            throw core::Error(
                "completions", fmt::format("there is no script for '{}'", *shell), "bash, zsh");
        }
        fmt::print("{}", bash_completions(app, value_words(app)));
    });
}

}  // namespace ink::cli
