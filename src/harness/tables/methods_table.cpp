#include "harness/tables/methods_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "harness/cell.h"
#include "harness/tables/csv.h"

namespace ink::harness {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kBaselines = {
    {{"none", "floor"}, {"sampled", "ceiling"}, {"oracle", "exact"}}};

/// The ends of what is searched, or the choices.
std::string range_of(const core::Param& param, const method::Tunable& tunable) {
    switch (param.kind) {
        case core::ParamKind::flag:
            return "false|true";
        case core::ParamKind::choice:
            return fmt::format("{}", fmt::join(param.choices, "|"));
        case core::ParamKind::real:
        case core::ParamKind::integer:
            break;
    }
    const auto [low, high] = tunable.range.value_or(std::pair(param.min, param.max));
    return fmt::format("{}..{}", low, high);
}

std::string tunables_of(const method::MethodInfo& method) {
    const std::vector<method::Tunable> threshold = {{"threshold"}};
    std::vector<std::string> texts;
    for (const auto& tunable : method.tunables.empty() ? threshold : method.tunables) {
        const auto param =
            std::find_if(method.params.begin(), method.params.end(), [&](const auto& each) {
                return each.name == tunable.param;
            });
        if (param == method.params.end()) continue;
        texts.push_back(fmt::format("{}:{}", param->name, range_of(*param, tunable)));
    }
    return fmt::format("{}", fmt::join(texts, ";"));
}

std::string line_of(const std::vector<std::string>& fields) {
    std::vector<std::string> quoted;
    for (const std::string& field : fields)
        quoted.push_back(csv_field(field));
    return fmt::format("{}", fmt::join(quoted, ","));
}

std::string line_of(const MethodConfig& config) {
    const method::MethodInfo& info = *config.info;
    const auto bytes = info.bytes_per_px(config.settings);
    return line_of({info.name,
                    "method",
                    std::string(name_of(info.family)),
                    std::string(name_of(info.marker)),
                    tunables_of(info),
                    bytes ? fmt::format("{}", *bytes) : "",
                    info.preset_of,
                    info.source,
                    join_params(info.complete(config.settings))});
}

}  // namespace

const std::vector<std::string>& method_columns() {
    static const std::vector<std::string> columns = {"method",
                                                     "role",
                                                     "family",
                                                     "marker",
                                                     "tunables",
                                                     "bytes_per_px",
                                                     "preset_of",
                                                     "source",
                                                     "params"};
    return columns;
}

std::string method_lines(const std::vector<MethodConfig>& configs) {
    std::vector<std::string> lines;
    for (const auto& [name, role] : kBaselines) {
        std::vector<std::string> fields(method_columns().size());
        fields[0] = name;
        fields[1] = role;
        lines.push_back(line_of(fields));
    }
    for (const MethodConfig& config : configs)
        lines.push_back(line_of(config));
    return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string methods_csv(const std::vector<MethodConfig>& configs) {
    return fmt::format("{}\n{}\n", fmt::join(method_columns(), ","), method_lines(configs));
}

}  // namespace ink::harness
