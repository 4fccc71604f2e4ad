#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/options/options.h"
#include "core/error.h"
#include "experiment/run_data.h"
#include "report/run_page.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

struct ReportArgs {
    std::vector<std::string> folders;
    std::string file;
};

/// Where the page goes: beside the tables of a single run, else where the user says.
fs::path page_path(const ReportArgs& args) {
    if (!args.file.empty()) {
        check_output_path(args.file, {".html"});
        return args.file;
    }
    if (args.folders.size() == 1) return fs::path(args.folders.front()) / "report.html";
    throw core::Error(
        "report", "several runs have no folder in common for their page", "-o FILE.html");
}

/// Says on stderr which images of a run are empty. The page opens those that it shows, and refuses
/// them; figures need the others.
void print_empty_images(const fs::path& run) {
    std::vector<std::string> empty;
    std::error_code failure;
    for (auto entry = fs::recursive_directory_iterator(run / "images", failure);
         !failure && entry != fs::recursive_directory_iterator();
         entry.increment(failure)) {
        if (entry->is_regular_file() && entry->file_size() == 0)
            empty.push_back(entry->path().string());
    }
    std::sort(empty.begin(), empty.end());
    for (const std::string& file : empty)
        fmt::print(stderr, "inkbench: {}: the file is empty\n", file);
}

}  // namespace

void add_report_command(CLI::App& app) {
    auto args = std::make_shared<ReportArgs>();
    auto* command = app.add_subcommand(
        "report",
        "Make the page of a run, or of several beside each other, from their folders alone");
    command->add_option("run", args->folders, "Folders of runs")->required();
    command->add_option("-o,--output",
                        args->file,
                        "HTML file (default, of a single run: report.html in its folder)");
    command->footer(
        "With several runs the page says what was asked differently, and shows the differences of\n"
        "their results with their intervals.\n"
        "Example: inkbench report before after -o report.html\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] {
        const fs::path file = page_path(*args);
        std::vector<experiment::RunData> runs;
        for (const std::string& folder : args->folders)
            runs.push_back(experiment::read_run(folder));
        report::write_run_page(runs, file);
        fmt::print("report: {}\n", file.string());
        for (const std::string& folder : args->folders)
            print_empty_images(folder);
    });
}

}  // namespace ink::cli
