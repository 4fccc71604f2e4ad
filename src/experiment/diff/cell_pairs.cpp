#include "experiment/diff/cell_pairs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <tuple>

#include "experiment/diff/run_diff.h"
#include "harness/tables/sweep_table.h"

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

Values parameters_of(const std::string& params) {
    const auto pairs = harness::split_params(params);
    return {pairs.begin(), pairs.end()};
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
    std::vector<std::string> texts;
    for (const AskedChange& change : changes_of(parameters_of(a), parameters_of(b)))
        texts.push_back(fmt::format("{} {} -> {}", change.key, change.a, change.b));
    return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace ink::experiment
