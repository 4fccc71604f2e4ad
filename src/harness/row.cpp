#include "harness/row.h"

namespace ink::harness {

Place place_of(const Row& row) {
    return {row.scene, row.view, row.width, row.height};
}

void clear_times(Row& row) {
    for (auto* time : {&row.prepare_ns,
                       &row.pose_ns,
                       &row.draw_ns,
                       &row.draw_ns_q25,
                       &row.draw_ns_q75,
                       &row.draw_ns_min,
                       &row.predicted_ns}) {
        time->reset();
    }
    row.draw_n = 0;
    row.cost_residual.reset();
}

bool is_baseline(std::string_view method) {
    return method == "none" || method == "sampled" || method == "exact_corner" ||
           method == "oracle";
}

}  // namespace ink::harness
