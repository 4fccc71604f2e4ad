#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "core/error.h"
#include "core/param.h"
#include "core/provenance.h"

namespace {

constexpr int kBadInput = 2;

std::string version_text() {
    const auto& p = ink::core::provenance();
    std::string text = fmt::format("inkbench {} ({}{}), {}, {}\n",
                                   p.version,
                                   p.commit,
                                   p.dirty ? ", changed" : "",
                                   p.compiler,
                                   p.flags);
    for (const auto& [name, version] : p.libraries)
        text += fmt::format("{} {}\n", name, version);
    text.pop_back();
    return text;
}

/// One line, whatever the message holds: scripts read the first line of stderr.
std::string one_line(std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    while (!message.empty() && message.back() == ' ')
        message.pop_back();
    return message;
}

int refuse(const std::string& message) {
    fmt::print(stderr, "inkbench: {}\n", one_line(message));
    return kBadInput;
}

void check_subcommand(const CLI::App& app, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return;
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({}))
        names.push_back(command->get_name());
    if (std::find(names.begin(), names.end(), argv[1]) == names.end()) {
        throw ink::core::Error(
            argv[1], "there is no such command", ink::core::known_names(names, argv[1]));
    }
}

int run(CLI::App& app, int argc, char** argv) {
    try {
        check_subcommand(app, argc, argv);
        app.parse(argc, argv);
    } catch (const CLI::RuntimeError& stop) {
        return stop.get_exit_code();
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return refuse(fmt::format("{} (see inkbench --help)", error.what()));
    } catch (const ink::core::Error& error) {
        return refuse(error.what());
    } catch (const std::bad_alloc&) {
        return refuse("there is not enough memory for this");
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Inkbench: which 3D outline method makes the fewest errors on a scene, at a time budget?",
        "inkbench"};
    app.set_version_flag("--version", version_text);
    app.require_subcommand(1);
    app.footer("Example: inkbench compare --scenes torus,staircase --methods mote4,decaudin");
    ink::cli::add_compare_command(app);
    ink::cli::add_draw_command(app);
    ink::cli::add_truth_command(app);
    ink::cli::add_score_command(app);
    ink::cli::add_explain_command(app);
    ink::cli::add_figures_command(app);
    ink::cli::add_timedemo_command(app);
    ink::cli::add_tune_command(app);
    ink::cli::add_stress_command(app);
    ink::cli::add_run_command(app);
    ink::cli::add_report_command(app);
    ink::cli::add_merge_command(app);
    ink::cli::add_bound_command(app);
    ink::cli::add_list_command(app);
    return run(app, argc, argv);
}
