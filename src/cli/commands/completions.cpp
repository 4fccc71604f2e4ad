#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/options/method_options.h"
#include "cli/options/scene_options.h"
#include "core/error.h"
#include "experiment/options/option_table.h"

namespace ink::cli {
namespace {

/// The words that may stand for a value, by its type as --help calls it ("METHODS").
using ValueWords = std::map<std::string, std::vector<std::string>>;

constexpr const char* kHead =
    R"(# Completion of inkbench in bash, as `inkbench completions bash` prints it.
# Once: source <(inkbench completions bash). For good: into the folder of bash-completion,
# as `cmake --install` puts it. zsh reads it, too.

if [ -n "${ZSH_VERSION-}" ]; then
    autoload -U +X compinit && compinit
    autoload -U +X bashcompinit && bashcompinit
fi

# The last part of the list $1, of the words $2.
_inkbench_list() {
    local last="${1##*,}"
    COMPREPLY=( $(compgen -P "${1%"$last"}" -W "$2" -- "$last") )
}

_inkbench() {
    local cur="${COMP_WORDS[COMP_CWORD]}" prev="${COMP_WORDS[COMP_CWORD-1]}"
    COMPREPLY=()
    # "--option=value" comes as three words.
    if [ "$cur" = "=" ]; then
        cur=""
    elif [ "$prev" = "=" ]; then
        prev="${COMP_WORDS[COMP_CWORD-2]}"
    fi
)";

constexpr const char* kTail = R"(}
complete -o bashdefault -o default -F _inkbench inkbench
)";

std::string joined(const std::vector<std::string>& words, const char* between = " ") {
    return fmt::format("{}", fmt::join(words, between));
}

std::vector<std::string> spellings(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames())
        names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        names.push_back("--" + name);
    return names;
}

/// What may stand for a value of this type; a choice says it itself, in words that are not
/// capitals.
std::vector<std::string> words_of(const std::string& type, const ValueWords& words) {
    if (const auto found = words.find(type); found != words.end()) return found->second;
    std::vector<std::string> choices;
    if (type.find('|') == std::string::npos) return choices;
    std::istringstream parts(type);
    for (std::string part; std::getline(parts, part, '|');) {
        const bool is_placeholder = std::any_of(
            part.begin(), part.end(), [](unsigned char c) { return std::isupper(c) != 0; });
        if (!is_placeholder) choices.push_back(part);
    }
    return choices;
}

/// The lines of a `case` by which the values of all options are completed, one for each list of
/// words.
std::string value_cases(const CLI::App& program, const ValueWords& words) {
    std::map<std::string, std::vector<std::string>> patterns;
    std::vector<std::string> others;
    for (const CLI::App* command : program.get_subcommands({})) {
        for (const CLI::Option* option : command->get_options()) {
            if (option->get_type_size() == 0) continue;
            const std::string list = joined(words_of(option->get_type_name(), words));
            for (const std::string& name : spellings(*option)) {
                (list.empty() ? others : patterns[list])
                    .push_back(command->get_name() + ":" + name);
            }
        }
    }
    std::string text;
    for (const auto& [list, names] : patterns) {
        text += fmt::format(
            "        {})\n            _inkbench_list \"$cur\" \"{}\"\n"
            "            return ;;\n",
            joined(names, "|\\\n        "),
            list);
    }
    return text +
           fmt::format("        {})\n            return ;;\n", joined(others, "|\\\n        "));
}

/// What a command takes besides: its options, and words for its arguments.
std::string command_cases(const CLI::App& program, const ValueWords& words) {
    std::string text;
    for (const CLI::App* command : program.get_subcommands({})) {
        std::vector<std::string> options;
        std::vector<std::string> arguments;
        for (const CLI::Option* option : command->get_options()) {
            const auto names = spellings(*option);
            options.insert(options.end(), names.begin(), names.end());
            if (!option->get_positional()) continue;
            const auto values = words_of(option->get_type_name(), words);
            arguments.insert(arguments.end(), values.begin(), values.end());
        }
        text += fmt::format(
            "        {})\n            options=\"{}\"\n            arguments=\"{}\" ;;\n",
            command->get_name(),
            joined(options),
            joined(arguments));
    }
    return text;
}

/// A script by which bash completes the commands of `program`, their options, and the values of
/// options and arguments whose type is in `words` or is a choice "a|b|c"; file names elsewhere.
/// Lists a,b are completed at their last part. zsh takes it through bashcompinit.
std::string bash_completions(const CLI::App& program, const ValueWords& words) {
    std::vector<std::string> first = command_names(program);
    for (const CLI::Option* option : program.get_options()) {
        const auto names = spellings(*option);
        first.insert(first.end(), names.begin(), names.end());
    }
    std::string text = kHead;
    text += fmt::format(
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        _inkbench_list \"$cur\" \"{}\"\n        return\n    fi\n",
        joined(first));
    text += "    case \"${COMP_WORDS[1]}:$prev\" in\n" + value_cases(program, words) + "    esac\n";
    text += "    local options=\"\" arguments=\"\"\n    case \"${COMP_WORDS[1]}\" in\n" +
            command_cases(program, words) + "    esac\n";
    text +=
        "    case \"$cur\" in\n        -*) _inkbench_list \"$cur\" \"$options\" ;;\n"
        "        *) _inkbench_list \"$cur\" \"$arguments\" ;;\n    esac\n";
    return text + kTail;
}

ValueWords value_words(const CLI::App& program) {
    ValueWords words;
    words["METHODS"] = words["METHOD"] = method_words();
    words["SCENES"] = words["SCENE"] = scene_words();
    for (const core::Param& param : experiment::option_table().rows.params())
        if (param.kind == core::ParamKind::list && !param.choices.empty())
            words[param.unit] = param.choices;
    words["COMMAND"] = command_names(program);
    return words;
}

}  // namespace

void add_completions_command(CLI::App& app) {
    auto shell = std::make_shared<std::string>();
    auto* command = app.add_subcommand(
        "completions", "Print the script by which a shell completes commands, options and names");
    command->add_option("shell", *shell, "The shell; zsh reads bash's script")
        ->type_name("bash|zsh")
        ->required();
    command->footer(
        "Example: source <(inkbench completions bash)\n"
        "For good: inkbench completions bash > "
        "~/.local/share/bash-completion/completions/inkbench\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([shell, &app] {
        if (*shell != "bash" && *shell != "zsh") {
            throw core::Error(
                "completions", fmt::format("there is no script for '{}'", *shell), "bash, zsh");
        }
        fmt::print("{}", bash_completions(app, value_words(app)));
    });
}

}  // namespace ink::cli
