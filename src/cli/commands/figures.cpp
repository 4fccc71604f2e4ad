#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/name_list.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"
#include "core/error.h"
#include "core/program_folder.h"
#include "core/split_list.h"
#include "core/whole_file.h"
#include "experiment/options/option_table.h"
#include "experiment/run_data.h"
#include "harness/cells/cell.h"
#include "summary/summary_csv.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScript = "figures.py";
constexpr const char* kPackages =
    "Python 3.11 with pandas and matplotlib, on Debian: apt-get install python3 python3-pandas "
    "python3-matplotlib; INKBENCH_PYTHON names another Python";

std::string python() {
    const char* named = std::getenv("INKBENCH_PYTHON");
    return named != nullptr && *named != '\0' ? named : "/usr/bin/python3";
}

/// What is installed beside the program comes first: the tree it was built from may be gone, or
/// another version by now.
fs::path script() {
    std::error_code error;
    const fs::path installed =
        core::program_folder() / INK_SHARE_FROM_PROGRAM / "notebooks" / kScript;
    for (const fs::path& file : {installed, fs::path(INK_SOURCE_NOTEBOOKS) / kScript})
        if (fs::is_regular_file(file, error)) return file.lexically_normal();
    throw core::Error("figures",
                      fmt::format("the script {} is not there", kScript),
                      fmt::format("{} or {}",
                                  installed.lexically_normal().string(),
                                  (fs::path(INK_SOURCE_NOTEBOOKS) / kScript).string()));
}

