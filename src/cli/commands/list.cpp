#include <fmt/format.h>

#include <memory>

#include "cli/commands/commands.h"
#include "cli/list_json.h"
#include "cli/listing.h"
#include "core/error.h"
#include "experiment/dictionary.h"
#include "harness/tables/methods_table.h"

namespace ink::cli {
namespace {

struct ListArgs {
    std::string what;
    bool is_json = false;
    bool is_csv = false;
    bool is_markdown = false;
};

/// Throws unless `flag` is for the topic it is asked for.
void check_topic(bool is_asked, const char* flag, const std::string& what, const char* topic) {
    if (!is_asked || what == topic) return;
    throw core::Error(flag,
                      fmt::format("it is not for '{}'", what.empty() ? "all" : what),
                      fmt::format("inkbench list {} {}", topic, flag));
}

std::string list_text(const ListArgs& args) {
    check_topic(args.is_csv, "--csv", args.what, "methods");
    check_topic(args.is_markdown, "--markdown", args.what, "columns");
    if (args.is_csv) return harness::methods_csv(harness::make_configs("", {}));
    if (args.is_markdown) return experiment::dictionary_markdown();
    if (args.is_json) return listing_json(args.what.empty() ? "all" : args.what).dump(2) + "\n";
    return args.what.empty() ? list_overview() : cli::listing(args.what);
}

}  // namespace

void add_list_command(CLI::App& app) {
    auto args = std::make_shared<ListArgs>();
    auto* command = app.add_subcommand(
        "list", "List methods, scenes, parameters, metrics, columns, skips, shadings and axes");
    command->add_option("what", args->what, "The topic (default: the names of all)")
        ->type_name("all|methods|scenes|params|metrics|columns|skips|shadings|axes");
    command->add_flag("--json", args->is_json, "Print JSON instead of text");
    command->add_flag("--csv", args->is_csv, "Methods as methods.csv has them");
    command->add_flag("--markdown",
                      args->is_markdown,
                      "Columns as the data dictionary of a run folder (experiments/columns.md)");
    command->footer(
        "Example: inkbench list params\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] { fmt::print("{}", list_text(*args)); });
}

}  // namespace ink::cli
