#include "cli/help_format.h"

#include <sstream>

namespace ink::cli {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kLeft = 24;  // where descriptions begin

/// A name and what it means beside it, or below it if the name is long.
std::string entry(const std::string& name, const std::string& meaning) {
    std::string text = "  " + name;
    if (meaning.empty()) return text + "\n";
    if (text.size() + 2 > kLeft) text += "\n" + std::string(kLeft, ' ');
    const auto begin = text.find_last_of('\n') + 1;
    text.resize(std::max(text.size(), begin + kLeft), ' ');
    return text + wrapped(meaning, kWidth, kLeft) + "\n";
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

std::string HelpFormatter::make_subcommand(const CLI::App* sub) const {
    return entry(sub->get_display_name(true), sub->get_description());
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
