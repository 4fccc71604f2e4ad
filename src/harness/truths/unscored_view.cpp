#include "harness/truths/unscored_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "harness/scores/intersection_scores.h"
#include "truth/limits.h"

namespace ink::harness {
namespace {

bool has_truth(const score::ScoringTruth& truth) {
    return !truth.labels_in_use.empty();
}

std::string reason(const ViewTruth& truth) {
    const auto& labels = truth.traced.labels;
    const auto* const end = labels.data() + labels.size();
    const auto lines = end - labels.data() - std::count(labels.data(), end, std::uint8_t{0});
    if (lines > 0) {
        return fmt::format(
            "no true pixel counts: all {} lie within {} px of the frame, or are ignored",
            lines,
            kBand_px);
    }
    const truth::TruthCounts& counts = truth.traced.counts;
    if (counts.triangles == counts.degenerate) return "no triangle has an area";
    return "no line of the scene is in the image";
}

/// The status of a view that is too crowded, "crowded: ..."; "" for one that is not.
std::string crowdedness(const ViewTruth& truth) {
    const double share = truth.traced.counts.crowded_share;
    if (share <= kMostCrowded) return "";
    return fmt::format(
        "crowded: {:.0f} % of the true pixels are too dense to score, of {:.0f} % at most",
        100 * share,
        100 * kMostCrowded);
}

}  // namespace

void fill_crowded(const score::Strokes& strokes,
                  const score::Score& at_2px,
                  const ViewTruth& truth,
                  const ViewLists& lists,
                  Row& row) {
    row.with_crowded_2px = at_2px;
    if (!lists.with_crowded) return;
    const score::Strokes all = strokes_against(*truth.with_crowded, strokes, row.method);
    row.with_crowded_2px = score::match_counts(
        score::counted_pixels(all.thinned, *lists.with_crowded), *lists.with_crowded);
}

void note_crowded(const ViewTruth& truth, std::vector<Evaluation>& evaluations) {
    const std::string status = crowdedness(truth);
    if (status.empty()) return;
    for (Evaluation& evaluation : evaluations) {
        if (!evaluation.row.is_ok()) continue;
        clear_scores(evaluation.row);
        evaluation.row.status = status;
    }
}

std::string emptiness(const ViewTruth& truth) {
    if (has_truth(truth.scoring)) return "";
    const bool has_crowded = truth.with_crowded && has_truth(*truth.with_crowded);
    const std::string crowded = has_crowded ? crowdedness(truth) : "";
    return crowded.empty() ? "empty: " + reason(truth) : crowded;
}

ViewTruth trace_scored_view(truth::SceneModel& model,
                            const std::string& scene,
                            const scene::View& view,
                            const TraceOptions& trace) {
    const std::string where = scene + " " + view.camera.name;
    try {
        ViewTruth truth = trace_view(model, view, trace);
        if (const std::string reason = emptiness(truth); !reason.empty())
            throw core::Error(where, reason, "scenes, views and a --size that show lines");
        return truth;
    } catch (const truth::TooLarge& reason) {
        throw core::Error(where, reason.what(), "a smaller scene or --size");
    }
}

void note_empty(const ViewTruth& truth, std::vector<Evaluation>& evaluations) {
    const std::string status = emptiness(truth);
    if (!status.starts_with("empty")) return;  // a crowded one has an F all the same
    for (Evaluation& evaluation : evaluations)
        if (evaluation.row.is_ok()) evaluation.row.status = status;
}

}  // namespace ink::harness
