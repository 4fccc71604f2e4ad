#include "lab/tune_bound.h"

#include <fmt/format.h>

#include "core/error.h"
#include "lab/interrupt.h"
#include "lab/linear_bound_study.h"

namespace ink::lab {

std::string tune_bound_lines(const std::vector<Subject>& subjects,
                             const TuneResult& result,
                             const TuneOptions& options) {
    const InterruptGuard guard;
    BoundStudyOptions study;
    study.entrant = options.entrant;
    for (const auto& [name, value] : result.tuned.settings)
        study.entrant.settings[name] = value;
    if (!study.entrant.info->make(study.entrant.settings)->code()) return "";
    study.trace = options.trace;
    study.search.threads = options.threads;
    std::string text = "linear bound: no four weights of this code come above it\n";
    try {
        const std::vector<BoundRow> rows = study_bounds(subjects, study);
        for (const char* split : {"train", "heldout"}) {
            const BoundRow* pooled = nullptr;  // the pool's row follows its scenes'
            for (const BoundRow& row : rows) {
                if (row.split == split) pooled = &row;
            }
            if (pooled == nullptr) continue;
            const double f = pooled->measured.f();
            text += fmt::format(
                "  {:<12} F {:.4f} of at most {:.4f}: {:.4f} below; the bound is at most {:.4f} "
                "above what weights reach by its reckoning\n",
                pooled->scene,
                f,
                pooled->bound.f_upper,
                pooled->bound.f_upper - f,
                pooled->bound.gap());
        }
    } catch (const core::Error& reason) {
        return fmt::format("linear bound: none, {}\n", reason.what());
    }
    return is_interrupted() ? "linear bound: interrupted\n" : text;
}

}  // namespace ink::lab
