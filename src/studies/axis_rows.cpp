#include "studies/axis_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "core/parallel.h"
#include "core/simd.h"
#include "harness/scores/evaluations.h"
#include "studies/stress/stress_counts.h"

namespace ink::studies {
namespace {

/// A case on its way to rows.
class CaseWork {
  public:
    CaseWork(const Axis& axis, const Case& one, const harness::CellOptions& options)
        : axis_(axis), one_(one), options_(options) {
        options_.trace.crosscheck = options.trace.crosscheck && axis.is_crosschecked;
        options_.scores_crowded = axis.scores_crowded;
        options_.scores = axis.is_scored ? harness::Scores::brief : harness::Scores::none;
        harness::MeasureOptions& measure = options_.measure;
        measure.threads = one.threads.value_or(measure.threads);
        measure.max_repetitions = axis.repetitions;
        measure.min_repetitions = std::min(measure.min_repetitions, axis.repetitions);
        measure.budget_s = axis.budget_s;
        measure.precision = 0;
    }

    void trace() {
        if (!axis_.is_scored) return;
        truth::SceneModel model(scene(), options_.trace.truth);
        traced_ = harness::trace_with_facts(model, scene(), view(), options_.trace);
    }

    void draw(const std::vector<method::MethodConfig>& configs) {
        // Where nothing is timed, all may draw at once.
        const bool is_timed = axis_.repetitions > 0;
        harness::ViewDrawings drawings{view(),
                                       configs.size(),
                                       is_timed ? harness::most_at_once(drawn_scene()) : 1,
                                       is_timed ? 1 : core::hardware_threads()};
        drawings.ready = [&](std::size_t first, std::size_t end) {
            std::vector<method::MethodConfig> under;
            for (std::size_t m = first; m < end; ++m)
                under.push_back(under_case(configs[m], one_));
            return std::make_shared<harness::PreparedMethods>(
                harness::prepare_methods(under, drawn_scene()));
        };
        overflow_.resize(configs.size(), 0);
        if (axis_.counts_faults) {
            drawings.see = [&](std::size_t n, harness::PreparedMethod& method, const auto& drawn) {
                if (!drawn.row.is_ok()) return;
                const harness::MeasureOptions& measure = options_.measure;
                overflow_[n] = count_overflow(method.method(),
                                              method.config(),
                                              drawn_scene(),
                                              {view(), measure.threads, measure.skips});
            };
        }
        drawn_ = harness::draw_view(drawings, options_.measure);
    }

    void finish() {
        harness::finish_evaluations(
            axis_.is_scored ? scene() : drawn_scene(), view(), traced_, options_, drawn_);
    }

    [[nodiscard]] std::vector<AxisRow> rows() {
        CaseFaults given;
        if (axis_.counts_faults) {
            given = count_inputs(drawn_scene(), view());
            given.non_finite += count_non_finite(traced_.truth.traced);
        }
        const std::size_t own = overflow_.size();
        std::vector<AxisRow> rows;
        for (std::size_t i = 0; i < drawn_.size(); ++i) {
            harness::Row& row = drawn_[i].row;
            row.axis = axis_.name;
            row.value = one_.value;
            row.triangles = static_cast<std::int64_t>(scene::triangle_count(drawn_scene()));
            if (axis_.repetitions == 0) harness::clear_times(row);
            CaseFaults faults = given;
            faults.non_finite += count_non_finite(row);
            faults.overflow += i < own ? overflow_[i] : 0;
            // A difficulty takes no line out of the image: where all are gone the case is lost.
            // Lines that a zoom has made too dense to score are there.
            faults.lost = row.is_ok() || row.status.starts_with("crowded") ? 0 : 1;
            rows.push_back({std::move(row), faults});
        }
        return rows;
    }

  private:
    [[nodiscard]] const scene::Scene& scene() const { return one_.scene_views.scene; }
    [[nodiscard]] const scene::Scene& drawn_scene() const {
        return one_.drawn ? *one_.drawn : scene();
    }
    [[nodiscard]] const scene::View& view() const { return one_.scene_views.views.front(); }

    const Axis& axis_;
    const Case& one_;
    harness::CellOptions options_;
    harness::TracedView traced_;
    std::vector<harness::Evaluation> drawn_;  ///< the methods', then the baselines'
    std::vector<std::int64_t> overflow_;      ///< of the methods
};

}  // namespace

int rows_of_case(const Axis& axis, std::size_t configs) {
    return static_cast<int>(configs) + (axis.is_scored ? harness::kBaselines : 0);
}

std::vector<AxisRow> axis_rows(const Axis& axis,
                               const Case& one,
                               const std::vector<method::MethodConfig>& configs,
                               const harness::CellOptions& options) {
    std::optional<core::ForcedSimdTarget> forced;
    for (const core::SimdTarget& target : core::simd_targets()) {
        if (target.name == one.simd_target) forced.emplace(target);
    }
    CaseWork work(axis, one, options);
    work.trace();
    work.draw(configs);
    work.finish();
    return work.rows();
}

void note_differences(const Axis& axis, std::vector<AxisRow>& rows) {
    if (!axis.same_images) return;
    std::map<std::pair<std::string, std::string>, const harness::Row*> first;  // scene and method
    for (AxisRow& of : rows) {
        if (!of.row.is_ok()) continue;
        const auto [known, is_new] = first.try_emplace({of.row.scene, of.row.method}, &of.row);
        if (known->second->image_hash == of.row.image_hash) continue;
        of.faults.differing = 1;
        of.row.status = fmt::format("differs: the image is another than at {} {}",
                                    axis.name,
                                    format_value(axis, *known->second->value));
    }
}

}  // namespace ink::studies
