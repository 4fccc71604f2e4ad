#include "core/param.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/error.h"
#include "core/named.h"
#include "core/parse_number.h"

namespace ink::core {
namespace {

std::optional<double> parse_flag(std::string_view text) {
    if (text == "true" || text == "1" || text == "yes" || text == "on") return 1;
    if (text == "false" || text == "0" || text == "no" || text == "off") return 0;
    return std::nullopt;
}

std::optional<double> parse_choice(const Param& param, std::string_view text) {
    const auto found = std::find(param.choices.begin(), param.choices.end(), text);
    if (found == param.choices.end()) return std::nullopt;
    return static_cast<double>(found - param.choices.begin());
}

std::optional<double> parse(const Param& param, std::string_view text) {
    switch (param.kind) {
        case ParamKind::flag:
            return parse_flag(text);
        case ParamKind::choice:
            return parse_choice(param, text);
        case ParamKind::text:
        case ParamKind::list:
            return std::nullopt;
        case ParamKind::integer:
        case ParamKind::real:
            break;
    }
    const auto value = parse_number<double>(text);
    // NaN is in no range.
    if (!value || !(*value >= param.min && *value <= param.max)) return std::nullopt;
    if (param.kind == ParamKind::integer && *value != std::floor(*value)) return std::nullopt;
    return value;
}

int edit_distance(std::string_view a, std::string_view b) {
    std::vector<int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        int diagonal = row[0];
        row[0] = static_cast<int>(i) + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const int substitute = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substitute, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string known_names(const std::vector<std::string>& names, std::string_view wrong) {
    std::string text = fmt::format("{}", fmt::join(names, ", "));
    const auto nearest = std::min_element(names.begin(), names.end(), [&](auto& a, auto& b) {
        return edit_distance(a, wrong) < edit_distance(b, wrong);
    });
    if (nearest != names.end() && edit_distance(*nearest, wrong) <= 2) {
        text += fmt::format("; did you mean {}?", *nearest);
    }
    return text;
}

double parse_param(const Param& param, const GivenText& given, std::string_view called) {
    const auto value = parse(param, given.text);
    if (!value) {
        throw Error(given.where,
                    fmt::format("{} cannot be '{}'", called, given.text),
                    accepted_values(param));
    }
    return *value;
}

double parse_param(const Param& param, std::string_view text, std::string_view where) {
    return parse_param(param, {std::string(text), std::string(where)}, "parameter " + param.name);
}

std::string format_param(const Param& param, double value) {
    switch (param.kind) {
        case ParamKind::flag:
            return value != 0 ? "true" : "false";
        case ParamKind::choice:
            return param.choices.at(static_cast<std::size_t>(value));
        case ParamKind::integer:
            return fmt::format("{}", static_cast<long long>(value));
        case ParamKind::text:
        case ParamKind::list:
        case ParamKind::real:
            break;
    }
    return fmt::format("{}", value);
}

std::string accepted_values(const Param& param) {
    switch (param.kind) {
        case ParamKind::flag:
            return "true | false";
        case ParamKind::choice:
            return fmt::format("{}", fmt::join(param.choices, " | "));
        case ParamKind::integer:
            return fmt::format("a whole number {}..{}", param.min, param.max);
        case ParamKind::text:
        case ParamKind::list:
            return param.unit;
        case ParamKind::real:
            break;
    }
    return fmt::format("a number {}..{}", param.min, param.max);
}

void check_known_params(const std::vector<Param>& params,
                        const ParamValues& values,
                        std::string_view where) {
    for (const auto& [name, text] : values) {
        if (find_named(params, name) == nullptr) {
            throw Error(std::string(where),
                        fmt::format("there is no parameter '{}'", name),
                        params.empty() ? "no parameters" : known_names(names_of(params), name));
        }
    }
}

}  // namespace ink::core
