#include "harness/rows/methods_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <utility>

#include "core/named.h"
#include "core/tables/table_of.h"
#include "harness/cells/cell.h"

namespace ink::harness {
namespace {

/// What the program says of a method, or of a baseline; empty is what nobody knows.
struct MethodLine {
    std::string name;
    std::string role;
    std::string family = {};
    std::string marker = {};
    std::string tunables = {};
    std::optional<int> bytes_per_px = {};
    std::optional<bool> ink = {};
    std::string preset_of = {};
    std::string source = {};
    std::string summary = {};
    std::string params = {};
};

const core::TableOf<MethodLine>& table() {
    static const auto kTable = [] {
        core::TableOf<MethodLine> table(
            "methods.csv",
            "A line per method of the run, baselines first: what the registry says of it.");
        using M = MethodLine;
        table.add({"method", "", "as in rows.csv"}, &M::name);
        table.add({"role", "", "method, entrant (from outside), floor, one_sample or exact"},
                  &M::role);
        table.add({"family", "", "methods of one family share a colour"}, &M::family);
        table.add({"marker", "", "of its points in charts"}, &M::marker);
        table.add(
            {"tunables", "", "name:low..high;... between which it is tuned, name:a|b of choices"},
            &M::tunables);
        table.add(
            {"bytes_per_px", "B/px", "of its buffers, depth included; empty if scenes decide"},
            &M::bytes_per_px);
        table.add({"ink", "", "true where its edge responses are shares of pixels, not strengths"},
                  &M::ink);
        table.add({"preset_of", "", "the method whose settings a preset changes"}, &M::preset_of);
        table.add({"source", "", "where the method comes from"}, &M::source);
        table.add({"summary", "", "what it does, in a sentence"}, &M::summary);
        table.add({"params", "", "every parameter, key=value;key=value"}, &M::params);
        return table;
    }();
    return kTable;
}

/// The ends of what is searched, or the choices.
std::string range_of(const core::Param& param, const method::Tunable& tunable) {
    if (param.kind == core::ParamKind::flag) return "false|true";
    if (param.kind == core::ParamKind::choice)
        return fmt::format("{}", fmt::join(param.choices, "|"));
    const auto [low, high] = tunable.range.value_or(std::pair(param.min, param.max));
    return fmt::format("{}..{}", low, high);
}

std::string tunables_of(const method::MethodInfo& method) {
    const std::vector<method::Tunable> threshold = {{"threshold"}};
    std::vector<std::string> texts;
    for (const auto& tunable : method.tunables.empty() ? threshold : method.tunables) {
        const core::Param* param = core::find_named(method.params, tunable.param);
        if (param == nullptr) continue;
        texts.push_back(fmt::format("{}:{}", param->name, range_of(*param, tunable)));
    }
    return fmt::format("{}", fmt::join(texts, ";"));
}

MethodLine line_of(const method::MethodConfig& config) {
    const method::MethodInfo& info = *config.info;
    return {.name = info.name,
            .role = config.is_outside ? "entrant" : "method",
            .family = std::string(name_of(info.family)),
            .marker = std::string(name_of(info.marker)),
            .tunables = tunables_of(info),
            .bytes_per_px = config.is_outside ? std::nullopt : info.bytes_per_px(config.settings),
            .ink = config.is_grey,
            .preset_of = info.preset_of,
            .source = info.source,
            .summary = info.summary,
            .params = join_params(info.complete(config.settings))};
}

}  // namespace

const core::TableInfo& methods_table() {
    return table().info();
}

std::string methods_csv(const std::vector<method::MethodConfig>& configs) {
    std::vector<MethodLine> lines = {{"none", "floor"},
                                     {"sampled", "one_sample"},
                                     {"exact_corner", "one_sample"},
                                     {"oracle", "exact"}};
    for (const method::MethodConfig& config : configs)
        lines.push_back(line_of(config));
    return table().file(lines);
}

}  // namespace ink::harness
