#include "report/packed_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "harness/tables/csv_table.h"

namespace ink::report {
namespace {

constexpr std::size_t kExactDigits = 15;

/// The field as a JSON value; nothing if it is a text.
std::optional<std::string> json_value(const std::string& field) {
    if (field.empty() || field == "nan") return "null";
    if (field == "true" || field == "false") return field;
    if (field == "inf" || field == "-inf") return json_text(field);
    double value = 0;
    const char* end = field.data() + field.size();
    const auto [at, error] = std::from_chars(field.data(), end, value);
    const bool is_number = error == std::errc() && at == end && std::isfinite(value);
    const bool is_plain = field.find_first_not_of("0123456789") == std::string::npos;
    // JSON has no numbers that begin with 0 and a digit: these are a code.
    const std::size_t first = field.front() == '-' ? 1 : 0;
    const bool is_code = field.size() > first + 1 && field[first] == '0' &&
                         std::isdigit(static_cast<unsigned char>(field[first + 1])) != 0;
    if (!is_number || is_code || (is_plain && field.size() > kExactDigits)) return std::nullopt;
    return field;
}

template <class Items>
std::string json_array(const Items& items) {
    return fmt::format("[{}]", fmt::join(items, ","));
}

std::string text_column(const std::vector<std::string>& fields) {
    std::map<std::string, int> index;
    std::vector<std::string> words;
    std::vector<int> at;
    for (const std::string& field : fields) {
        if (field.empty()) {
            at.push_back(-1);
            continue;
        }
        const auto [found, is_new] = index.emplace(field, static_cast<int>(words.size()));
        if (is_new) words.push_back(json_text(field));
        at.push_back(found->second);
    }
    return fmt::format("{{\"words\":{},\"at\":{}}}", json_array(words), json_array(at));
}

}  // namespace

std::string json_text(std::string_view text) {
    const auto replace = nlohmann::json::error_handler_t::replace;
    const std::string quoted = nlohmann::json(text).dump(-1, ' ', false, replace);
    std::string safe;
    safe.reserve(quoted.size());
    for (const char c : quoted) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    return safe;
}

std::string packed_column(const std::vector<std::string>& fields) {
    std::vector<std::string> values;
    for (const std::string& field : fields) {
        std::optional<std::string> value = json_value(field);
        if (!value) break;
        values.push_back(std::move(*value));
    }
    const bool is_text = values.size() < fields.size();
    const bool is_constant =
        fields.size() > 1 && std::equal(fields.begin() + 1, fields.end(), fields.begin());
    if (is_constant) {
        return fmt::format("{{\"constant\":{}}}",
                           is_text ? json_text(fields.front()) : values.front());
    }
    return is_text ? text_column(fields) : json_array(values);
}

std::string packed_table(std::string_view csv, const std::string& where) {
    const harness::CsvTable table = harness::split_csv(csv, where);
    std::vector<std::string> columns;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        std::vector<std::string> fields;
        fields.reserve(table.records.size());
        for (const std::vector<std::string>& record : table.records)
            fields.push_back(harness::unquoted(record[i]));
        columns.push_back(json_text(table.columns[i]) + ":" + packed_column(fields));
    }
    return fmt::format(
        "{{\"lines\":{},\"columns\":{{{}}}}}", table.records.size(), fmt::join(columns, ","));
}

}  // namespace ink::report
