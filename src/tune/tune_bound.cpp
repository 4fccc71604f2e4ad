#include "tune/tune_bound.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/interrupt.h"
#include "linear_code/linear_bound_study.h"

namespace ink::tune {

std::string tune_bound_lines(const std::vector<harness::SceneViews>& scenes,
                             const TuneResult& result,
                             const TuneOptions& options) {
    const core::InterruptGuard guard("all but the linear bound is in the folder");
    linear_code::BoundStudyOptions study;
    study.config = method::with(options.config, result.tuned.settings);
    if (!study.config.info->make(study.config.settings)->code()) return "";
    study.trace = options.trace;
    study.search.threads = options.threads;
    std::string text = "linear bound: no four weights of this code can exceed it\n";
    try {
        const std::vector<linear_code::BoundRow> rows = linear_code::study_bounds(scenes, study);
        for (const char* split : {"train", "heldout", "real"}) {
            const linear_code::BoundRow* pooled = nullptr;  // the pool's row follows its scenes'
            for (const linear_code::BoundRow& row : rows) {
                if (row.split == split) pooled = &row;
            }
            if (pooled == nullptr) continue;
            const double f = pooled->measured.f();
            text += fmt::format(
                "  {:<12} F {:.4f} of at most {:.4f}: {:.4f} below; by the bound's own rule some "
                "weights come within {:.4f} of it\n",
                pooled->scene,
                f,
                pooled->bound.f_upper,
                pooled->bound.f_upper - f,
                pooled->bound.gap());
        }
    } catch (const core::Error& reason) {
        return fmt::format("linear bound: none, {}\n", reason.what());
    }
    return core::is_interrupted() ? "linear bound: interrupted\n" : text;
}

}  // namespace ink::tune
