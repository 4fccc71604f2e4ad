#include "harness/row.h"

namespace ink::harness {

Place place_of(const Row& row) {
    return {row.scene, row.view, row.width, row.height};
}

const core::Provenance& provenance_of(const Row& row) {
    return row.provenance ? *row.provenance : core::provenance();
}

void clear_scores(Row& row) {
    const auto clear = [](auto&... fields) { ((fields = {}), ...); };
    clear(row.f_2px, row.f_1px, row.precision_2px, row.recall_2px, row.mean_width_px, row.ap);
    clear(
        row.above_crease_2px, row.all_intersections_2px, row.random_baseline, row.lines, row.soft);
    clear(row.recall_by_class, row.truth_px_by_class, row.k_by_class, row.tolerance_sweep);
    clear(row.k_2px, row.n_pred, row.n_truth, row.truth_px, row.k_1px, row.n_pred_1px, row.causes);
    clear(row.unmatched_duplicates, row.false_positives, row.unmatched_truth, row.false_negatives);
}

void clear_times(Row& row) {
    for (auto* time : {&row.prepare_ns,
                       &row.pose_ns,
                       &row.draw_ns,
                       &row.draw_ns_q25,
                       &row.draw_ns_q75,
                       &row.draw_ns_min}) {
        time->reset();
    }
    row.draw_n = 0;
}

bool is_baseline(std::string_view method) {
    return method == "none" || method == "sampled" || method == "exact_corner" || method == kOracle;
}

}  // namespace ink::harness
