#include <map>
#include <sstream>

#include "core/error.h"
#include "core/toml_document.h"
#include "experiment/diff/run_diff.h"

namespace ink::experiment {
namespace {

/// Adds every value below `node`, by its dotted key. Arrays of plain values stay one text.
void flatten(const toml::node& node, const std::string& key, Values& values) {
    const auto below = [&](std::string_view name) {
        return key.empty() ? std::string(name) : key + "." + std::string(name);
    };
    if (const toml::table* table = node.as_table()) {
        for (const auto& [name, value] : *table)
            flatten(value, below(name.str()), values);
        return;
    }
    const toml::array* array = node.as_array();
    if (array != nullptr && array->is_homogeneous<toml::table>() && !array->empty()) {
        for (std::size_t i = 0; i < array->size(); ++i)
            flatten((*array)[i], below(std::to_string(i + 1)), values);
        return;
    }
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    values[key] = text.str();
}

Values values_of(const std::string& document) {
    Values values;
    try {
        flatten(toml::parse(document), "", values);
    } catch (const toml::parse_error& error) {
        throw core::Error(
            "run.toml", "what was asked is no TOML: " + std::string(error.description()), "TOML");
    }
    return values;
}

}  // namespace

std::vector<AskedChange> asked_changes(const std::string& a, const std::string& b) {
    return changes_of(values_of(a), values_of(b));
}

std::vector<AskedChange> changes_of(const Values& a, const Values& b) {
    std::map<std::string, AskedChange> changes;
    for (const auto& [key, value] : a)
        changes[key] = {key, value, "-"};
    for (const auto& [key, value] : b)
        changes.try_emplace(key, AskedChange{key, "-", ""}).first->second.b = value;
    std::vector<AskedChange> changed;
    for (const auto& [key, change] : changes) {
        if (change.a != change.b) changed.push_back(change);
    }
    return changed;
}

}  // namespace ink::experiment
