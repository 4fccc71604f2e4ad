#include "experiment/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/progress.h"
#include "core/whole_file.h"
#include "experiment/cost_model.h"
#include "experiment/summary_csv.h"
#include "harness/csv.h"
#include "harness/interrupt.h"
#include "harness/miss_prediction.h"
#include "harness/out_folder.h"
#include "harness/shots.h"
#include "harness/view_cells.h"
#include "linear_code/cancellation_study.h"
#include "report/figures.h"
#include "report/report.h"
#include "report/verdict.h"
#include "studies/motion_study.h"
#include "studies/skip_study.h"

namespace ink::experiment {
namespace {

/// What is kept of a scene from view to view.
struct Known {
    truth::SceneModel& model;
    harness::MissPredictor& predictor;
};

/// A whole table of rows at once: with columns that only the whole run could fill.
void write_rows(const std::vector<harness::Row>& rows, const std::filesystem::path& path) {
    std::string text = fmt::format("{}\n", fmt::join(harness::row_columns(), ","));
    for (const harness::Row& row : rows)
        text += to_csv(row) + "\n";
    core::write_whole_file(path, text);
}

/// One comparison under way: what is written as it goes, and what the report will need.
class Comparison {
  public:
    explicit Comparison(const CompareOptions& options)
        : options_(options),
          cells_{options.measure, options.trace, options.seed},
          rows_(options.out / "rows.csv", harness::row_columns()),
          curves_(options.out / "curves.csv", harness::curve_columns()),
          bins_(options.out / "bins.csv", harness::bin_columns()),
          ladder_(options.out / "ladder.csv", harness::ladder_columns()),
          cancellation_file_(options.out / "cancellation.csv",
                             linear_code::cancellation_columns()) {
        if (options.sweep.views > 0) {
            sweep_.emplace(options.out / "sweep.csv", harness::row_columns());
        } else {
            forget("sweep.csv");
        }
        forget("skips.csv");
        for (const char* file : {"motion.csv", "roll.csv", "vanishing.csv"})
            forget(file);
        if (!options.study_scaling) forget("scaling.csv");
    }

    void run_subject(const harness::Subject& subject,
                     const std::function<void(const scene::View&)>& before) {
        std::vector<std::unique_ptr<harness::PreparedMethod>> methods;
        for (const harness::Entrant& entrant : options_.entrants) {
            methods.push_back(std::make_unique<harness::PreparedMethod>(entrant, subject.scene));
        }
        truth::SceneModel model(subject.scene, options_.trace.truth);
        harness::MissPredictor predictor(subject.scene);
        for (const scene::View& view : subject.views) {
            if (harness::is_interrupted()) return;
            before(view);
            run_view(subject, view, {model, predictor}, methods);
        }
    }

    void study_scaling() {
        const harness::MeasureOptions& measure = options_.measure;
        scaling_ = studies::study_scaling(options_.entrants,
                                          {.threads = measure.threads, .out = options_.out});
    }

    /// What skips are worth, on pictures of the size of `view`.
    void run_skip_study(const scene::View& view) {
        studies::SkipStudyOptions study;
        study.width_px = view.width_px;
        study.height_px = view.height_px;
        study.threads = options_.measure.threads;
        skip_study_ = studies::study_skips(options_.entrants, study);
        core::write_whole_file(options_.out / "skips.csv",
                               studies::skip_study_csv(skip_study_, study));
        for (std::string& difference : studies::skip_differences(skip_study_))
            void_reasons_.push_back(std::move(difference));
    }

    void run_motion_study() {
        const studies::MotionOptions motion{options_.measure, options_.trace};
        motion_ = studies::study_motion(options_.entrants, motion);
        rolls_ = studies::study_roll(options_.entrants,
                                     {.measure = options_.measure, .cache = options_.trace.cache});
        core::write_whole_file(options_.out / "motion.csv", studies::motion_csv(motion_));
        core::write_whole_file(options_.out / "roll.csv", studies::roll_csv(rolls_));
        core::write_whole_file(options_.out / "vanishing.csv", studies::vanishing_csv(rolls_));
        for (std::string& fault : studies::motion_faults(motion_))
            void_reasons_.push_back(std::move(fault));
    }

    CompareResult finish(double elapsed_s) {
        rows_.finish();
        curves_.finish();
        bins_.finish();
        ladder_.finish();
        cancellation_file_.finish();
        if (sweep_) sweep_->finish();
        const CostFit cost_fit = predict_costs(result_rows_, sweep_rows_);
        if (cost_fit.cells > 0) {
            write_rows(result_rows_, options_.out / "rows.csv");
            if (sweep_) write_rows(sweep_rows_, options_.out / "sweep.csv");
        }
        report::ReportData data{options_.command,
                                result_rows_,
                                std::move(shown_),
                                elapsed_s,
                                std::move(cell_curves_),
                                std::move(sweep_rows_),
                                cost_fit,
                                std::move(scaling_),
                                std::move(skip_study_),
                                std::move(motion_),
                                std::move(rolls_),
                                std::move(cancellation_)};
        report::write_figures(data, options_.out);
        core::write_whole_file(options_.out / "verdict.md",
                               report::verdict_markdown(data.rows, data.curves) + "\n");
        core::write_whole_file(options_.out / "summary.csv", summary_csv(data.rows, data.curves));
        const auto report = options_.out / "report.html";
        report::write_report(data, report);
        return {std::move(result_rows_),
                std::move(data.curves),
                std::move(data.sweep),
                report,
                harness::is_interrupted(),
                std::move(void_reasons_)};
    }

