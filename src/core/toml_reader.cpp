#include "core/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/named.h"
#include "core/toml_document.h"

namespace ink::core {
namespace {

/// A value as the file spells it, for messages and settings; numbers in their shortest form.
std::string spelled(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
    // -0 is 0.
    if (const auto* number = node.as_floating_point())
        return fmt::format("{}", number->get() + 0.0);
    if (node.is_table()) return "a table";
    if (node.is_array()) return "an array";
    return "a date or time";
}

bool is_scalar(const toml::node& node) {
    return node.is_string() || node.is_boolean() || node.is_integer() || node.is_floating_point();
}

int line_of(const toml::node& node) {
    return static_cast<int>(node.source().begin.line);
}

}  // namespace

struct TomlReader::Table {
    std::shared_ptr<const toml::table> root;
    const toml::table& here;

    [[nodiscard]] const toml::node* find(const std::string& key) const { return here.get(key); }
    [[nodiscard]] std::shared_ptr<const Table> inside(const toml::table& table) const {
        return std::make_shared<Table>(Table{root, table});
    }
};

TomlReader::TomlReader(std::string_view text, std::filesystem::path file) : file_(std::move(file)) {
    const auto root = std::make_shared<const toml::table>(parse_toml(text, file_));
    table_ = std::make_shared<Table>(Table{root, *root});
}

TomlReader::TomlReader(std::shared_ptr<const Table> table,
                       std::filesystem::path file,
                       std::string name)
    : table_(std::move(table)), file_(std::move(file)), name_(std::move(name)) {}

std::string TomlReader::full_name(const std::string& key) const {
    return name_.empty() ? key : name_ + "." + key;
}

std::string TomlReader::where_line(int line) const {
    return line > 0 ? fmt::format("{}:{}", file_.string(), line) : file_.string();
}

std::string TomlReader::where(const std::string& key) const {
    const toml::node* node = key.empty() ? &table_->here : table_->find(key);
    return where_line(node != nullptr ? line_of(*node) : 0);
}

void TomlReader::refuse(const std::string& key, const std::string& accepted) const {
    throw Error(where(key),
                fmt::format("{} cannot be {}", full_name(key), spelled(*table_->find(key))),
                accepted);
}

std::optional<std::string> TomlReader::text(const std::string& key) {
    const toml::node* node = table_->find(key);
    if (node == nullptr) return std::nullopt;
    if (!node->is_string() || node->as_string()->get().empty()) refuse(key, "a text in quotes");
    return node->as_string()->get();
}

std::string TomlReader::needed_text(const std::string& key, const std::string& needed) {
    if (auto found = text(key)) return *found;
    throw Error(where(), fmt::format("there is no '{}'", key), needed);
}

std::string TomlReader::scalar(const std::string& key, const Param& param) {
    const toml::node& node = *table_->find(key);
    const auto is_right = [&] {
        switch (param.kind) {
            case ParamKind::flag:
                return node.is_boolean();
            case ParamKind::integer:
                return node.is_integer();
            case ParamKind::real:
                return node.is_number();
            case ParamKind::choice:
                return node.is_string();
            case ParamKind::text:
            case ParamKind::list:
                break;
        }
        return is_scalar(node);
    };
    if (!is_right()) refuse(key, accepted_values(param));
    return spelled(node);
}

std::optional<std::vector<TomlText>> TomlReader::texts(const std::string& key) {
    const toml::node* node = table_->find(key);
    if (node == nullptr) return std::nullopt;
    if (is_scalar(*node)) return std::vector<TomlText>{{spelled(*node), line_of(*node)}};
    const toml::array* array = node->as_array();
    if (array == nullptr) refuse(key, "a value, or an array of values");
    if (array->empty()) {
        throw Error(where(key),
                    fmt::format("{} is an empty array", full_name(key)),
                    "one value at least, or the key left out");
    }
    std::vector<TomlText> texts;
    for (const toml::node& value : *array) {
        if (!is_scalar(value)) {
            throw Error(where_line(line_of(value)),
                        fmt::format("{} holds {}", full_name(key), spelled(value)),
                        "texts, numbers, true or false");
        }
        texts.push_back({spelled(value), line_of(value)});
    }
    return texts;
}

std::vector<double> TomlReader::numbers(const std::string& key) const {
    const toml::node* node = table_->find(key);
    if (node == nullptr) return {};
    std::vector<double> numbers;
    const auto add = [&](const toml::node& each) {
        if (each.is_number()) numbers.push_back(*each.value<double>());
        return each.is_number();
    };
    if (const toml::array* array = node->as_array()) {
        if (!std::all_of(array->begin(), array->end(), add)) return {};
    } else {
        (void)add(*node);
    }
    return numbers;
}

std::optional<TomlReader> TomlReader::table(const std::string& key) {
    const toml::node* node = table_->find(key);
    if (node == nullptr) return std::nullopt;
    if (!node->is_table()) refuse(key, fmt::format("a table, [{}]", full_name(key)));
    return TomlReader(table_->inside(*node->as_table()), file_, full_name(key));
}

TomlReader TomlReader::table_or_empty(const std::string& key) {
    static const auto kEmpty = std::make_shared<const toml::table>();
    if (has(key)) return *table(key);
    return TomlReader(std::make_shared<Table>(Table{kEmpty, *kEmpty}), file_, full_name(key));
}

std::vector<TomlReader> TomlReader::tables(const std::string& key) {
    const toml::node* node = table_->find(key);
    if (node == nullptr) return {};
    std::vector<TomlReader> tables;
    const std::string accepted = "a list of tables, [{...}, {...}]";
    if (!node->is_array()) refuse(key, accepted);
    for (const toml::node& each : *node->as_array()) {
        if (!each.is_table()) refuse(key, accepted);
        tables.push_back(TomlReader(table_->inside(*each.as_table()), file_, full_name(key)));
    }
    return tables;
}

ParamValues TomlReader::settings(const std::vector<Param>& params) {
    ParamValues values;
    for (const std::string& key : keys()) {
        const Param& param = param_of(params, key, where(key));
        values[key] = format_param(param, parse_param(param, scalar(key, param), where(key)));
    }
    return values;
}

std::vector<std::string> TomlReader::keys() const {
    std::vector<std::pair<toml::source_position, std::string>> found;
    for (const auto& [key, node] : table_->here)
        found.emplace_back(key.source().begin, std::string(key.str()));
    std::stable_sort(
        found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (auto& [position, name] : found)
        names.push_back(std::move(name));
    return names;
}

bool TomlReader::has(const std::string& key) const {
    return table_->find(key) != nullptr;
}

bool TomlReader::is_table(const std::string& key) const {
    const toml::node* node = table_->find(key);
    return node != nullptr && node->is_table();
}

bool TomlReader::is_empty(const std::string& key) const {
    const toml::node* node = table_->find(key);
    return node != nullptr && node->is_array() && node->as_array()->empty();
}

void TomlReader::refuse_unknown(const std::vector<std::string>& known) const {
    for (const std::string& key : keys()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        throw Error(
            where(key), fmt::format("there is no key {}", full_name(key)), known_names(known, key));
    }
}

const Param& param_of(const std::vector<Param>& params,
                      const std::string& name,
                      const std::string& place) {
    check_known_params(params, {{name, ""}}, place);
    return *find_named(params, name);
}

}  // namespace ink::core
