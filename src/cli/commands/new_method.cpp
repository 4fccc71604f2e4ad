#include <fmt/format.h>

#include <memory>

#include "cli/commands/commands.h"
#include "cli/new_method.h"

namespace ink::cli {
namespace {

struct NewMethodArgs {
    std::string name;
    std::string root = ".";
};

}  // namespace

void add_new_method_command(CLI::App& app) {
    auto args = std::make_shared<NewMethodArgs>();
    auto* command = app.add_subcommand(
        "new-method", "Add a method of your own to the source tree, to begin from a template");
    command->add_option("name", args->name, "As tables and options will call it: small_letters")
        ->required();
    command->add_option("--root", args->root, "The source tree (default: this folder)")
        ->type_name("DIR");
    command->footer(
        "It draws at once: dark where the surface turns away. Change it, build, compare:\n"
        "methods/README.md says how a method is put together.\n"
        "Example: inkbench new-method my_lines && ./bootstrap build && \\\n"
        "         build/release/inkbench compare --scenes torus --methods my_lines,mote4\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] {
        for (const auto& path : add_new_method(args->root, args->name))
            fmt::print("{}\n", path.string());
        fmt::print("next: ./bootstrap build, then inkbench compare --methods {},mote4\n",
                   args->name);
    });
}

}  // namespace ink::cli
