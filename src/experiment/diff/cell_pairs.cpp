#include "experiment/diff/cell_pairs.h"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <tuple>

namespace ink::experiment {
namespace {

using Rows = std::vector<const harness::Row*>;
/// Method, place and threads of a cell; then its parameters, or "" where they may differ.
using Key = std::tuple<std::string, harness::Place, int, std::string>;
using RowsByKey = std::map<Key, Rows>;

Key key_of(const harness::Row& row, bool with_params) {
    return {row.method, harness::place_of(row), row.threads, with_params ? row.params : ""};
}

RowsByKey group(const Rows& rows, bool with_params) {
    RowsByKey groups;
    for (const harness::Row* row : rows)
        groups[key_of(*row, with_params)].push_back(row);
    return groups;
}

Rows pointers_to(const std::vector<harness::Row>& rows) {
    Rows pointers;
    for (const harness::Row& row : rows)
        pointers.push_back(&row);
    return pointers;
}

/// Takes the pairs out of both: the only cell of a key in `a` with the only one in `b`.
std::vector<summary::RowPair> take_pairs(Rows& a, Rows& b, bool with_params) {
    const RowsByKey of_a = group(a, with_params);
    const RowsByKey of_b = group(b, with_params);
    std::vector<summary::RowPair> pairs;
    const auto partner = [&](const harness::Row& row) -> const harness::Row* {
        const Key key = key_of(row, with_params);
        const auto mine = of_a.find(key);
        const auto other = of_b.find(key);
        const bool is_one_each = mine != of_a.end() && other != of_b.end() &&
                                 mine->second.size() == 1 && other->second.size() == 1;
        return is_one_each ? other->second.front() : nullptr;
    };
    for (const harness::Row* row : a) {
        if (const harness::Row* other = partner(*row)) pairs.push_back({row, other});
    }
    std::erase_if(a, [&](const harness::Row* row) { return partner(*row) != nullptr; });
    std::erase_if(b, [&](const harness::Row* row) { return partner(*row) != nullptr; });
    return pairs;
}

std::map<std::string, std::string> parameters_of(std::string_view text) {
    std::map<std::string, std::string> parameters;
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find(';'));
        const auto equals = part.find('=');
        if (equals != std::string_view::npos)
            parameters.emplace(part.substr(0, equals), part.substr(equals + 1));
        text.remove_prefix(part.size() + (part.size() < text.size() ? 1 : 0));
    }
    return parameters;
}

}  // namespace

CellPairs pair_cells(const std::vector<harness::Row>& a, const std::vector<harness::Row>& b) {
    Rows left_a = pointers_to(a);
    Rows left_b = pointers_to(b);
    CellPairs pairs;
    pairs.paired = take_pairs(left_a, left_b, true);
    const std::vector<summary::RowPair> other_settings = take_pairs(left_a, left_b, false);
    pairs.paired.insert(pairs.paired.end(), other_settings.begin(), other_settings.end());
    pairs.gone = std::move(left_a);
    pairs.added = std::move(left_b);
    return pairs;
}

std::string changed_parameters(const std::string& a, const std::string& b) {
    const auto of_a = parameters_of(a);
    const auto of_b = parameters_of(b);
    std::map<std::string, std::pair<std::string, std::string>> both;
    for (const auto& [key, value] : of_a)
        both[key] = {value, "-"};
    for (const auto& [key, value] : of_b)
        both.try_emplace(key, "-", "").first->second.second = value;
    std::string text;
    for (const auto& [key, values] : both) {
        if (values.first == values.second) continue;
        text += fmt::format(
            "{}{} {} -> {}", text.empty() ? "" : ", ", key, values.first, values.second);
    }
    return text;
}

}  // namespace ink::experiment
