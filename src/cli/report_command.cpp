#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/run_result.h"
#include "experiment/run_data.h"

namespace ink::cli {

void add_report_command(CLI::App& app) {
    struct ReportArgs {
        std::string folder;
        std::string file;
    };
    auto args = std::make_shared<ReportArgs>();
    auto* command = app.add_subcommand(
        "report", "Make the page of a run from its folder alone, on any machine");
    command->add_option("run", args->folder, "Folder of a run")->required();
    command->add_option(
        "-o,--output", args->file, "HTML file (default: report.html in the folder)");
    command->footer(
        "Example: inkbench report inkbench-out -o report.html\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] {
        if (!args->file.empty()) check_output_path(args->file, {".html"});
        const experiment::RunData run = experiment::read_run(args->folder);
        fmt::print("report: {}\n", write_page(run, args->folder, args->file).string());
    });
}

}  // namespace ink::cli