/// As exec takes them; valid as long as `words` is.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Runs notebooks/figures.py with these arguments; what it prints goes where the program's own
/// output goes. Returns its exit code, 128 + signal if it was killed.
///
/// Python is $INKBENCH_PYTHON, or /usr/bin/python3. The script is that of the install prefix
/// (share/inkbench/notebooks), or of the source tree that the program was built from. Throws
/// core::Error, which says what to install, if Python cannot be started or the script is in neither
/// place.
int run_figures_script(const std::vector<std::string>& arguments) {
    const std::string program = python();
    // -B: no compiled files beside the script.
    std::vector<std::string> words = {program, "-B", script().string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    pid_t child = -1;
    const int failure =
        posix_spawnp(&child, program.c_str(), nullptr, nullptr, pointers_to(words).data(), environ);
    if (failure != 0) {
        throw core::Error(
            program, fmt::format("it cannot be started ({})", std::strerror(failure)), kPackages);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

// Between them every class of line, and depth and normals that cancel.
constexpr const char* kUsualScenes = "figure,staircase,flag,tiles";

/// Of the run, if one is made; run folders stand among the scenes.
struct FiguresArgs : MeasureArgs {
    FiguresArgs() : MeasureArgs("figures", "inkbench-figures") {
        experiment::Experiment& usual = options.usual();
        usual.repetitions = 9;
        usual.budget_ms = harness::MeasureOptions{}.budget_s * 1e3;
        usual.crosscheck = false;
        usual.compare.images = experiment::KeptImages::all;
    }

    /// Of the script, which reads and checks them: by option, what was given.
    std::map<std::string, std::vector<std::string>> of_script;
};

struct ScriptOption {
    const char* name;
    const char* unit;
    const char* doc;
};
// clang-format off
constexpr ScriptOption kScriptOptions[] = {
    {"--format", "A,B", "Of pdf, svg, png, as a,b (default: svg,png)"},
    {"--width", "LENGTH",
     "Of each figure, in mm, cm, in or pt (default: 178mm, two columns of a journal)"},
    {"--font-size", "PT", "Of text, in points (default: 8)"},
    {"--window", "X,Y,W,H",
     "Zoomed part of strips in pixels; may be given again (default: the one in which the "
     "methods' errors differ most)"},
    {"--only", "A,B",
     "These figures alone, as strips,error_time; figures.md names all (default: all)"}};
// clang-format on

/// The names of these options and of some others.
std::vector<std::string> script_options_and(const char* others) {
    std::vector<std::string> names = core::split_list(others);
    for (const ScriptOption& option : kScriptOptions)
        names.emplace_back(option.name);
    return names;
}

/// Takes the run folders out of what stands by itself; the rest are scenes.
std::vector<std::string> take_runs(SceneOptions& scenes) {
    std::vector<std::string> runs;
    std::erase_if(scenes.named, [&runs](const std::string& word) {
        const bool is_folder = fs::is_directory(word);
        if (is_folder) runs.push_back(word);
        return is_folder;
    });
    return runs;
}

std::vector<std::string> script_options(const FiguresArgs& args) {
    std::vector<std::string> words = {"--out=" + args.folder.out};
    for (const auto& [option, texts] : args.of_script) {
        for (const std::string& text : texts)
            words.push_back(option + "=" + text);
    }
    return words;
}

/// Ends the command unless the script did its work; it has said what is wrong.
void run_script(const std::vector<std::string>& words) {
    std::fflush(stdout);
    if (const int code = run_figures_script(words); code != 0) throw CLI::RuntimeError(code);
}

/// What can be wrong with the script's options is found before any work.
void check_script_options(std::vector<std::string> words) {
    words.emplace_back("--check");
    run_script(words);
}

/// Options that say how a run is made mean nothing for one that is there.
void refuse_run_options(const CLI::App& command) {
    const std::vector<std::string> of_figures =
        script_options_and("--out, --methods, --scenes, --views, --cache, --no-cache, --quiet");
    for (const CLI::Option* option : command.get_options()) {
        const bool is_of_run =
            std::none_of(of_figures.begin(), of_figures.end(), [&](const std::string& name) {
                return option->check_name(name);
            });
        if (option->count() > 0 && is_of_run && !option->get_positional())
            throw core::Error(option->get_name(), "the run is made already", "no RUN beside it");
    }
}

/// summary.csv and differences.csv of a run's folder are over all its scenes. Writes those of the
/// scenes that are asked for into the folder of the figures, by the run's own rule, average
/// precision left out; false if no run has such tables.
bool wrote_tables_of_scenes(const FiguresArgs& args, const std::vector<std::string>& folders) {
    for (const std::string& folder : folders) {
        experiment::RunData run = experiment::read_run(folder);
        std::vector<harness::Row>& rows = run.tables.rows;
        if (!run.csv.contains("summary.csv")) continue;
        NameList known;
        for (const harness::Row& row : rows)
            known.add_implied(row.scene);
        const auto scenes = listed_names(args.scenes.listed, {"--scenes", "scene", known.names()});
        std::erase_if(rows, [&](const harness::Row& row) {
            return std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end();
        });
        const fs::path out = args.folder.out;
        fs::create_directories(out);
        const auto comparison = summary::compare_methods(rows, run.record.answer);
        for (const auto& [name, text] : summary::comparison_tables(rows, comparison))
            core::write_whole_file(out / name, text);
        return true;
    }
    return false;
}

void show_runs(const FiguresArgs& args,
               const std::vector<std::string>& runs,
               const CLI::App& command) {
    refuse_run_options(command);
    if (!args.scenes.named.empty()) {
        throw core::Error("figures",
                          fmt::format("'{}' is no folder", args.scenes.named.front()),
                          "run folders, or scenes and models, but not both");
    }
    std::vector<std::string> words = script_options(args);
    if (!args.methods.empty())
        words.push_back(fmt::format("--methods={}", fmt::join(args.methods, ",")));
    if (!args.scenes.listed.empty()) {
        words.push_back(fmt::format("--scenes={}", fmt::join(args.scenes.listed, ",")));
        check_script_options(words);
        if (wrote_tables_of_scenes(args, runs)) words.emplace_back("--tables-of-scenes");
    }
    for (const std::string& views : args.options.given("views.views"))
        words.push_back("--views=" + views);
    words.emplace_back("--");
    words.insert(words.end(), runs.begin(), runs.end());
    run_script(words);
}

experiment::Experiment experiment_of(const FiguresArgs& args) {
    experiment::Experiment experiment = args.read();
    if (experiment.scenes.empty()) experiment.scenes = core::split_list(kUsualScenes);
    if (!args.options.has_views()) experiment.compare.views = 1;
    experiment.compare.own_sweep_views = 0;
    return experiment;
}

/// Makes the run first.
void make_and_show(const FiguresArgs& args, const CLI::App& command) {
    experiment::Experiment experiment = experiment_of(args);
    experiment.command = recorded_command(command, script_options_and("--out, --force"));
    std::vector<std::string> words = script_options(args);
    words.emplace_back("--scenes=*");
    words.emplace_back("--views=all");
    check_script_options(words);
    const fs::path run = fs::path(args.folder.out) / "run";
    int code = 0;
    try {
        const RunFolderOptions folder{.out = run.string(), .is_forced = args.folder.is_forced};
        run_to_end(command, experiment, folder, args.cache);
    } catch (const CLI::RuntimeError& end) {
        code = end.get_exit_code();
        if (code != 3) throw;  // 3: views without a score, which are left out of figures
    }
    words.emplace_back("--");
    words.push_back(run.string());
    run_script(words);
    if (code != 0) throw CLI::RuntimeError(code);
}

void add_script_options(CLI::App& command, FiguresArgs& args) {
    CommandRows rows(command);
    for (const auto& [name, unit, doc] : kScriptOptions)
        rows.list(name, args.of_script[name], unit, doc);
}

}  // namespace

void add_figures_command(CLI::App& app) {
    auto args = std::make_shared<FiguresArgs>();
    args->options.usual().sizes = {{640, 360}};
    auto* command = app.add_subcommand(
        "figures",
        "Make figures for papers from run folders, or from scenes and methods: strips, error "
        "against time, classes, stress, tables");
    add_scene_options(*command,
                      args->scenes,
                      fmt::format("Run folders; or built-in scenes or model files, of which a run "
                                  "is made first (default: {})",
                                  kUsualScenes));
    add_method_options(*command, args->methods);
    add_script_options(*command, *args);
    add_set_option(*command, args->settings);
    ExperimentOptions& options = args->options;
    options.add_to(*command, {"grid.entrants", "measure.entrant_seconds"});
    options.add_to(*command, experiment::view_rows());
    add_out_folder_option(*command,
                          args->folder.out,
                          "Folder for the figures, figures.md, which lists them, and run/, if one "
                          "is made");
    options.add_to(*command, truth_rows());
    options.add_to(*command, {"grid.threads", "measure.repetitions"});
    options.add_to(*command, {"seed"}, "Of intervals and random images");
    CommandRows(*command).flag(
        "--force", args->folder.is_forced, "Throw away the run that is in the folder's run/");
    add_cache_options(*command, args->cache);
    add_quiet_option(*command);
    command->footer(
        "Without a run, one view of each scene is drawn, its first; --views N draws N round it.\n"
        "Figures need Python 3 with pandas and matplotlib (Debian: python3-pandas "
        "python3-matplotlib).\n"
        "Example: inkbench figures inkbench-out/compare --format pdf --width 84mm --out figs\n"
        "         inkbench figures --scenes torus,staircase --methods mote4,decaudin --out figs\n"
        "Exit codes: 0 done, 1 nothing has a score, 2 bad input, " +
        std::string(kUnscoredCode) + ", 130 interrupted.");
    command->callback([args, command] {
        const std::vector<std::string> runs = take_runs(args->scenes);
        if (runs.empty()) {
            make_and_show(*args, *command);
        } else {
            show_runs(*args, runs, *command);
        }
    });
}

}  // namespace ink::cli
