#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/help_format.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "core/error.h"
#include "core/param.h"
#include "core/provenance.h"
#include "core/whole_file.h"

namespace ink::cli {
namespace {

std::string version_text() {
    const auto& p = core::provenance();
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

/// "; did you mean --methods?", or "" if no option is near to `wrong`.
std::string nearest_option(const CLI::App& command, const std::string& wrong) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    }
    const std::string known = core::known_names(names, wrong.substr(0, wrong.find('=')));
    const auto hint = known.find("; did you mean");
    return hint == std::string::npos ? "" : known.substr(hint);
}

/// The first of the words that belong nowhere that looks like an option, or "".
std::string unknown_option(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        if (word.starts_with("-") && word != "--") return word;
    }
    return "";
}

/// What is wrong, without the help to see. A misspelt option is told before what is missing without
/// it.
std::string what_is_wrong(const CLI::App& command, const CLI::ParseError& error) {
    const std::vector<std::string> words = command.remaining();
    const bool is_extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    const bool is_missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    const std::string option = unknown_option(words);
    if ((is_extra || is_missing) && !option.empty())
        return fmt::format("there is no option {}{}", option, nearest_option(command, option));
    if (is_extra && !words.empty()) return fmt::format("nothing takes '{}'", fmt::join(words, " "));
    return error.what();
}

/// The whole command line of inkbench with all its commands, nothing parsed yet.
std::unique_ptr<CLI::App> make_program() {
    auto app = std::make_unique<CLI::App>(
        "Inkbench: which 3D outline method makes the fewest errors on a scene, at a time budget?",
        "inkbench");
    app->formatter(std::make_shared<HelpFormatter>());  // commands inherit it
    app->set_version_flag("--version", version_text, "Print the version, and those of libraries");
    app->set_help_flag("-h,--help", "Print this help");
    app->set_help_all_flag("--help-all", "Print all of it");  // commands inherit both
    app->require_subcommand(1);
    app->footer(
        "inkbench MODEL asks for advice; inkbench COMMAND --help says more of each.\n"
        "Example: inkbench compare --scenes torus,staircase --methods mote4,decaudin\n"
        "Exit codes: 0 done, 1 a check failed or nothing has a score, 2 bad input, " +
        std::string(kUnscoredCode) + ", 130 interrupted.");
#define INK_ADD(name) add_##name##_command(*app);
    INK_COMMANDS(INK_ADD)
#undef INK_ADD
    put_under_headings(*app);
    return app;
}

/// What is wrong with a command line, in one line that ends with the help to see: of the command
/// that was under way, if one was. An option that does not exist comes with the nearest one.
std::string complaint(const CLI::App& program, const CLI::ParseError& error) {
    const auto commands = program.get_subcommands();
    const CLI::App& at = commands.empty() ? program : *commands.back();
    const std::string command = commands.empty() ? "" : at.get_name() + " ";
    return fmt::format("{} (see inkbench {}--help)", what_is_wrong(at, error), command);
}

constexpr int kBadInput = 2;

/// One line, whatever the message holds: scripts read the first line of stderr.
int refuse(std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    message.erase(message.find_last_not_of(' ') + 1);
    std::fputs(fmt::format("inkbench: {}\n", message).c_str(), stderr);  // throws nothing
    return kBadInput;
}

/// Keeps files that are opened later from the numbers of streams that were closed: what is printed
/// would go into them. False if standard output is closed.
bool has_open_streams() {
    const auto is_open = [](int fd) { return fcntl(fd, F_GETFD) != -1; };
    const bool has_output = is_open(STDOUT_FILENO);
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (!is_open(fd)) (void)open("/dev/null", O_RDWR);  // takes the lowest free number
    }
    return has_output;
}

/// The exit code where standard output took not all. A pipe whose reader has gone ends the program
/// without a word, as its signal does where nobody ignores it.
int refuse_output(const std::string& reason) {
    constexpr int kBrokenPipe = 128 + SIGPIPE;
    pollfd output{STDOUT_FILENO, 0, 0};
    if (poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0) return kBrokenPipe;
    return refuse("standard output cannot be written" + (reason.empty() ? "" : ": " + reason));
}

/// The exit code, once all that was printed has arrived.
int finish(int code) {
    errno = 0;
    std::cout.flush();
    std::fflush(stdout);
    if (std::cout && std::ferror(stdout) == 0) return code;
    return refuse_output(errno == 0 ? "" : std::strerror(errno));
}

constexpr const char* kExamples =
    "inkbench bunny.obj                     which method draws this model best\n"
    "inkbench compare bunny.obj --quick     methods beside each other, as a page\n"
    "inkbench draw bunny.obj -o bunny.png   its lines\n"
    "inkbench page bunny.obj                its lines on your GPU, as a page\n"
    "\n"
    "inkbench --help names all commands, inkbench list scenes the models built in.\n";

/// The words of a command line. A model or scene in place of a command asks for advice.
std::vector<std::string> words_of(const CLI::App& app, int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty() || words[0].starts_with("-")) return words;
    const std::vector<std::string> names = command_names(app);
    if (std::ranges::count(names, words[0]) > 0) return words;
    std::error_code ignored;
    const bool is_scene = std::filesystem::is_regular_file(words[0], ignored) ||
                          std::ranges::count(scene_words(), words[0]) > 0;
    if (!is_scene)
        throw core::Error(
            words[0], "there is no such command or model", core::known_names(names, words[0]));
    words.insert(words.begin(), "advise");
    return words;
}

/// Does what the command line asks for and returns the exit code.
int run(int argc, char** argv) {
    const auto app = make_program();
    try {
        std::vector<std::string> words = words_of(*app, argc, argv);
        if (words.empty()) fmt::print("{}", kExamples);
        if (words.empty()) return finish(0);
        std::ranges::reverse(words);  // as the parser takes them
        app->parse(std::move(words));
    } catch (const CLI::RuntimeError& stop) {
        return finish(stop.get_exit_code());
    } catch (const CLI::Success& help) {
        return finish(app->exit(help));
    } catch (const CLI::ParseError& error) {
        return refuse(complaint(*app, error));
    } catch (const core::Error& error) {
        return refuse(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return refuse(core::refused_path(error).what());
    } catch (const std::bad_alloc&) {
        return refuse("there is not enough memory for this");
    } catch (const std::system_error& error) {
        const bool is_output = std::ferror(stdout) != 0;  // fmt could not print
        return is_output ? refuse_output(error.code().message()) : refuse(error.what());
    } catch (const std::exception& error) {
        const bool is_thread = std::string_view(error.what()).find("pthread") != std::string::npos;
        return refuse(is_thread ? "no thread can be started: there is not enough memory, or there "
                                  "are too many processes"
                                : error.what());
    }
    return finish(0);
}

}  // namespace
}  // namespace ink::cli

int main(int argc, char** argv) {
    using namespace ink::cli;
    if (!has_open_streams()) return refuse("standard output is closed");
    return run(argc, argv);
}
