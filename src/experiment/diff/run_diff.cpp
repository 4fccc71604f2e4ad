#include "experiment/diff/run_diff.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "core/error.h"
#include "core/provenance.h"
#include "core/toml_document.h"
#include "harness/rows/row.h"
#include "harness/rows/side_tables.h"
#include "statistics/bootstrap.h"
#include "summary/paired_differences.h"
#include "summary/summary.h"

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

using harness::Row;

/// What must be equal for two times to compare, and how it is called. The program's own version may
/// differ: that is what two runs are compared for.
std::vector<std::pair<std::string, std::string>> conditions_of(const Row& row) {
    const core::Provenance& p = provenance_of(row);
    return {{"processor", p.cpu},
            {"instruction set", p.simd},
            {"compiler", p.compiler},
            {"build", p.flags}};
}

std::string times_obstacle(const std::vector<summary::RowPair>& pairs) {
    for (const summary::RowPair& pair : pairs) {
        if (!pair.a->draw_ns_min || !pair.b->draw_ns_min) continue;
        const auto a = conditions_of(*pair.a);
        const auto b = conditions_of(*pair.b);
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (a[i].second != b[i].second) {
                return fmt::format("the {} differs: {}, {}", a[i].first, a[i].second, b[i].second);
            }
        }
    }
    return "";
}

bool have_ink(const summary::RowPair& pair) {
    return pair.a->soft && pair.b->soft;
}

bool has_other_counts(const summary::RowPair& pair) {
    const auto differ = [&](summary::Measure measure) {
        return summary::counts_of(*pair.a, measure) != summary::counts_of(*pair.b, measure);
    };
    return differ(summary::Measure::f_2px) || (have_ink(pair) && differ(summary::Measure::soft_f));
}

/// F of both runs and the interval of their difference, scenes resampled for both together.
FDiff compare_scores(const std::vector<summary::RowPair>& pairs,
                     summary::Measure measure,
                     std::uint64_t seed) {
    const summary::PairedScenes scenes = summary::paired_scenes(pairs, measure);
    if (scenes.is_empty()) return {};
    return {scenes.f_a(),
            scenes.f_b(),
            scenes.f_b() - scenes.f_a(),
            statistics::paired_interval(scenes.b, scenes.a, {.seed = seed})};
}

std::optional<double> time_ratio(const std::vector<summary::RowPair>& pairs) {
    double sum = 0;
    int count = 0;
    for (const summary::RowPair& pair : pairs) {
        if (!pair.a->draw_ns_min || !pair.b->draw_ns_min) continue;
        if (*pair.a->draw_ns_min <= 0 || *pair.b->draw_ns_min <= 0) continue;
        sum += std::log(static_cast<double>(*pair.b->draw_ns_min) /
                        static_cast<double>(*pair.a->draw_ns_min));
        ++count;
    }
    if (count == 0) return std::nullopt;
    return std::exp(sum / count);
}

MethodDiff diff_of(const std::vector<summary::RowPair>& pairs,
                   bool times_compare,
                   std::uint64_t seed) {
    MethodDiff diff;
    diff.method = pairs.front().a->method;
    diff.settings = changed_parameters(pairs.front().a->params, pairs.front().b->params);
    diff.cells = static_cast<int>(pairs.size());
    for (const summary::RowPair& pair : pairs) {
        diff.changed_images += pair.a->image_hash != pair.b->image_hash ? 1 : 0;
        diff.lost += pair.a->is_scored() && !pair.b->is_scored() ? 1 : 0;
        diff.won += !pair.a->is_scored() && pair.b->is_scored() ? 1 : 0;
        const bool are_scored = pair.a->is_scored() && pair.b->is_scored();
        diff.changed_scores += are_scored && has_other_counts(pair) ? 1 : 0;
    }
    diff.f = compare_scores(pairs, summary::Measure::f_2px, seed);
    std::vector<summary::RowPair> inked;
    std::ranges::copy_if(pairs, std::back_inserter(inked), have_ink);
    diff.soft_f = compare_scores(inked, summary::Measure::soft_f, seed);
    if (times_compare) diff.time_ratio = time_ratio(pairs);
    return diff;
}

int count_changed_truths(const std::vector<summary::RowPair>& pairs) {
    std::set<harness::Place> changed;
    for (const summary::RowPair& pair : pairs) {
        if (pair.a->is_scored() && pair.b->is_scored() && pair.a->truth_px != pair.b->truth_px)
            changed.insert(harness::place_of(*pair.a));
    }
    return static_cast<int>(changed.size());
}

/// Changes first, then the larger difference; the order of the first run else.
bool comes_before(const MethodDiff& a, const MethodDiff& b) {
    const auto rank = [](const MethodDiff& diff) {
        const int kind = diff.changed_images > 0 ? 0 : diff.is_same() ? 2 : 1;
        return std::pair(kind,
                         -std::max(std::abs(diff.f.difference.value_or(0)),
                                   std::abs(diff.soft_f.difference.value_or(0))));
    };
    return rank(a) < rank(b);
}

/// The keys whose values differ, in alphabetical order.
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

}  // namespace

std::vector<AskedChange> asked_changes(const std::string& a, const std::string& b) {
    return changes_of(values_of(a), values_of(b));
}

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

bool FDiff::is_worse() const {
    if (!difference || *difference >= 0) return false;
    return !range || range->high < 0;
}

bool RunDiff::is_same() const {
    return asked.empty() && cells.gone.empty() && cells.added.empty() && changed_truths == 0 &&
           std::ranges::all_of(methods, &MethodDiff::is_same);
}

bool RunDiff::is_worse() const {
    return std::ranges::any_of(methods, &MethodDiff::is_worse) ||
           std::ranges::any_of(cells.gone, &Row::is_scored);
}

RunDiff diff_runs(const RunData& a, const RunData& b, std::uint64_t seed) {
    RunDiff diff;
    diff.asked = asked_changes(a.record.asked, b.record.asked);
    diff.cells = pair_cells(a.tables.rows, b.tables.rows);
    diff.times_obstacle = times_obstacle(diff.cells.paired);
    diff.changed_truths = count_changed_truths(diff.cells.paired);
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, std::vector<summary::RowPair>> groups;
    for (const summary::RowPair& pair : diff.cells.paired) {
        const std::pair key(pair.a->method, changed_parameters(pair.a->params, pair.b->params));
        std::vector<summary::RowPair>& group = groups[key];
        if (group.empty()) order.push_back(key);
        group.push_back(pair);
    }
    for (const auto& key : order)
        diff.methods.push_back(diff_of(groups[key], diff.times_obstacle.empty(), seed));
    std::stable_sort(diff.methods.begin(), diff.methods.end(), comes_before);
    return diff;
}

}  // namespace ink::experiment
