#include "studies/axis_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "core/parallel.h"
#include "core/simd.h"
#include "harness/evaluations.h"
#include "studies/stress/stress_counts.h"

namespace ink::studies {
namespace {

/// A value at which each method draws a case.
struct Arm {
    double value = 0;
    raster::SkipSet skips;
};

std::vector<Arm> arms_of(const Axis& axis, const Case& one, const raster::SkipSet& skips) {
    if (!axis.allowed) return {{one.value, skips}};
    std::vector<Arm> arms;
    for (const double value : axis.values)
        arms.push_back({value, axis.allowed(value)});
    return arms;
}

/// A case on its way to rows.
class CaseWork {
  public:
    CaseWork(const Axis& axis, const Case& one, const harness::CellOptions& options)
        : axis_(axis),
          one_(one),
          options_(options),
          arms_(arms_of(axis, one, options.measure.skips)) {
        options_.trace.crosscheck = options.trace.crosscheck && axis.is_crosschecked;
        options_.scores_crowded = axis.scores_crowded;
        harness::MeasureOptions& measure = options_.measure;
        measure.threads = one.threads.value_or(measure.threads);
        measure.max_repetitions = axis.repetitions;
        measure.min_repetitions = std::min(measure.min_repetitions, axis.repetitions);
        measure.budget_s = axis.budget_s;
        measure.precision = 0;
    }

    [[nodiscard]] const std::vector<harness::Evaluation>& evaluations() const { return drawn_; }
    [[nodiscard]] const harness::TracedView& traced() const { return traced_; }

    void trace() {
        if (!axis_.is_scored) return;
        truth::SceneModel model(scene(), options_.trace.truth);
        traced_ = harness::trace_with_facts(model, scene(), view(), options_.trace);
    }

    void draw(const std::vector<method::MethodConfig>& configs) {
        drawn_.resize(configs.size() * arms_.size());
        overflow_.resize(drawn_.size(), 0);
        const std::size_t at_once =
            axis_.repetitions > 0 ? harness::most_at_once(drawn_scene()) : 1;
        const std::size_t parts = (configs.size() + at_once - 1) / at_once;
        // Where nothing is timed, all may draw at once.
        const int threads = axis_.repetitions > 0 ? 1 : core::hardware_threads();
        core::parallel_for(parts, threads, [&](std::size_t part) {
            const std::size_t first = part * at_once;
            draw_some(configs, first, std::min(configs.size(), first + at_once));
        });
    }

    void finish() {
        if (axis_.is_scored) {
            harness::finish_briefly(scene(), view(), traced_, options_, drawn_);
        } else {
            harness::finish_drawn(drawn_scene(), view(), options_, drawn_);
        }
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
            row.value = i < own ? arms_[i % arms_.size()].value : one_.value;
            row.triangles = static_cast<std::int64_t>(scene::triangle_count(drawn_scene()));
            if (arms_.size() > 1) row.view = fmt::format("{}={:g}", row.axis, *row.value);
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

    /// The configurations from `first` to `end`, in turns.
    void draw_some(const std::vector<method::MethodConfig>& configs,
                   std::size_t first,
                   std::size_t end) {
        std::vector<std::unique_ptr<harness::PreparedMethod>> methods;
        std::vector<harness::Turn> turns;
        for (std::size_t m = first; m < end; ++m) {
            methods.push_back(std::make_unique<harness::PreparedMethod>(
                under_case(configs[m], one_), drawn_scene()));
            for (const Arm& arm : arms_)
                turns.push_back({methods.back().get(), arm.skips});
        }
        auto some = harness::method_evaluations(
            turns, {view(), &drawn_scene(), one_.poses}, options_.measure);
        for (std::size_t i = 0; i < some.size(); ++i) {
            const std::size_t at = first * arms_.size() + i;
            if (axis_.counts_faults && some[i].row.is_ok()) {
                overflow_[at] = count_overflow(turns[i].method->method(),
                                               turns[i].method->config(),
                                               drawn_scene(),
                                               {view(), options_.measure.threads, turns[i].skips});
            }
            drawn_[at] = std::move(some[i]);
        }
    }

    const Axis& axis_;
    const Case& one_;
    harness::CellOptions options_;
    std::vector<Arm> arms_;
    harness::TracedView traced_;
    std::vector<harness::Evaluation> drawn_;  ///< the methods', then the baselines'
    std::vector<std::int64_t> overflow_;      ///< of the methods
};

}  // namespace

int rows_of_case(const Axis& axis, std::size_t configs) {
    const std::size_t arms = axis.allowed ? axis.values.size() : 1;
    return static_cast<int>(configs * arms) + (axis.is_scored ? harness::kBaselines : 0);
}

std::vector<AxisRow> axis_rows(const Axis& axis,
                               const Case& one,
                               const std::vector<method::MethodConfig>& configs,
                               const harness::CellOptions& options,
                               AxisObserver* observer,
                               std::int64_t first_cell) {
    std::optional<core::ForcedSimdTarget> forced;
    for (const core::SimdTarget& target : core::simd_targets()) {
        if (target.name == one.simd_target) forced.emplace(target);
    }
    CaseWork work(axis, one, options);
    work.trace();
    work.draw(configs);
    work.finish();
    if (observer != nullptr) observer->see(one, work.traced(), work.evaluations(), first_cell);
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
