#include "harness/empty_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/crowded.h"

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

}  // namespace

std::string emptiness(const ViewTruth& truth) {
    if (has_truth(truth.scoring)) return "";
    const bool is_crowded = truth.traced.counts.crowded_share > kMostCrowded;
    if (is_crowded && truth.with_crowded && has_truth(*truth.with_crowded)) return "";
    return "empty: " + reason(truth);
}

void note_empty(const ViewTruth& truth, std::vector<Evaluation>& evaluations) {
    const std::string status = emptiness(truth);
    if (status.empty()) return;
    for (Evaluation& evaluation : evaluations)
        if (evaluation.row.is_ok()) evaluation.row.status = status;
}

}  // namespace ink::harness
