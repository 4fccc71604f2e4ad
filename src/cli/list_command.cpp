#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/listing.h"
#include "core/error.h"
#include "experiment/dictionary.h"
#include "harness/methods_table.h"

namespace ink::cli {
namespace {

struct ListOptions {
    std::string what = "all";
    bool is_csv = false;
    bool is_markdown = false;
};

std::string list_text(const ListOptions& options) {
    if (options.is_csv && options.what != "methods") {
        throw core::Error(
            "--csv", fmt::format("'{}' is no table", options.what), "inkbench list methods --csv");
    }
    if (options.is_markdown && options.what != "columns") {
        throw core::Error("--markdown",
                          fmt::format("it is not for '{}'", options.what),
                          "inkbench list columns --markdown");
    }
    if (options.is_csv) return harness::methods_csv(harness::make_entrants("", {}));
    return options.is_markdown ? experiment::dictionary_markdown() : cli::listing(options.what);
}

}  // namespace

void add_list_command(CLI::App& app) {
    auto* command = app.add_subcommand(
        "list", "List methods, scenes, parameters, metrics, columns, skips, shadings and axes");
    auto options = std::make_shared<ListOptions>();
    command
        ->add_option("what",
                     options->what,
                     "all, methods, scenes, params, metrics, columns, skips, shadings or axes")
        ->capture_default_str();
    command->add_flag("--csv", options->is_csv, "Methods as methods.csv has them");
    command->add_flag("--markdown",
                      options->is_markdown,
                      "Columns as the data dictionary of a run folder (experiments/columns.md)");
    command->footer("Example: inkbench list params");
    command->callback([options] { fmt::print("{}", list_text(*options)); });
}

}  // namespace ink::cli
