#include "harness/intersection_scores.h"

#include <string>
#include <string_view>

#include "harness/cell.h"
#include "harness/crowded.h"
#include "harness/recall_groups.h"
#include "score/matching.h"

namespace ink::harness {
namespace {

using score::Intersections;
using score::PixelList;

/// What counts of some strokes against one prepared truth.
struct Counted {
    score::TruthLists lists;
    PixelList drawn;

    Counted(const score::Strokes& strokes, const score::ScoringTruth& truth)
        : lists(score::list_truth(truth, score_options(1))),  // the strokes have their threshold
          drawn(score::counted_pixels(strokes.thinned, lists, score_options(1))) {}

    /// Recall of some of the true pixels; none leaves the row without the group.
    void fill(std::string_view group, const PixelList& true_pixels, Row& row) const {
        const std::string name(group);
        row.k_by_class.erase(name);
        row.truth_px_by_class.erase(name);
        row.recall_by_class.erase(name);
        if (true_pixels.is_empty()) return;
        const std::int64_t k = score::match_pixels(drawn, true_pixels, lists.disk).k;
        const auto n = static_cast<std::int64_t>(true_pixels.size());
        row.k_by_class[name] = k;
        row.truth_px_by_class[name] = n;
        row.recall_by_class[name] = static_cast<double>(k) / static_cast<double>(n);
    }
};

PixelList intersections_of(const score::ScoringTruth& truth) {
    return PixelList(truth.labels, static_cast<std::uint8_t>(truth::LineClass::intersection));
}

/// Without flat intersections all are above the crease angle.
void copy_intersections(Row& row) {
    const std::string from(truth::name(truth::LineClass::intersection));
    const std::string to(kAboveCrease);
    if (row.recall_by_class.count(from) == 0) return;
    row.recall_by_class[to] = row.recall_by_class.at(from);
    row.k_by_class[to] = row.k_by_class.at(from);
    row.truth_px_by_class[to] = row.truth_px_by_class.at(from);
}

}  // namespace

void fill_intersections(const score::Strokes& strokes,
                        const score::Score& at_2px,
                        const ViewTruth& truth,
                        Row& row) {
    const score::CurveCount chosen{at_2px.k, at_2px.n_pred, at_2px.n_truth};
    row.above_crease_2px = chosen;
    row.all_intersections_2px = chosen;
    if (!truth.other) {
        copy_intersections(row);
        return;
    }
    const bool is_all = truth.intersections == Intersections::all;
    const score::ScoringTruth& above_truth = is_all ? *truth.other : truth.scoring;
    const score::ScoringTruth& all_truth = is_all ? truth.scoring : *truth.other;
    const Counted above(strokes, above_truth);
    const Counted all(strokes, all_truth);
    const Counted& other = is_all ? above : all;
    (is_all ? row.above_crease_2px : row.all_intersections_2px) =
        score::match_counts(other.drawn, other.lists);
    above.fill(kAboveCrease, intersections_of(above_truth), row);
    all.fill(truth::name(truth::LineClass::intersection), intersections_of(all_truth), row);
    all.fill(kBelowCrease, truth.below_crease, row);
}

void fill_score_2px(const score::Strokes& strokes, const ViewTruth& truth, Row& row) {
    const score::Score at_2px = score::score_strokes(strokes, truth.scoring, score_options(1));
    fill_score_2px(at_2px, row);
    fill_intersections(strokes, at_2px, truth, row);
    fill_crowded(strokes, at_2px, truth, row);
}

}  // namespace ink::harness
