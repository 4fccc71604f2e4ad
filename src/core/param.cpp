#include "core/param.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

std::optional<double> parse(const Param& param, const GivenText& given) {
    switch (param.kind) {
        case ParamKind::flag:
            return parse_flag(given.text);
        case ParamKind::choice:
            return parse_choice(param, given.text);
        case ParamKind::text:
        case ParamKind::list:
            return std::nullopt;
        case ParamKind::integer:
        case ParamKind::real:
            break;
    }
    const auto value = given.number ? given.number : parse_number<double>(given.text);
    // NaN is in no range, and what is infinite is no number.
    if (!value || !(*value >= param.min && *value <= param.max)) return std::nullopt;
    if (!std::isfinite(*value)) return std::nullopt;
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

void* place_of(const ParamField& field, void* whole) {
    return field.find != nullptr ? field.find(whole) : static_cast<char*>(whole) + field.offset;
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
    const auto value = parse(param, given);
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
    if (std::isinf(param.max)) return "a number";
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

ParamRows::ParamRows() = default;
ParamRows::ParamRows(const ParamRows&) = default;
ParamRows::~ParamRows() = default;

void ParamRows::add(Param param, const ParamField& field) {
    param.default_value = field.default_value;
    params_.push_back(std::move(param));
    rows_.push_back({field, {}, {}});
}

void ParamRows::add_number(const ParamField& field,
                           ParamKind kind,
                           std::string_view name,
                           std::pair<double, double> range,
                           std::string_view unit,
                           std::string_view doc) {
    add({.name = std::string(name),
         .kind = kind,
         .min = range.first,
         .max = range.second,
         .unit = std::string(unit),
         .doc = std::string(doc)},
        field);
}

void ParamRows::add_flag(const ParamField& field, std::string_view name, std::string_view doc) {
    add({.name = std::string(name), .kind = ParamKind::flag, .max = 1, .doc = std::string(doc)},
        field);
}

void ParamRows::add_choice(const ParamField& field,
                           std::string_view name,
                           std::span<const std::string_view> choices,
                           std::string_view doc) {
    add({.name = std::string(name),
         .kind = ParamKind::choice,
         .max = static_cast<double>(choices.size() - 1),
         .choices = {choices.begin(), choices.end()},
         .doc = std::string(doc)},
        field);
}

void ParamRows::add_texts(Param param, Store store, Load load) {
    params_.push_back(std::move(param));
    rows_.push_back({{}, std::move(store), std::move(load)});
}

void ParamRows::set(void* whole,
                    std::size_t i,
                    const std::vector<GivenText>& given,
                    std::string_view called) const {
    const auto& [field, store, load] = rows_[i];
    if (store) {
        store(whole, given);
    } else {
        field.store(place_of(field, whole), parse_param(params_[i], given.back(), called));
    }
}

std::vector<std::string> ParamRows::get(const void* whole, std::size_t i) const {
    const auto& [field, store, load] = rows_[i];
    if (load) return load(whole);
    // Nothing is written there.
    const void* place = place_of(field, const_cast<void*>(whole));
    return {format_param(params_[i], field.load(place))};
}

void ParamRows::read(void* whole, const ParamValues& values, std::string_view where) const {
    check_known_params(params_, values, where);
    for (std::size_t i = 0; i < params_.size(); ++i) {
        const auto found = values.find(params_[i].name);
        if (found == values.end()) continue;
        set(whole, i, {{found->second, std::string(where)}}, "parameter " + params_[i].name);
    }
}

ParamValues ParamRows::complete(const ParamValues& values, std::string_view where) const {
    check_known_params(params_, values, where);
    ParamValues all;
    for (const Param& param : params_) {
        const auto found = values.find(param.name);
        const double value =
            found == values.end() ? param.default_value : parse_param(param, found->second, where);
        all[param.name] = format_param(param, value);
    }
    return all;
}

}  // namespace ink::core
