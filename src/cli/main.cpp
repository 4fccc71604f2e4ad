#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program.h"
#include "core/error.h"
#include "core/param.h"
#include "core/system_reason.h"

namespace {

constexpr int kBadInput = 2;

/// One line, whatever the message holds: scripts read the first line of stderr.
int refuse(std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    message.erase(message.find_last_not_of(' ') + 1);
    fmt::print(stderr, "inkbench: {}\n", message);
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

}  // namespace

int main(int argc, char** argv) {
    const auto app = ink::cli::make_program();
    try {
        check_subcommand(*app, argc, argv);
        app->parse(argc, argv);
    } catch (const CLI::RuntimeError& stop) {
        return stop.get_exit_code();
    } catch (const CLI::Success& help) {
        return app->exit(help);
    } catch (const CLI::ParseError& error) {
        return refuse(ink::cli::complaint(*app, error));
    } catch (const ink::core::Error& error) {
        return refuse(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return refuse(ink::core::refused_path(error).what());
    } catch (const std::bad_alloc&) {
        return refuse("there is not enough memory for this");
    }
    return 0;
}
