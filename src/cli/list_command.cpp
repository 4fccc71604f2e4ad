#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/listing.h"
#include "core/error.h"
#include "experiment/dictionary.h"

namespace ink::cli {

void add_list_command(CLI::App& app) {
    auto* command = app.add_subcommand(
        "list", "List methods, scenes, parameters, metrics, columns, skips, shadings and axes");
    auto what = std::make_shared<std::string>("all");
    auto as_markdown = std::make_shared<bool>(false);
    command
        ->add_option("what",
                     *what,
                     "all, methods, scenes, params, metrics, columns, skips, shadings or axes")
        ->capture_default_str();
    command->add_flag("--markdown",
                      *as_markdown,
                      "Columns as the data dictionary of a run folder (experiments/columns.md)");
    command->footer("Example: inkbench list params");
    command->callback([what, as_markdown] {
        if (*as_markdown && *what != "columns") {
            throw core::Error(
                "--markdown", fmt::format("it is not for '{}'", *what), "list columns --markdown");
        }
        fmt::print("{}", *as_markdown ? experiment::dictionary_markdown() : cli::listing(*what));
    });
}

}  // namespace ink::cli
