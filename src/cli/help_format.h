#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace ink::cli {

/// `text` broken at blanks into lines of at most `width` characters, each after the first with
/// `indent` blanks before it; line breaks in the text stay. A longer word has a line of its own.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

/// Gives the commands of the program, and the options of each, the headings of help.
void put_under_headings(CLI::App& program);

/// --help as 80 columns hold it: options to the left, what they do beside them, defaults at the end
/// of that. Where they are many, those under headings of their own are named alone, unless
/// --help-all asks for all.
class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter();
    std::string make_help(const CLI::App* app,
                          std::string name,
                          CLI::AppFormatMode mode) const override;
    std::string make_description(const CLI::App* app) const override;
    std::string make_footer(const CLI::App* app) const override;
    std::string make_subcommand(const CLI::App* sub) const override;
    std::string make_option(const CLI::Option* option, bool is_positional) const override;
    std::string make_option_usage(const CLI::Option* option) const override;
    std::string make_option_opts(const CLI::Option* option) const override;
    std::string make_option_desc(const CLI::Option* option) const override;

  private:
    [[nodiscard]] std::string options_text(const CLI::App* app, CLI::AppFormatMode mode) const;
};

}  // namespace ink::cli
