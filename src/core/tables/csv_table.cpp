#include "core/tables/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "core/error.h"
#include "core/parse_number.h"

namespace ink::core {
namespace {

/// One record of `text` from `at` on, which moves behind its line break; `is_ended` tells whether
/// it had one.
std::vector<std::string> take_record(std::string_view text, std::size_t& at, bool& is_ended) {
    std::vector<std::string> fields(1);
    bool is_quoted = false;
    is_ended = false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') is_quoted = !is_quoted;  // a doubled quote closes and opens again
        if (!is_quoted && c == '\n') {
            ++at;
            is_ended = true;
            break;
        }
        if (!is_quoted && c == ',') {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

}  // namespace

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string number_text(double value) {
    return fmt::format("{}", value);
}

std::string number_text(std::int64_t value) {
    return fmt::format("{}", value);
}

std::string number_text(std::uint64_t value) {
    return fmt::format("{}", value);
}

std::size_t CsvTable::find(std::string_view name) const {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                    columns.begin());
}

CsvTable split_csv(std::string_view text, const std::string& where) {
    CsvTable table;
    table.where = where;
    std::size_t at = 0;
    std::size_t line = 1;
    bool is_ended = true;
    if (text.empty()) return table;
    const auto take = [&] {
        const std::size_t from = at;
        std::vector<std::string> fields = take_record(text, at, is_ended);
        if (!is_ended) {
            throw Error(fmt::format("{}, line {}", where, line),
                        "the file ends within a record",
                        "a file whose every line is ended");
        }
        line +=
            static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(from),
                                                text.begin() + static_cast<std::ptrdiff_t>(at),
                                                '\n'));
        return fields;
    };
    table.columns = take();
    while (at < text.size()) {
        table.lines.push_back(line);
        table.records.push_back(take());
        if (table.records.back().size() != table.columns.size()) {
            throw Error(fmt::format("{}, line {}", where, table.lines.back()),
                        fmt::format("it has {} fields", table.records.back().size()),
                        fmt::format("{}, as many as the heading", table.columns.size()));
        }
    }
    return table;
}

void check_columns(const CsvTable& table, const TableInfo& info) {
    const std::size_t count = std::max(table.columns.size(), info.columns.size());
    for (std::size_t i = 0; i < count; ++i) {
        const std::string found = i < table.columns.size() ? unquoted(table.columns[i]) : "";
        const std::string wanted = i < info.columns.size() ? info.columns[i].name : "";
        if (found == wanted) continue;
        throw Error(fmt::format("{}, line 1", table.where),
                    found.empty() ? fmt::format("column {} is missing", i + 1)
                                  : fmt::format("column {} is '{}'", i + 1, found),
                    wanted.empty()
                        ? fmt::format("the {} columns of {}", info.columns.size(), info.file)
                        : fmt::format("'{}', as in {} of this version", wanted, info.file));
    }
}

std::string unquoted(const std::string& field) {
    if (field.size() < 2 || field.front() != '"') return field;
    std::string text;
    for (std::size_t i = 1; i + 1 < field.size(); ++i) {
        if (field[i] == '"') ++i;
        text += field[i];
    }
    return text;
}

void CsvField::refuse(const std::string& accepted) const {
    throw Error(fmt::format("{}, line {}", table_.where, table_.lines[record_]),
                fmt::format("column {} holds '{}'", table_.columns[column_], text()),
                accepted);
}

void CsvField::read(bool& value) const {
    if (raw() != "true" && raw() != "false") refuse("true or false");
    value = raw() == "true";
}

template <class T>
requires std::is_arithmetic_v<T>
void CsvField::read(T& value) const {
    const auto number = parse_number<T>(raw());
    const char* whole = std::is_signed_v<T> ? "an integer" : "an integer from 0";
    if (!number) refuse(std::is_integral_v<T> ? whole : "a number");
    value = *number;
}
template void CsvField::read(int&) const;
template void CsvField::read(double&) const;
template void CsvField::read(std::int64_t&) const;
template void CsvField::read(std::uint64_t&) const;

}  // namespace ink::core
