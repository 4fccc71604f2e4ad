#include "cli/options/method_options.h"

#include <fmt/format.h>

#include "cli/name_list.h"
#include "cli/options/command_rows.h"
#include "core/error.h"
#include "core/named.h"
#include "methods/registry.h"

namespace ink::cli {
namespace {

std::string comma_joined(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ","));
}

}  // namespace

void add_method_options(CLI::App& command,
                        std::vector<std::string>& texts,
                        const std::string& usual) {
    CommandRows(command).list(
        "--methods,--method",
        texts,
        "METHODS",
        fmt::format(
            "Methods a,b or globs such as 'mote*' (see inkbench list methods) (default: {})",
            usual));
}

void add_one_method_option(CLI::App& command,
                           std::vector<std::string>& texts,
                           const std::string& usual,
                           const std::string& doc) {
    CommandRows(command).list("--method,--methods", texts, "METHOD", doc)->default_str(usual);
}

std::vector<std::string> method_words() {
    return core::names_of(methods::registry());
}

std::string method_list(const std::vector<std::string>& texts) {
    return comma_joined(listed_names(texts, {"--methods", "method", method_words()}));
}

std::string one_method(const std::vector<std::string>& texts,
                       const std::string& usual,
                       const std::string& option) {
    if (texts.empty()) return usual;
    const auto names = listed_names(texts, {option, "method", method_words()});
    if (names.size() == 1) return names.front();
    throw core::Error(option,
                      fmt::format("'{}' is not one method", comma_joined(names)),
                      "one name of inkbench list methods");
}

void add_set_option(CLI::App& command, std::vector<std::string>& settings, const std::string& doc) {
    CommandRows(command).list(
        "--set", settings, "KEY=VALUE", doc + "; may be given again (see inkbench list params)");
}

}  // namespace ink::cli
