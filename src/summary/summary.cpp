#include "summary/summary.h"

#include <algorithm>
#include <cstdint>

#include "core/named.h"
#include "core/parallel.h"
#include "methods/registry.h"
#include "statistics/bootstrap.h"

namespace ink::summary {
namespace {

using Counts = score::CurveCount;

std::optional<double> share(std::int64_t part, std::int64_t whole) {
    if (whole == 0) return std::nullopt;
    return static_cast<double>(part) / static_cast<double>(whole);
}

using Rows = std::vector<const harness::Row*>;

std::optional<double> pooled(const Rows& rows, Measure measure) {
    if (rows.empty()) return std::nullopt;
    Counts sum;
    for (const harness::Row* row : rows)
        sum += counts_of(*row, measure);
    return sum.f();
}

Rows of_split(const Rows& rows, std::string_view split) {
    Rows kept;
    std::ranges::copy_if(rows, std::back_inserter(kept), [&](const harness::Row* row) {
        return row->split == split;
    });
    return kept;
}

SceneSums sums_by_scene(const Rows& rows, Measure measure) {
    SceneSums sums;
    for (const harness::Row* row : rows)
        sums.add(row->scene, counts_of(*row, measure));
    return sums;
}

/// Of what `f_of` makes of each.
template <class All, class F>
std::optional<double> mean_f(const All& all, F f_of) {
    std::vector<double> values;
    std::ranges::transform(all, std::back_inserter(values), f_of);
    return statistics::mean(values);
}

/// Over the rows that were scored at 1 px, too.
std::optional<double> f_1px(const Rows& rows) {
    std::optional<Counts> sum;
    for (const harness::Row* row : rows) {
        if (!row->k_1px || !row->n_pred_1px) continue;
        if (!sum) sum.emplace();
        *sum += {*row->k_1px, *row->n_pred_1px, row->n_truth};
    }
    return sum ? std::optional(sum->f()) : std::nullopt;
}

std::map<std::string, double> pooled_recalls(const Rows& rows) {
    std::map<std::string, Counts> sums;
    for (const harness::Row* row : rows)
        for (const auto& [name, counts] : row->by_class)
            sums[name] += counts;
    std::map<std::string, double> recalls;
    for (const auto& [name, sum] : sums)
        recalls[name] = sum.f();
    return recalls;
}

/// One for each kind; scenes of none are left out.
std::vector<KindSummary> kinds_of(const Rows& rows, Measure measure) {
    std::vector<KindSummary> kinds;
    for (const harness::Row* row : rows) {
        const std::string& kind = row->scene_kind;
        if (kind.empty() || std::ranges::count(kinds, kind, &KindSummary::kind) > 0) continue;
        Rows own;
        std::ranges::copy_if(rows, std::back_inserter(own), [&](const harness::Row* other) {
            return other->scene_kind == kind;
        });
        const auto& [names, counts] = sums_by_scene(own, measure);
        const auto least = std::ranges::min_element(counts, {}, &Counts::f) - counts.begin();
        const auto at = static_cast<std::size_t>(least);
        kinds.push_back({kind,
                         static_cast<int>(names.size()),
                         *pooled(own, measure),
                         names[at],
                         counts[at].f()});
    }
    return kinds;
}

/// What either side has without a match.
std::int64_t wrong(const Counts& counts) {
    return counts.n_pred + counts.n_truth - 2 * counts.k;
}

/// Where most of the error is; of scenes with as much the first.
void find_error_scene(const SceneSums& scenes, FSummary& summary) {
    std::int64_t all = 0;
    std::int64_t most = 0;
    for (std::size_t i = 0; i < scenes.names.size(); ++i) {
        const std::int64_t here = wrong(scenes.counts[i]);
        all += here;
        if (here <= most) continue;
        most = here;
        summary.error_scene = scenes.names[i];
    }
    summary.error_scene_share = share(most, all);
}

FSummary summarise_f(const Rows& rows, Measure measure) {
    FSummary summary;
    if (rows.empty()) return summary;
    const SceneSums scenes = sums_by_scene(rows, measure);
    for (std::size_t i = 0; i < scenes.names.size(); ++i)
        summary.counts_of_scene[scenes.names[i]] = scenes.counts[i];
    summary.all = pooled(rows, measure);
    summary.range = statistics::f_interval(scenes.counts, {.seed = rows.front()->seed});
    summary.train = pooled(of_split(rows, "train"), measure);
    summary.heldout = pooled(of_split(rows, "heldout"), measure);
    summary.real = pooled(of_split(rows, "real"), measure);
    summary.macro = mean_f(scenes.counts, &Counts::f);
    summary.kinds = kinds_of(rows, measure);
    if (summary.kinds.size() > 1) summary.mean_of_kinds = mean_f(summary.kinds, &KindSummary::f);
    find_error_scene(scenes, summary);
    return summary;
}

void summarise_scores(const Rows& rows, MethodSummary& summary) {
    Counts sum;
    for (const harness::Row* row : rows) {
        sum += counts_of(*row, Measure::f_2px);
        summary.image_hashes += row->image_hash + ' ';
    }
    const auto has_image = [](const harness::Row* row) { return !row->image_hash.empty(); };
    if (!std::ranges::all_of(rows, has_image)) summary.image_hashes.clear();
    summary.f = summarise_f(rows, Measure::f_2px);
    if (std::ranges::all_of(rows, [](const harness::Row* row) { return row->soft.has_value(); }))
        summary.soft_f = summarise_f(rows, Measure::soft_f);
    summary.scenes = static_cast<int>(summary.f.counts_of_scene.size());
    summary.f_1px = f_1px(rows);
    summary.precision = share(sum.k, sum.n_pred);
    summary.recall = share(sum.k, sum.n_truth);
    summary.recall_by_class = pooled_recalls(rows);
}

void summarise_costs(const Rows& rows, MethodSummary& summary) {
    summary.has_own_clock =
        std::ranges::any_of(rows, [](const harness::Row* row) { return row->has_own_clock(); });
    const auto ms_of = [&](std::optional<std::int64_t> harness::Row::*time_ns) {
        std::vector<double> ms;
        for (const harness::Row* row : rows)
            if (row->*time_ns) ms.push_back(static_cast<double>(*(row->*time_ns)) * 1e-6);
        return ms;
    };
    const std::vector<double> draw_ms = ms_of(&harness::Row::draw_ns);
    summary.draw_ms = statistics::quantile(draw_ms, 0.5);
    if (draw_ms.size() > 1) {
        summary.draw_ms_quartiles = statistics::Interval{*statistics::quantile(draw_ms, 0.25),
                                                         *statistics::quantile(draw_ms, 0.75)};
    }
    const auto least_ms = statistics::quantile(ms_of(&harness::Row::draw_ns_min), 0.5);
    const auto median_ms = statistics::quantile(ms_of(&harness::Row::draw_ns_median), 0.5);
    if (least_ms && median_ms) summary.draw_ms_doubt = {*least_ms, *median_ms};
    for (const harness::Row* row : rows) {
        if (!row->bytes_per_px) continue;
        summary.bytes_per_px = std::max(summary.bytes_per_px.value_or(0), *row->bytes_per_px);
    }
}

}  // namespace

std::string_view name(Measure measure) {
    return measure == Measure::soft_f ? "soft_f" : "f_2px";
}

Counts counts_of(const harness::Row& row, Measure measure) {
    return measure == Measure::soft_f ? row.soft->counts()
                                      : Counts{row.k_2px, row.n_pred, row.n_truth};
}

void SceneSums::add(const std::string& scene, const Counts& more) {
    const auto known = std::ranges::find(names, scene) - names.begin();
    if (known == std::ssize(names)) {
        names.push_back(scene);
        counts.emplace_back();
    }
    counts[static_cast<std::size_t>(known)] += more;
}

Rows scored_rows(const std::vector<harness::Row>& rows, const std::string& method) {
    Rows kept;
    for (const harness::Row& row : rows) {
        if (row.method == method && row.is_scored()) kept.push_back(&row);
    }
    return kept;
}

void add_curves(const std::vector<statistics::CellCurve>& curves,
                std::vector<MethodSummary>& summaries) {
    const std::map<std::string, double> areas = statistics::pooled_ap(curves);
    for (MethodSummary& summary : summaries) {
        const auto area = areas.find(summary.method);
        if (area != areas.end()) summary.ap = area->second;
    }
}

bool is_error_in_one_scene(const MethodSummary& summary) {
    return summary.scenes >= static_cast<int>(statistics::kFewestClusters) &&
           summary.judged().error_scene_share.value_or(0) > 0.5;
}

std::vector<MethodSummary> summarise(const std::vector<harness::Row>& rows) {
    std::vector<MethodSummary> summaries;
    for (const harness::Row& row : rows) {
        const auto known = std::ranges::find(summaries, row.method, &MethodSummary::method);
        if (known != summaries.end()) continue;
        MethodSummary summary;
        summary.method = row.method;
        summary.is_baseline = harness::is_baseline(row.method);
        summaries.push_back(summary);
    }
    core::parallel_for(summaries.size(), core::hardware_threads(), [&](std::size_t i) {
        MethodSummary& summary = summaries[i];
        const Rows good = scored_rows(rows, summary.method);
        const auto all = std::ranges::count(rows, summary.method, &harness::Row::method);
        summary.views = static_cast<int>(good.size());
        summary.failed = static_cast<int>(all) - summary.views;
        summarise_scores(good, summary);
        summarise_costs(good, summary);
    });
    std::stable_partition(
        summaries.begin(), summaries.end(), [](const MethodSummary& s) { return !s.is_baseline; });
    return summaries;
}

bool is_choice_of_others(const std::string& method) {
    const method::MethodInfo* info = core::find_named(methods::registry(), method);
    return info != nullptr && info->family == method::Family::other;
}

bool takes_one_sample(const std::string& method) {
    const method::MethodInfo* info = core::find_named(methods::registry(), method);
    return info != nullptr && info->family != method::Family::edges_and_hulls &&
           info->family != method::Family::other;
}

}  // namespace ink::summary
