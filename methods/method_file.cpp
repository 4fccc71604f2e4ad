#include "methods/method_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/toml_reader.h"
#include "methods/shipped_texts.h"

namespace ink::methods {
namespace {

constexpr const char* kNeeded = "source, summary, family, marker";

/// The member of `all` that the text behind `key` names.
template <class All>
typename All::value_type named(const All& all, core::TomlReader& file, const char* key) {
    const std::string text = file.needed_text(key, kNeeded);
    std::vector<std::string> names;
    for (const auto each : all) {
        if (name_of(each) == text) return each;
        names.emplace_back(name_of(each));
    }
    throw core::Error(file.where(key),
                      fmt::format("there is no {} '{}'", key, text),
                      core::known_names(names, text));
}

method::SumLimit read_limit(core::TomlReader& table, const std::vector<core::Param>& params) {
    table.refuse_unknown({"params", "limit"});
    const auto names = table.texts("params");
    const auto limit = table.numbers("limit");
    if (!names || limit.size() != 1) {
        throw core::Error(
            table.where(), "this is no limit", "{params = [\"a\", \"b\"], limit = 255}");
    }
    method::SumLimit read{.params = {}, .limit = limit[0]};
    for (const core::TomlText& name : *names)
        read.params.push_back(core::param_of(params, name.text, table.where_line(name.line)).name);
    return read;
}

method::Tunable read_tunable(core::TomlReader& table,
                             const std::string& name,
                             const std::vector<core::Param>& params) {
    const core::Param& param = core::param_of(params, name, table.where(name));
    const auto ends = table.numbers(name);
    if (ends.empty() && table.texts(name)->front().text == "all") return {.param = name};
    const bool is_range =
        ends.size() == 2 && param.min <= ends[0] && ends[0] < ends[1] && ends[1] <= param.max;
    if (is_range) return {.param = name, .range = {{ends[0], ends[1]}}};
    throw core::Error(
        table.where(name),
        fmt::format("'{}' is searched over no such range", name),
        fmt::format("\"all\", or [low, high] within {}", core::accepted_values(param)));
}

}  // namespace

std::string ShippedFile::where() const {
    const std::string folder(name);
    return "methods/" + folder + "/" + folder + ".toml";
}

std::span<const ShippedFile> method_files() {
    return kMethodFiles;
}

std::span<const ShippedFile> shipped_presets() {
    return kPresetFiles;
}

method::MethodInfo described(method::MethodInfo info,
                             std::string_view text,
                             const std::string& where) {
    core::TomlReader file(text, where);
    file.refuse_unknown(
        {"source", "summary", "family", "marker", "sweep", "sum_limits", "tunables"});
    info.source = file.needed_text("source", kNeeded);
    info.summary = file.needed_text("summary", kNeeded);
    info.family = named(method::kFamilies, file, "family");
    info.marker = named(method::kMarkers, file, "marker");
    for (core::TomlReader& line : file.tables("sweep"))
        info.sweep.push_back(line.settings(info.params));
    for (core::TomlReader& limit : file.tables("sum_limits"))
        info.sum_limits.push_back(read_limit(limit, info.params));
    if (auto tunables = file.table("tunables")) {
        for (const std::string& name : tunables->keys())
            info.tunables.push_back(read_tunable(*tunables, name, info.params));
    }
    return info;
}

}  // namespace ink::methods
