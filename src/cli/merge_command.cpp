#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "experiment/experiment_run.h"

namespace ink::cli {
namespace {

struct MergeArgs {
    std::vector<std::string> folders;
    std::string out;
};

void run_merge(const MergeArgs& args) {
    const experiment::RunOutcome outcome =
        experiment::merge_shards({args.folders.begin(), args.folders.end()}, args.out);
    for (const std::filesystem::path& table : outcome.tables)
        fmt::print("{}\n", table.string());
    for (const std::string& fault : outcome.faults)
        fmt::print(stderr, "inkbench: this run is void: {}\n", fault);
    if (!outcome.faults.empty()) throw CLI::RuntimeError(1);
}

}  // namespace

void add_merge_command(CLI::App& app) {
    auto args = std::make_shared<MergeArgs>();
    auto* command = app.add_subcommand(
        "merge", "Join the shards of an experiment to the tables that one run would write");
    command->add_option("folders", args->folders, "Folders of inkbench run --shard i/n")
        ->required();
    command->add_option("-o,--out", args->out, "Folder of the tables")->required();
    command->footer(
        "Example: inkbench merge part1 part2 part3 -o inkbench-out/quality\n"
        "Exit codes: 0 done, 1 the run is void, 2 bad input: shards missing, twice, or of another "
        "plan.");
    command->callback([args] { run_merge(*args); });
}

}  // namespace ink::cli
