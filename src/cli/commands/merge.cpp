#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "experiment/experiment_run.h"

namespace ink::cli {
namespace {

struct MergeArgs {
    std::vector<std::string> folders;
    std::string out;
    bool is_partial = false;
};

}  // namespace

void add_merge_command(CLI::App& app) {
    auto args = std::make_shared<MergeArgs>();
    auto* command = app.add_subcommand(
        "merge", "Join the shards of a run to the folder that one run would write");
    CommandRows rows(*command);
    rows.text("folders", args->folders, "DIR", "Folders of --shard i/n")->required();
    add_out_folder_option(*command, args->out, "Folder of the joined run")->required();
    rows.flag("--partial",
              args->is_partial,
              "Take what is there: tables and page of a run that is not finished");
    command->footer(
        "Example: inkbench merge part1 part2 part3 --out inkbench-out/quality\n"
        "Exit codes: 0 done; 1 the run is invalid or nothing has a score; 2 bad input: shards "
        "missing, twice, or of another run; " +
        std::string(kUnscoredCode) + ".");
    command->callback([args] {
        const experiment::RunOutcome outcome = experiment::merge_shards(
            {args->folders.begin(), args->folders.end()}, args->out, args->is_partial);
        conclude(outcome, args->out);
    });
}

}  // namespace ink::cli
