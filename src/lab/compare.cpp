#include "lab/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/progress.h"
#include "core/whole_file.h"
#include "lab/cancellation_study.h"
#include "lab/cost_model.h"
#include "lab/csv.h"
#include "lab/figures.h"
#include "lab/interrupt.h"
#include "lab/miss_prediction.h"
#include "lab/motion_study.h"
#include "lab/out_folder.h"
#include "lab/shots.h"
#include "lab/skip_study.h"
#include "lab/summary_csv.h"
#include "lab/verdict.h"
#include "lab/view_cells.h"

namespace ink::lab {
namespace {

/// What is kept of a scene from view to view.
struct Known {
    truth::SceneModel& model;
    MissPredictor& predictor;
};

/// A whole table of rows at once: with columns that only the whole run could fill.
void write_rows(const std::vector<Row>& rows, const std::filesystem::path& path) {
    std::string text = fmt::format("{}\n", fmt::join(row_columns(), ","));
    for (const Row& row : rows)
        text += to_csv(row) + "\n";
    core::write_whole_file(path, text);
}

/// One comparison under way: what is written as it goes, and what the report will need.
class Comparison {
  public:
    explicit Comparison(const CompareOptions& options)
        : options_(options),
          cells_{options.measure, options.trace, options.seed},
          rows_(options.out / "rows.csv", row_columns()),
          curves_(options.out / "curves.csv", curve_columns()),
          bins_(options.out / "bins.csv", bin_columns()),
          ladder_(options.out / "ladder.csv", ladder_columns()),
          cancellation_file_(options.out / "cancellation.csv", cancellation_columns()) {
        if (options.sweep.views > 0) {
            sweep_.emplace(options.out / "sweep.csv", row_columns());
        } else {
            forget("sweep.csv");
        }
        forget("skips.csv");
        for (const char* file : {"motion.csv", "roll.csv", "vanishing.csv"})
            forget(file);
        if (!options.study_scaling) forget("scaling.csv");
    }

    void run_subject(const Subject& subject,
                     const std::function<void(const scene::View&)>& before) {
        std::vector<std::unique_ptr<PreparedMethod>> methods;
        for (const Entrant& entrant : options_.entrants) {
            methods.push_back(std::make_unique<PreparedMethod>(entrant, subject.scene));
        }
        truth::SceneModel model(subject.scene, options_.trace.truth);
        MissPredictor predictor(subject.scene);
        for (const scene::View& view : subject.views) {
            if (is_interrupted()) return;
            before(view);
            run_view(subject, view, {model, predictor}, methods);
        }
    }

    void study_scaling() {
        const MeasureOptions& measure = options_.measure;
        scaling_ = lab::study_scaling(options_.entrants,
                                      {.threads = measure.threads, .out = options_.out});
    }

    /// What skips are worth, on pictures of the size of `view`.
    void run_skip_study(const scene::View& view) {
        SkipStudyOptions study;
        study.width_px = view.width_px;
        study.height_px = view.height_px;
        study.threads = options_.measure.threads;
        skip_study_ = study_skips(options_.entrants, study);
        core::write_whole_file(options_.out / "skips.csv", skip_study_csv(skip_study_, study));
        for (std::string& difference : skip_differences(skip_study_))
            void_reasons_.push_back(std::move(difference));
    }

