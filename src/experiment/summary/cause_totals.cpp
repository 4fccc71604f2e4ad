#include "experiment/summary/cause_totals.h"

#include <algorithm>

#include "experiment/summary/summary.h"

namespace ink::experiment {
namespace {

void add(const harness::Row& row, CauseTotals& totals) {
    totals.n_pred += row.n_pred;
    totals.n_truth += row.n_truth;
    totals.unmatched_duplicates += row.unmatched_duplicates;
    totals.false_positives += row.false_positives;
    totals.unmatched_truth += row.unmatched_truth;
    totals.false_negatives += row.false_negatives;
    for (std::size_t i = 0; row.causes && i < totals.causes.px.size(); ++i)
        totals.causes.px[i] += row.causes->px[i];
}

}  // namespace

std::string label_of(score::Cause cause) {
    std::string label(name(cause));
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

std::string_view meaning_of(score::Cause cause) {
    using score::Cause;
    switch (cause) {
        case Cause::one_triangle:
            return "inside a single triangle: seen at a grazing angle, or rounding";
        case Cause::one_patch:
            return "inside one smooth patch: its triangles show";
        case Cause::crack:
            return "a true line crosses the stencil, but out of reach";
        case Cause::frame:
            return "the true line is in the band at the frame, or beyond";
        case Cause::other:
            return "several surfaces meet here without a true line";
        case Cause::cancelled:
            return "one channel alone would show it, the sum of all does not";
        case Cause::below_threshold:
            return "no channel alone reaches the threshold";
        case Cause::sub_pixel:
            return "between pixel centres that see the same triangle";
        case Cause::thinned:
            return "drawn, but so close to other lines that thinning removed it";
        case Cause::unexplained:
            return "the declared code should have drawn it";
        case Cause::undeclared:
            return "not drawn, cause unknown: only methods that declare a linear code can be "
                   "analysed";
    }
    return "?";
}

std::vector<CauseTotals> cause_totals(const std::vector<const harness::Row*>& rows) {
    std::vector<CauseTotals> all;
    for (const harness::Row* row : rows) {
        if (!row->is_ok() || (harness::is_baseline(row->method) && row->method != "sampled"))
            continue;
        auto found = std::find_if(all.begin(), all.end(), [&](const CauseTotals& totals) {
            return totals.method == row->method;
        });
        if (found == all.end()) {
            all.emplace_back();
            all.back().method = row->method;
            found = all.end() - 1;
        }
        add(*row, *found);
    }
    std::stable_partition(all.begin(), all.end(), [](const CauseTotals& totals) {
        return !harness::is_baseline(totals.method);
    });
    return all;
}

std::vector<CauseTotals> cause_totals(const std::vector<harness::Row>& rows) {
    std::vector<const harness::Row*> pointers;
    for (const harness::Row& row : rows)
        pointers.push_back(&row);
    return cause_totals(pointers);
}

}  // namespace ink::experiment
