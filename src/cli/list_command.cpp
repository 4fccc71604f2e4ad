#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/listing.h"

namespace ink::cli {

void add_list_command(CLI::App& app) {
    auto* command = app.add_subcommand(
        "list", "List methods, scenes, parameters, metrics, skips, shadings and axes");
    auto what = std::make_shared<std::string>("all");
    command
        ->add_option(
            "what", *what, "all, methods, scenes, params, metrics, skips, shadings or axes")
        ->capture_default_str();
    command->footer("Example: inkbench list params");
    command->callback([what] { fmt::print("{}", cli::listing(*what)); });
}

}  // namespace ink::cli
