#include "cli/options/command_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ink::cli {

std::string called(const std::string& spellings) {
    const std::size_t begin = spellings.starts_with("--") ? 0 : spellings.find("--");
    const std::string name = spellings.substr(begin == std::string::npos ? 0 : begin);
    return name.substr(0, name.find(','));
}

CLI::Option* CommandRows::value(core::Param param,
                                const std::string& usual,
                                const std::function<void(double)>& store) {
    const std::string type =
        param.choices.empty() ? param.unit : fmt::format("{}", fmt::join(param.choices, "|"));
    const auto read = [param, store, where = called(param.name)](const std::string& text) {
        store(core::parse_param(param, {text, where}, "it"));
    };
    return command_.add_option_function<std::string>(param.name, read, param.doc)
        ->type_name(type)
        ->default_str(usual);
}

}  // namespace ink::cli
