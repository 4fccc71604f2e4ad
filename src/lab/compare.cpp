#include "lab/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "core/hash.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "core/whole_file.h"
#include "lab/csv.h"
#include "lab/figures.h"
#include "lab/interrupt.h"
#include "lab/line_scores.h"
#include "lab/miss_prediction.h"
#include "lab/verdict.h"
#include "score/chance.h"
#include "truth/curve_facts.h"
#include "truth/witness_cache.h"

namespace ink::lab {
namespace {

/// One picture of a view on its way to a row.
struct Shot {
    Row row;
    edge::EdgeImage picture;
    int threshold = 128;
    std::optional<methods::LinearCode> code;
    Scored scored;
};

edge::EdgeImage full_strength(const core::Image<std::uint8_t>& labels) {
    edge::EdgeImage picture(labels.width_px(), labels.height_px());
    std::transform(
        labels.data(), labels.data() + labels.size(), picture.data(), [](std::uint8_t label) {
            return label != 0 ? 255 : 0;
        });
    return picture;
}

/// The rows that stand in every run and are no methods: floor, truth itself, one-sample ceiling.
std::vector<Shot> bracket_shots(const ViewTruth& truth) {
    std::vector<Shot> shots(3);
    const auto& labels = truth.scoring.labels;
    shots[0].row.method = "none";
    shots[0].picture = edge::EdgeImage(labels.width_px(), labels.height_px());
    shots[1].row.method = "sampled";
    shots[1].picture = truth.traced.sampled;
    shots[2].row.method = "oracle";
    shots[2].picture = full_strength(labels);
    return shots;
}

std::vector<Shot> method_shots(std::vector<std::unique_ptr<PreparedMethod>>& methods,
                               const scene::View& view,
                               const MeasureOptions& measure) {
    std::vector<edge::EdgeImage> pictures;
    std::vector<DrawTimes> times = draw_in_turns(methods, view, measure, pictures);
    std::vector<Shot> shots(methods.size());
    for (std::size_t i = 0; i < methods.size(); ++i) {
        shots[i].row = methods[i]->row();
        shots[i].picture = std::move(pictures[i]);
        shots[i].threshold = methods[i]->threshold();
        if (methods[i]->failure().empty()) shots[i].code = methods[i]->method().code();
        if (!times[i].failure.empty()) shots[i].row.status = times[i].failure;
        fill_times(std::move(times[i].draw_ns), shots[i].row);
    }
    return shots;
}

void fill_place(const Subject& subject,
                const scene::View& view,
                const CompareOptions& options,
                Row& row) {
    row.scene = subject.scene.name;
    row.view = view.camera.name;
    row.split = subject.scene.split == scene::Split::train ? "train" : "heldout";
    row.width = view.width_px;
    row.height = view.height_px;
    row.threads = options.measure.threads;
    row.seed = options.seed;
    row.weld_epsilon = options.trace.truth.weld_epsilon;
    row.triangles = static_cast<std::int64_t>(scene::triangle_count(subject.scene));
}

/// Each view has random pictures of its own; the same of a seed, whatever else takes part.
std::uint64_t chance_seed(const Row& row) {
    return core::Hasher().value(row.seed).text(row.scene).text(row.view).result();
}

/// Why each shot is wrong where it is. One after the other: they share what is kept of the scene.
void attribute_shots(const ViewTruth& truth,
                     const scene::View& view,
                     MissPredictor& predictor,
                     std::vector<Shot>& shots) {
    for (Shot& shot : shots) {
        if (!shot.row.is_ok()) continue;
        shot.scored.attribution =
            predictor.attribute(shot.scored.wrong_2px, truth, view, {shot.code, shot.threshold});
        shot.row.causes = shot.scored.attribution.counts;
    }
}

/// What rows of one view have in common.
void fill_truth_facts(const ViewTruth& truth, Row& row) {
    const truth::ContourLengths behind = truth::contour_lengths(truth.traced.curves);
    row.contour_sky_px = behind.sky_px;
    row.contour_other_px = behind.other_object_px;
    row.contour_self_px = behind.self_px;
    row.truth_merged_px = static_cast<std::int64_t>(truth.traced.counts.merged_px);
    row.crowded_share = truth.traced.counts.crowded_share;
}

void score_shots(const ViewTruth& truth, std::vector<Shot>& shots) {
    const LineTruth lines = prepare_lines(truth);
    const score::Chance chance(truth.scoring, score_options(255), chance_seed(shots.front().row));
    // Scores are not timed, so they may use every core.
    core::parallel_for(shots.size(), core::hardware_threads(), [&](std::size_t i) {
        Shot& shot = shots[i];
        if (!shot.row.is_ok()) return;
        shot.scored = score_picture(shot.picture, truth.scoring, shot.threshold);
        fill_scores(shot.scored, shot.row);
        shot.row.chance = chance.counts(shot.row.n_pred);
        shot.row.lines = score_lines(shot.scored.strokes, lines);
        shot.scored.strokes = {};
        shot.row.image_hash = core::image_hash(shot.picture);
    });
    for (Shot& shot : shots)
        fill_truth_facts(truth, shot.row);
}

/// What the witness says of the truth stands in every row of the view; a truth that it disputes
/// scores nobody.
void note_witness(const truth::WitnessCheck& check, std::vector<Shot>& shots) {
    const double rate = check.agreement.disagreement_rate();
    const truth::ClassAgreement total = check.agreement.total();
    for (Shot& shot : shots) {
        shot.row.witness_disagreement = rate;
        shot.row.witness_px = total.truth_px + total.witness_px;
        if (shot.row.is_ok() && rate > truth::kAllowedShare) {
            shot.row.status = fmt::format(
                "truth_disputed: the witness disagrees on {:.3f} % of the lines", 100 * rate);
        }
    }
}

/// A run whose brackets do not come out as they must says nothing about methods either.
void check_brackets(const std::vector<Shot>& shots, std::vector<std::string>& reasons) {
    for (const Shot& shot : shots) {
        const Row& row = shot.row;
        if (!row.is_ok() || !row.f_2px) continue;
        if (row.method == "oracle" && *row.f_2px != 1) {
            reasons.push_back(fmt::format(
                "oracle has F = {:.6f} on {} {}, not 1", *row.f_2px, row.scene, row.view));
        }
        if (row.method == "none" && row.n_truth > 0 && *row.f_2px != 0) {
            reasons.push_back(fmt::format(
                "none has F = {:.6f} on {} {}, not 0", *row.f_2px, row.scene, row.view));
        }
    }
}

ShownView shown_view(const ViewTruth& truth, const std::vector<Shot>& shots) {
    ShownView shown{shots.front().row.scene, shots.front().row.view, truth.traced.labels, {}};
    for (const Shot& shot : shots) {
        if (!shot.row.is_ok() || shot.row.method == "none" || shot.row.method == "oracle") continue;
        shown.pictures.push_back(
            {shot.row.method, shot.picture, shot.threshold, shot.scored.attribution.pixels});
    }
    return shown;
}

/// What is kept of a scene from view to view.
struct Known {
    truth::SceneModel& model;
    MissPredictor& predictor;
};

/// One comparison under way: what is written as it goes, and what the report will need.
class Comparison {
  public:
    explicit Comparison(const CompareOptions& options)
        : options_(options),
          rows_(options.out / "rows.csv", row_columns()),
          curves_(options.out / "curves.csv", curve_columns()),
          bins_(options.out / "bins.csv", bin_columns()),
          ladder_(options.out / "ladder.csv", ladder_columns()) {
        const auto sweep = options.out / "sweep.csv";
        if (options.sweep.views > 0) {
            sweep_.emplace(sweep, row_columns());
        } else {
            std::error_code ignored;
            std::filesystem::remove(sweep, ignored);  // an older run's would pass for this one's
        }
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

    CompareResult finish(double elapsed_s) {
        rows_.finish();
        curves_.finish();
        bins_.finish();
        ladder_.finish();
        if (sweep_) sweep_->finish();
        ReportData data{options_.command,
                        result_rows_,
                        std::move(shown_),
                        elapsed_s,
                        std::move(cell_curves_),
                        std::move(sweep_rows_)};
        write_figures(data, options_.out);
        core::write_whole_file(options_.out / "verdict.md",
                               verdict_markdown(data.rows, data.curves) + "\n");
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
    void run_view(const Subject& subject,
                  const scene::View& view,
                  const Known& known,
                  std::vector<std::unique_ptr<PreparedMethod>>& methods) {
        std::vector<Shot> shots = method_shots(methods, view, options_.measure);
        ViewTruth truth;
        std::optional<truth::WitnessCheck> check;
        try {
            truth = trace_view(known.model, view, options_.trace.cache);
            if (options_.trace.witness) {
                check =
                    truth::cached_witness(known.model, view, truth.traced, options_.trace.cache);
            }
            std::vector<Shot> brackets = bracket_shots(truth);
            std::move(brackets.begin(), brackets.end(), std::back_inserter(shots));
        } catch (const truth::TooLarge& reason) {
            for (Shot& shot : shots)
                shot.row.status = fmt::format("too_large: {}", reason.what());
        } catch (const std::bad_alloc&) {
            for (Shot& shot : shots)
                shot.row.status = "too_large: no memory to trace the truth";
        }
        for (Shot& shot : shots)
            fill_place(subject, view, options_, shot.row);
        if (check) note_witness(*check, shots);
        if (!truth.traced.labels.is_empty()) {
            score_shots(truth, shots);
            attribute_shots(truth, view, known.predictor, shots);
        }
        check_brackets(shots, void_reasons_);
        for (const Shot& shot : shots)
            write(shot, subject.scene.split);
        const bool is_first_view = &view == &subject.views.front();
        if (is_first_view && !truth.traced.labels.is_empty()) {
            shown_.push_back(shown_view(truth, shots));
        }
        const auto nth = &view - subject.views.data();
        const Row& of_view = shots.back().row;  // the oracle's: ok unless the truth itself is not
        if (nth < options_.sweep.views && !truth.traced.labels.is_empty() && of_view.is_ok()) {
            run_sweeps(subject, view, truth, of_view);
        }
    }

    void run_sweeps(const Subject& subject,
                    const scene::View& view,
                    const ViewTruth& truth,
                    const Row& of_view) {
        for (const Entrant& entrant : options_.entrants) {
            if (is_interrupted()) return;
            for (Row& row :
                 sweep_rows(entrant, subject.scene, view, truth, options_.sweep.measure)) {
                fill_place(subject, view, options_, row);
                fill_truth_facts(truth, row);
                row.witness_disagreement = of_view.witness_disagreement;
                row.witness_px = of_view.witness_px;
                sweep_->write(to_csv(row));
                sweep_rows_.push_back(std::move(row));
            }
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
    CsvFile rows_;
    CsvFile curves_;
    CsvFile bins_;
    CsvFile ladder_;
    std::optional<CsvFile> sweep_;
    std::vector<Row> result_rows_;
    std::vector<CellCurve> cell_curves_;
    std::vector<Row> sweep_rows_;
    std::vector<ShownView> shown_;
    std::vector<std::string> void_reasons_;
};

void make_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder)) {
        throw core::Error(
            folder.string(), "this folder cannot be made", "a writable place for --out");
    }
}

}  // namespace

CompareResult compare(const std::vector<Subject>& subjects, const CompareOptions& options) {
    using Clock = std::chrono::steady_clock;
    const InterruptGuard guard;
    const auto start = Clock::now();
    make_folder(options.out);

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
    return comparison.finish(std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace ink::lab
