#include "core/error.h"
#include "lab/experiment_plan.h"

namespace ink::lab {

void plan_stress(const Experiment& experiment, const TraceOptions&, Plan&) {
    throw core::Error(experiment.file.string(), "stress is not here yet", "compare | animation");
}

}  // namespace ink::lab