  private:
    /// An older run's file would pass for this one's.
    void forget(const char* file) const {
        std::error_code ignored;
        std::filesystem::remove(options_.out / file, ignored);
    }

    void run_view(const harness::Subject& subject,
                  const scene::View& view,
                  const Known& known,
                  std::vector<std::unique_ptr<harness::PreparedMethod>>& methods) {
        std::vector<harness::Shot> shots = harness::method_shots(methods, view, options_.measure);
        const harness::TracedView traced =
            harness::trace_with_facts(known.model, subject.scene, view, options_.trace);
        harness::finish_shots(subject.scene, view, traced, cells_, shots);
        const harness::ViewTruth& truth = traced.truth;
        if (traced.has_truth()) {
            harness::attribute_shots(truth, view, known.predictor, shots);
            note_cancellation(linear_code::study_cancellation(truth, view, known.predictor, shots));
        }
        harness::check_brackets(shots, void_reasons_);
        for (const harness::Shot& shot : shots)
            write(shot, subject.scene.split);
        const bool is_first_view = &view == &subject.views.front();
        if (is_first_view && traced.has_truth()) {
            shown_.push_back(harness::shown_view(truth, shots));
        }
        const auto nth = &view - subject.views.data();
        const harness::Row& of_view =
            shots.back().row;  // the oracle's: ok unless the truth itself is not
        if (nth < options_.sweep.views && traced.has_truth() && of_view.is_ok()) {
            run_sweeps(subject, view, traced, of_view);
        }
    }

    void run_sweeps(const harness::Subject& subject,
                    const scene::View& view,
                    const harness::TracedView& traced,
                    const harness::Row& of_view) {
        for (const harness::Entrant& entrant : options_.entrants) {
            if (harness::is_interrupted()) return;
            for (harness::Row& row : harness::sweep_rows(
                     entrant, subject.scene, view, traced.truth, options_.sweep.measure)) {
                harness::fill_place(subject.scene, view, cells_, row);
                if (row.cost) row.cost->frame = traced.counts;
                harness::fill_truth_facts(traced.truth, row);
                row.witness_disagreement = of_view.witness_disagreement;
                row.witness_px = of_view.witness_px;
                sweep_->write(to_csv(row));
                sweep_rows_.push_back(std::move(row));
            }
        }
    }

    void note_cancellation(std::vector<linear_code::CancellationRow> rows) {
        for (linear_code::CancellationRow& row : rows) {
            cancellation_file_.write(linear_code::cancellation_csv(row));
            cancellation_.push_back(std::move(row));
        }
    }

    void write(const harness::Shot& shot, scene::Split split) {
        rows_.write(to_csv(shot.row));
        result_rows_.push_back(shot.row);
        if (!shot.row.is_ok()) return;
        curves_.write(harness::curve_csv(shot.row, shot.scored.curve));
        ladder_.write(harness::ladder_csv(shot.row));
        const std::string bins = harness::bin_csv(shot.row, shot.row.lines->bins);
        if (!bins.empty()) bins_.write(bins);
        if (shot.row.draw_ns) {
            cell_curves_.push_back(
                {shot.row.method, split == scene::Split::train, shot.scored.curve});
        }
    }

    const CompareOptions& options_;
    harness::CellOptions cells_;
    harness::CsvFile rows_;
    harness::CsvFile curves_;
    harness::CsvFile bins_;
    harness::CsvFile ladder_;
    harness::CsvFile cancellation_file_;
    std::optional<harness::CsvFile> sweep_;
    std::vector<harness::Row> result_rows_;
    std::vector<statistics::CellCurve> cell_curves_;
    std::vector<harness::Row> sweep_rows_;
    std::vector<studies::ScalingPoint> scaling_;
    std::vector<harness::ShownView> shown_;
    std::vector<studies::SkipTime> skip_study_;
    std::vector<studies::MotionRow> motion_;
    std::vector<studies::RollCurve> rolls_;
    std::vector<linear_code::CancellationRow> cancellation_;
    std::vector<std::string> void_reasons_;
};

}  // namespace

CompareResult compare(const std::vector<harness::Subject>& subjects,
                      const CompareOptions& options) {
    using Clock = std::chrono::steady_clock;
    const harness::InterruptGuard guard;
    const auto start = Clock::now();
    harness::make_out_folder(options.out);

    int total = 0;
    for (const harness::Subject& subject : subjects)
        total += static_cast<int>(subject.views.size());
    core::Progress progress("compare", total);
    Comparison comparison(options);
    int done = 0;
    for (const harness::Subject& subject : subjects) {
        if (harness::is_interrupted()) break;
        comparison.run_subject(subject, [&](const scene::View& view) {
            progress.report(done++, fmt::format("{} {}", subject.scene.name, view.camera.name));
        });
    }
    if (options.study_scaling && !harness::is_interrupted()) comparison.study_scaling();
    if (options.study_motion && !harness::is_interrupted()) comparison.run_motion_study();
    if (options.skip_study && total > 0 && !harness::is_interrupted()) {
        comparison.run_skip_study(subjects.front().views.front());
    }
    return comparison.finish(std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace ink::experiment
