#include "harness/rows/row.h"

#include <tuple>

namespace ink::harness {
namespace {

/// What a score says, but for `with_crowded_2px`.
template <class AnyRow>
auto scores_of(AnyRow& row) {
    return std::tie(row.f_2px,
                    row.f_1px,
                    row.precision_2px,
                    row.recall_2px,
                    row.mean_width_px,
                    row.ap,
                    row.above_crease_2px,
                    row.all_intersections_2px,
                    row.random_baseline,
                    row.bins,
                    row.soft,
                    row.by_class,
                    row.tolerance_sweep,
                    row.k_2px,
                    row.n_pred,
                    row.n_truth,
                    row.truth_px,
                    row.k_1px,
                    row.n_pred_1px,
                    row.causes,
                    row.unmatched_duplicates,
                    row.false_positives,
                    row.unmatched_truth,
                    row.false_negatives);
}

}  // namespace

Row::Row() = default;
Row::Row(const Row&) = default;
Row::Row(Row&&) noexcept = default;
Row& Row::operator=(const Row&) = default;
Row& Row::operator=(Row&&) noexcept = default;
Row::~Row() = default;

Place place_of(const Row& row) {
    return {row.scene, row.view, row.width, row.height};
}

const core::Provenance& provenance_of(const Row& row) {
    return row.provenance ? *row.provenance : core::provenance();
}

void clear_scores(Row& row) {
    std::apply([](auto&... fields) { ((fields = {}), ...); }, scores_of(row));
}

void copy_scores(const Row& from, Row& to) {
    scores_of(to) = scores_of(from);
    to.with_crowded_2px = from.with_crowded_2px;
}

void clear_times(Row& row) {
    for (auto* time : {&row.prepare_ns,
                       &row.pose_ns,
                       &row.draw_ns,
                       &row.draw_ns_median,
                       &row.draw_ns_q75,
                       &row.draw_ns_min,
                       &row.draw_wall_ns,
                       &row.draw_cpu_ns,
                       &row.yardstick_ns}) {
        time->reset();
    }
    row.draw_n = 0;
    row.time_doubt.clear();
}

bool is_baseline(std::string_view method) {
    return method == "none" || method == "sampled" || method == "exact_corner" || method == kOracle;
}

}  // namespace ink::harness