    void run_motion_study() {
        const MotionOptions motion{options_.measure, options_.trace};
        motion_ = study_motion(options_.entrants, motion);
        rolls_ = study_roll(options_.entrants,
                            {.measure = options_.measure, .cache = options_.trace.cache});
        core::write_whole_file(options_.out / "motion.csv", motion_csv(motion_));
        core::write_whole_file(options_.out / "roll.csv", roll_csv(rolls_));
        core::write_whole_file(options_.out / "vanishing.csv", vanishing_csv(rolls_));
        for (std::string& fault : motion_faults(motion_))
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
        ReportData data{options_.command,
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
        write_figures(data, options_.out);
        core::write_whole_file(options_.out / "verdict.md",
                               verdict_markdown(data.rows, data.curves) + "\n");
        core::write_whole_file(options_.out / "summary.csv", summary_csv(data.rows, data.curves));
        const auto report = options_.out / "report.html";
        write_report(data, report);
        return {std::move(result_rows_),
                std::move(data.curves),
                std::move(data.sweep),
                report,
                is_interrupted(),
                std::move(void_reasons_)};
    }

  private:
    /// An older run's file would pass for this one's.
    void forget(const char* file) const {
        std::error_code ignored;
        std::filesystem::remove(options_.out / file, ignored);
    }

    void run_view(const Subject& subject,
                  const scene::View& view,
                  const Known& known,
                  std::vector<std::unique_ptr<PreparedMethod>>& methods) {
        std::vector<Shot> shots = method_shots(methods, view, options_.measure);
        const TracedView traced =
            trace_with_facts(known.model, subject.scene, view, options_.trace);
        finish_shots(subject.scene, view, traced, cells_, shots);
        const ViewTruth& truth = traced.truth;
        if (traced.has_truth()) {
            attribute_shots(truth, view, known.predictor, shots);
            note_cancellation(study_cancellation(truth, view, known.predictor, shots));
        }
        check_brackets(shots, void_reasons_);
        for (const Shot& shot : shots)
            write(shot, subject.scene.split);
        const bool is_first_view = &view == &subject.views.front();
        if (is_first_view && traced.has_truth()) {
            shown_.push_back(shown_view(truth, shots));
        }
        const auto nth = &view - subject.views.data();
        const Row& of_view = shots.back().row;  // the oracle's: ok unless the truth itself is not
        if (nth < options_.sweep.views && traced.has_truth() && of_view.is_ok()) {
            run_sweeps(subject, view, traced, of_view);
        }
    }

    void run_sweeps(const Subject& subject,
                    const scene::View& view,
                    const TracedView& traced,
                    const Row& of_view) {
        for (const Entrant& entrant : options_.entrants) {
            if (is_interrupted()) return;
            for (Row& row :
                 sweep_rows(entrant, subject.scene, view, traced.truth, options_.sweep.measure)) {
                fill_place(subject.scene, view, cells_, row);
                if (row.cost) row.cost->frame = traced.counts;
                fill_truth_facts(traced.truth, row);
                row.witness_disagreement = of_view.witness_disagreement;
                row.witness_px = of_view.witness_px;
                sweep_->write(to_csv(row));
                sweep_rows_.push_back(std::move(row));
            }
        }
    }

    void note_cancellation(std::vector<CancellationRow> rows) {
        for (CancellationRow& row : rows) {
            cancellation_file_.write(cancellation_csv(row));
            cancellation_.push_back(std::move(row));
        }
    }

    void write(const Shot& shot, scene::Split split) {
        rows_.write(to_csv(shot.row));
        result_rows_.push_back(shot.row);
        if (!shot.row.is_ok()) return;
        curves_.write(curve_csv(shot.row, shot.scored.curve));
        ladder_.write(ladder_csv(shot.row));
        const std::string bins = bin_csv(shot.row, shot.row.lines->bins);
        if (!bins.empty()) bins_.write(bins);
        if (shot.row.draw_ns) {
            cell_curves_.push_back(
                {shot.row.method, split == scene::Split::train, shot.scored.curve});
        }
    }

    const CompareOptions& options_;
    CellOptions cells_;
    CsvFile rows_;
    CsvFile curves_;
    CsvFile bins_;
    CsvFile ladder_;
    CsvFile cancellation_file_;
    std::optional<CsvFile> sweep_;
    std::vector<Row> result_rows_;
    std::vector<CellCurve> cell_curves_;
    std::vector<Row> sweep_rows_;
    std::vector<ScalingPoint> scaling_;
    std::vector<ShownView> shown_;
    std::vector<SkipTime> skip_study_;
    std::vector<MotionRow> motion_;
    std::vector<RollCurve> rolls_;
    std::vector<CancellationRow> cancellation_;
    std::vector<std::string> void_reasons_;
};

}  // namespace

CompareResult compare(const std::vector<Subject>& subjects, const CompareOptions& options) {
    using Clock = std::chrono::steady_clock;
    const InterruptGuard guard;
    const auto start = Clock::now();
    make_out_folder(options.out);

    int total = 0;
    for (const Subject& subject : subjects)
        total += static_cast<int>(subject.views.size());
    core::Progress progress("compare", total);
    Comparison comparison(options);
    int done = 0;
    for (const Subject& subject : subjects) {
        if (is_interrupted()) break;
        comparison.run_subject(subject, [&](const scene::View& view) {
            progress.report(done++, fmt::format("{} {}", subject.scene.name, view.camera.name));
        });
    }
    if (options.study_scaling && !is_interrupted()) comparison.study_scaling();
    if (options.study_motion && !is_interrupted()) comparison.run_motion_study();
    if (options.skip_study && total > 0 && !is_interrupted()) {
        comparison.run_skip_study(subjects.front().views.front());
    }
    return comparison.finish(std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace ink::lab
