#include "methods/method_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "methods/settings_toml.h"

namespace ink::methods {
namespace {

constexpr const char* kNeeded = "source, summary, family, marker";

/// The member of `all` that the text behind `key` names.
template <class All>
typename All::value_type named(const All& all,
                               const toml::table& file,
                               const char* key,
                               const std::string& where) {
    const std::string text = text_of(file, key, where, kNeeded);
    std::vector<std::string> names;
    for (const auto each : all) {
        if (name_of(each) == text) return each;
        names.emplace_back(name_of(each));
    }
    throw core::Error(place_of(*file.get(key), where),
                      fmt::format("there is no {} '{}'", key, text),
                      core::known_names(names, text));
}

[[noreturn]] void refuse(const toml::node& node,
                         const std::string& where,
                         const std::string& what,
                         const std::string& accepted) {
    throw core::Error(place_of(node, where), what, accepted);
}

/// The tables behind `key`; none if there is no such key.
std::vector<const toml::table*> tables_of(const toml::table& file,
                                          const char* key,
                                          const std::string& where) {
    std::vector<const toml::table*> tables;
    const toml::node* node = file.get(key);
    if (node == nullptr) return tables;
    const std::string what = fmt::format("'{}' is no list of tables", key);
    const std::string accepted = fmt::format("{} = [{{...}}, {{...}}]", key);
    if (!node->is_array()) refuse(*node, where, what, accepted);
    for (const toml::node& each : *node->as_array()) {
        if (!each.is_table()) refuse(each, where, what, accepted);
        tables.push_back(each.as_table());
    }
    return tables;
}

method::SumLimit read_limit(const toml::table& file,
                            const std::vector<core::Param>& params,
                            const std::string& where) {
    refuse_unknown_keys(file, {"params", "limit"}, "a limit", where);
    const toml::array* names = file["params"].as_array();
    const auto limit = file["limit"].value<double>();
    if (names == nullptr || !limit)
        refuse(file, where, "this is no limit", "{params = [\"a\", \"b\"], limit = 255}");
    method::SumLimit read{.params = {}, .limit = *limit};
    for (const toml::node& name : *names) {
        const std::string text = name.value_or(std::string());
        read.params.push_back(param_of(params, text, place_of(name, where)).name);
    }
    return read;
}

method::Tunable read_tunable(const std::string& name,
                             const toml::node& node,
                             const std::vector<core::Param>& params,
                             const std::string& where) {
    const core::Param& param = param_of(params, name, place_of(node, where));
    if (node.value<std::string_view>() == "all") return {.param = name};
    const toml::array* ends = node.as_array();
    const bool has_two = ends != nullptr && ends->size() == 2;
    const auto low = has_two ? (*ends)[0].value<double>() : std::nullopt;
    const auto high = has_two ? (*ends)[1].value<double>() : std::nullopt;
    if (!low || !high || !(param.min <= *low && *low < *high && *high <= param.max)) {
        refuse(node,
               where,
               fmt::format("'{}' is searched over no such range", name),
               fmt::format("\"all\", or [low, high] within {}", core::accepted_values(param)));
    }
    return {.param = name, .range = {{*low, *high}}};
}

/// In the order of the file.
std::vector<method::Tunable> read_tunables(const toml::table& file,
                                           const std::vector<core::Param>& params,
                                           const std::string& where) {
    const toml::node* node = file.get("tunables");
    if (node == nullptr) return {};
    if (!node->is_table()) refuse(*node, where, "'tunables' is no table", "[tunables]");
    std::vector<std::pair<std::string, const toml::node*>> rows;
    for (const auto& [key, value] : *node->as_table())
        rows.emplace_back(key.str(), &value);
    std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
        return a.second->source().begin < b.second->source().begin;
    });
    std::vector<method::Tunable> tunables;
    for (const auto& [name, value] : rows)
        tunables.push_back(read_tunable(name, *value, params, where));
    return tunables;
}

}  // namespace

method::MethodInfo described(method::MethodInfo info,
                             std::string_view text,
                             const std::string& where) {
    const toml::table file = parse_toml(text, where, "the data of a method");
    refuse_unknown_keys(
        file,
        {"source", "summary", "family", "marker", "sweep", "sum_limits", "tunables"},
        "a method",
        where);
    info.source = text_of(file, "source", where, kNeeded);
    info.summary = text_of(file, "summary", where, kNeeded);
    info.family = named(method::kFamilies, file, "family", where);
    info.marker = named(method::kMarkers, file, "marker", where);
    for (const toml::table* line : tables_of(file, "sweep", where))
        info.sweep.push_back(read_settings(*line, info.params, where));
    for (const toml::table* limit : tables_of(file, "sum_limits", where))
        info.sum_limits.push_back(read_limit(*limit, info.params, where));
    info.tunables = read_tunables(file, info.params, where);
    return info;
}

}  // namespace ink::methods
