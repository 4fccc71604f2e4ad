#include "cli/help_format.h"

#include <algorithm>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ink::cli {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kLeft = 24;          // where descriptions of options begin
constexpr std::size_t kLeftCommand = 16;   // and of commands
constexpr std::ptrdiff_t kMostLines = 44;  // of options; what stands above and below takes a dozen

/// A heading, and all that stands under it in whatever command.
using Heading = std::pair<const char*, const char*>;
constexpr Heading kOfCommands[] = {
    {"Which method", "advise compare explain tune stress run"},
    {"Lines of one model", "draw truth page bake export figures timedemo"},
    {"Scores and runs", "score report diff merge"},
    {"Methods of your own", "entrant-test new-method"},
    {"Help", "list help"}};
constexpr Heading kOfOptions[] = {
    {"Camera",
     "projection parallel fit margin object eye target up fov time frame animation seams"},
    {"Methods", "set model-list preset entrant entrant-seconds antialias line-width no-skip"},
    {"Truth",
     "crease weld-epsilon intersections creases no-crosscheck polarity band ignore no-thin"},
    {"Looks", "set-shade ink paper surface dither no-lines layer"},
    {"Drawing for print", "hidden sheet-width sheet scale"},
    {"Science", "seed coverage sweep-views no-sweep images motion global no-random"},
    {"Work", "shard force no-times lanes dry-run status threads repetitions cache no-cache"}};

/// The heading that `name` stands under, or `otherwise`.
std::string heading_of(std::span<const Heading> headings,
                       const std::string& name,
                       const std::string& otherwise) {
    for (const auto& [heading, names] : headings)
        if ((" " + std::string(names) + " ").find(" " + name + " ") != std::string::npos)
            return heading;
    return otherwise;
}

/// A name and what it means beside it, or below it if the name is long.
std::string entry(const std::string& name, const std::string& meaning, std::size_t left = kLeft) {
    std::string text = "  " + name;
    if (meaning.empty()) return text + "\n";
    if (text.size() + 2 > left) text += "\n" + std::string(left, ' ');
    const auto begin = text.find_last_of('\n') + 1;
    text.resize(std::max(text.size(), begin + left), ' ');
    return text + wrapped(meaning, kWidth, left) + "\n";
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
    std::string result;
    std::istringstream lines(text);
    bool is_first_line = true;
    for (std::string line; std::getline(lines, line); is_first_line = false) {
        if (!is_first_line) result += "\n" + std::string(indent, ' ');
        std::size_t column = indent;
        std::istringstream words(line);
        bool is_first_word = true;
        for (std::string word; words >> word; is_first_word = false) {
            if (!is_first_word && column + 1 + word.size() > width) {
                result += "\n" + std::string(indent, ' ');
                column = indent;
            } else if (!is_first_word) {
                result += ' ';
                ++column;
            }
            result += word;
            column += word.size();
        }
    }
    return result;
}

void put_under_headings(CLI::App& program) {
    for (CLI::App* command : program.get_subcommands({})) {
        command->group(heading_of(kOfCommands, command->get_name(), command->get_group()));
        for (CLI::Option* option : command->get_options()) {
            const std::vector<std::string>& names = option->get_lnames();
            if (!names.empty())
                option->group(heading_of(kOfOptions, names.front(), option->get_group()));
        }
    }
}

HelpFormatter::HelpFormatter() {
    label("SUBCOMMAND", "COMMAND");
    label("Subcommands", "Commands");
    label("Positionals", "Arguments");
    label("INT", "N");
    label("UINT", "N");
    label("FLOAT", "NUMBER");
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
    return wrapped(app->get_description(), kWidth, 0) + "\n";
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
    // Lines with a command stay whole: they are there to be copied.
    std::istringstream lines(app->get_footer());
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        const bool is_command = line.find("inkbench ") != std::string::npos;
        text += (is_command ? line : wrapped(line, kWidth, 0)) + "\n";
    }
    return text;
}

std::string HelpFormatter::make_help(const CLI::App* app,
                                     std::string name,
                                     CLI::AppFormatMode mode) const {
    if (mode == CLI::AppFormatMode::Sub) return Formatter::make_help(app, std::move(name), mode);
    return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
           options_text(app, mode) + make_subcommands(app, mode) + "\n" + make_footer(app);
}

std::string HelpFormatter::options_text(const CLI::App* app, CLI::AppFormatMode mode) const {
    std::string all;
    std::string brief;
    std::string named;
    for (const std::string& group : app->get_groups()) {
        const auto options = app->get_options([&](const CLI::Option* option) {
            return option->get_group() == group && option->nonpositional();
        });
        if (options.empty()) continue;
        const std::string whole = make_group(group, false, options);
        all += whole;
        if (group == app->get_help_ptr()->get_group()) {
            brief += whole;
            continue;
        }
        std::string names = group + ":";
        for (const CLI::Option* option : options)
            names += " " + option->get_name();
        named += "  " + wrapped(names, kWidth, 4) + "\n";
    }
    brief += "\nExplained by --help-all:\n" + named;
    const bool is_short = std::ranges::count(all, '\n') <= kMostLines;
    return mode == CLI::AppFormatMode::Normal && !is_short ? brief : all;
}

std::string HelpFormatter::make_subcommand(const CLI::App* sub) const {
    const std::string what = sub->get_description();
    return entry(
        sub->get_display_name(true), what.substr(0, what.find_first_of(":;")), kLeftCommand);
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
    const std::string name = make_option_name(option, is_positional);
    std::string values = make_option_opts(option);
    // An argument that is called like its type: once will do.
    if (is_positional && values.starts_with(" " + name)) values.erase(0, name.size() + 1);
    return entry(name + values, make_option_desc(option));
}

std::string HelpFormatter::make_option_usage(const CLI::Option* option) const {
    const bool is_text = !option->get_option_text().empty();
    return is_text ? make_option_name(option, true) : Formatter::make_option_usage(option);
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
    if (!option->get_option_text().empty()) return " " + option->get_option_text();
    if (option->get_type_size() == 0 || option->get_type_name().empty()) return "";
    const bool is_list = option->get_expected_max() == CLI::detail::expected_max_vector_size;
    return " " + get_label(option->get_type_name()) + (is_list ? " ..." : "");
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
    std::string text = option->get_description();
    if (!option->get_default_str().empty()) text += " (default: " + option->get_default_str() + ")";
    if (option->get_required()) text += " (required)";
    return text;
}

}  // namespace ink::cli
