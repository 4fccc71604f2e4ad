#include "harness/scores/intersection_scores.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "harness/cells/cell.h"
#include "harness/truths/unscored_view.h"
#include "score/matching.h"

namespace ink::harness {
namespace {

// Recall groups of core/vocabulary.h.
constexpr std::string_view kAboveCrease = "intersection_above_crease";
constexpr std::string_view kBelowCrease = "intersection_below_crease";

using score::Intersections;
using score::PixelList;

/// What counts of some strokes against one truth.
struct Counted {
    const score::TruthLists& lists;
    PixelList drawn;
    score::DrawnMatcher matcher;

    Counted(const score::Strokes& strokes, const score::TruthLists& truth_lists)
        : lists(truth_lists),
          drawn(score::counted_pixels(strokes.thinned, lists)),
          matcher(drawn, lists.disk) {}

    /// Recall of some of the true pixels; none leaves the row without the group.
    void fill(std::string_view group, const PixelList& true_pixels, Row& row) {
        const std::string name(group);
        row.by_class.erase(name);
        const auto n = static_cast<std::int64_t>(true_pixels.size());
        if (n > 0) row.by_class[name] = {matcher.match(true_pixels), n, n};
    }
    /// The same of all intersections.
    void fill_intersections(std::string_view group, Row& row) {
        const auto found = std::ranges::find_if(lists.classes, [](const score::ClassPixels& c) {
            return c.label == static_cast<std::uint8_t>(truth::LineClass::intersection);
        });
        fill(group, found == lists.classes.end() ? PixelList() : found->pixels, row);
    }
};

/// Without flat intersections all are above the crease angle.
void copy_intersections(Row& row) {
    const auto all = row.by_class.find(std::string(truth::name(truth::LineClass::intersection)));
    if (all != row.by_class.end()) row.by_class[std::string(kAboveCrease)] = all->second;
}

}  // namespace

score::Strokes strokes_against(const score::ScoringTruth& choice,
                               const score::Strokes& strokes,
                               std::string_view method) {
    if (method != kOracle) return strokes;
    return score::make_strokes(choice.labels, 1, score_options(1));
}

void fill_intersections(const score::Strokes& strokes,
                        const score::Score& at_2px,
                        const ViewTruth& truth,
                        const ViewLists& lists,
                        Row& row) {
    row.above_crease_2px = at_2px;
    row.all_intersections_2px = at_2px;
    if (!lists.other) {
        copy_intersections(row);
        return;
    }
    const bool is_all = truth.intersections == Intersections::all;
    const score::Strokes others = strokes_against(*truth.other, strokes, row.method);
    Counted above(is_all ? others : strokes, is_all ? *lists.other : lists.scoring);
    Counted all(is_all ? strokes : others, is_all ? lists.scoring : *lists.other);
    const Counted& other = is_all ? above : all;
    auto& other_2px = is_all ? row.above_crease_2px : row.all_intersections_2px;
    other_2px.reset();  // no true pixel, no score
    if (!other.lists.truth.is_empty()) other_2px = score::match_counts(other.drawn, other.lists);
    above.fill_intersections(kAboveCrease, row);
    all.fill_intersections(truth::name(truth::LineClass::intersection), row);
    all.fill(kBelowCrease, truth.below_crease, row);
}

void fill_score_2px(const score::Strokes& strokes,
                    const ViewTruth& truth,
                    const ViewLists& lists,
                    Row& row) {
    const score::Score at_2px = score::score_lists(
        strokes, score::counted_pixels(strokes.thinned, lists.scoring), lists.scoring);
    fill_score_2px(at_2px, row);
    fill_intersections(strokes, at_2px, truth, lists, row);
    fill_crowded(strokes, at_2px, truth, lists, row);
}

}  // namespace ink::harness
