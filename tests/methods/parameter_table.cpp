#include "tests/methods/parameter_table.h"

#include <fmt/format.h>

namespace ink::methods {
namespace {

/// A bar would end a Markdown cell.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

}  // namespace

std::string parameter_table(const method::MethodInfo& method) {
    std::string table =
        "| parameter | default | values | unit | meaning |\n|---|---|---|---|---|\n";
    for (const core::Param& param : method.params) {
        table += fmt::format("| `{}` | `{}` | {} | {} | {} |\n",
                             param.name,
                             core::format_param(param, param.default_value),
                             cell(core::accepted_values(param)),
                             param.unit,
                             cell(param.doc));
    }
    return table;
}

}  // namespace ink::methods
