#include "studies/motion_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numeric>

#include "catalogue/catalogue.h"
#include "core/hash.h"
#include "core/interrupt.h"
#include "core/parallel.h"
#include "harness/cells/view_cells.h"
#include "harness/clock/timing.h"
#include "harness/scores/evaluations.h"
#include "harness/suite/suite.h"
#include "scene/animation.h"
#include "score/drawing.h"

namespace ink::studies {
namespace {

/// A truth as motion is scored against: ignored pixels taken out and thinned again as everywhere,
/// but with no band (see score::motion_frame).
score::ScoringTruth unbanded_truth(const truth::Truth& traced, score::Intersections intersections) {
    score::ScoreOptions options = harness::score_options(1);
    options.band_px = 0;
    return score::prepare_truth(
        score::counted_labels(traced.labels, traced.below_crease, intersections), options, true);
}

/// One method's images of a sequence as they are scored, and the row that they come to.
struct Record {
    MotionRow row;
    std::vector<score::MotionFrame> frames;
    std::vector<std::vector<score::FeatureSight>> sights;
    core::Hasher images;
    core::Image<float> ink;  ///< of the last frame
    score::SoftScore soft;
    score::InkChange change;
};

void take(const harness::Evaluation& drawn,
          const std::vector<truth::Curve>& curves,
          const score::ScoringTruth& scoring,
          Record& record) {
    const score::ScoreOptions options = harness::score_options(drawn.threshold);
    const score::Strokes strokes = score::make_strokes(drawn.image, drawn.threshold, options);
    const edge::Mask thinned = strokes.thinned.bytes();
    record.frames.push_back(score::motion_frame(thinned, scoring, options));
    record.sights.push_back(score::see_features(curves, thinned, scoring, options));
    record.images.bytes(drawn.image.data(), drawn.image.size());
}

/// Scores the ink of a frame, and its change if there was a frame before.
void take_ink(const harness::Evaluation& drawn,
              const std::optional<score::InkTruth>& before,
              const score::InkTruth& truth,
              Record& record) {
    core::Image<float> ink = harness::drawn_ink(drawn, truth);
    record.soft += score::score_ink(ink, truth, harness::score_options(1));
    if (before) record.change += score::ink_change(record.ink, *before, ink, truth);
    record.ink = std::move(ink);
}

/// The baselines of a frame; the oracle is the truth as motion is scored against.
std::vector<harness::Evaluation> baselines_of(const harness::ViewTruth& truth,
                                              const score::ScoringTruth& scoring) {
    std::vector<harness::Evaluation> baselines = harness::baseline_evaluations(truth);
    std::erase_if(baselines, [](const auto& drawn) { return drawn.row.method == "none"; });
    baselines.back().image = scoring.labels;
    baselines.back().threshold = 1;
    return baselines;
}

/// A sequence under way: methods made ready, records that grow frame by frame.
class Run {
  public:
    Run(const std::vector<method::MethodConfig>& configs,
        Sequence& sequence,
        const harness::CellOptions& options)
        : sequence_(sequence), options_(options) {
        options_.measure.max_repetitions = 0;  // the first round draws, and is not timed
        options_.trace.crosscheck = false;
        for (const method::MethodConfig& config : configs) {
            methods_.push_back(std::make_unique<harness::PreparedMethod>(config, sequence.scene));
            const harness::Row row = methods_.back()->row();
            add_record(row.method, row.params);
        }
        for (const char* baseline : {"sampled", "exact_corner", "oracle"})
            add_record(baseline, "");
    }

    void draw_all() {
        for (int frame = 0; frame < sequence_.path.frame_count; ++frame) {
            if (core::is_interrupted() || !records_.back().row.is_ok()) return;
            const scene::PathFrame at = scene::frame_at(sequence_.path, frame);
            if (frame == 0 || sequence_.pose) model_.reset();
            if (sequence_.pose) pose(at.time_s);
            if (!model_) model_.emplace(sequence_.scene, options_.trace.truth);
            draw(at.view);
        }
    }

    [[nodiscard]] std::vector<MotionRow> rows() {
        std::vector<MotionRow> rows;
        for (Record& record : records_) {
            if (record.row.is_ok()) fill(record);
            rows.push_back(std::move(record.row));
        }
        return rows;
    }

  private:
    void add_record(std::string method, std::string params) {
        const scene::CameraPath& path = sequence_.path;
        MotionRow& row = records_.emplace_back().row;
        harness::fill_place(sequence_.scene, path.start, options_, row);
        row.method = std::move(method);
        row.params = std::move(params);
        row.view = scene::name(path.kind);
        row.frames = path.frame_count;
        row.frames_per_s = path.frames_per_s;
        row.step_px = sequence_.step_px;
    }

    void pose(double time_s) {
        sequence_.pose(sequence_.scene, time_s);
        for (std::size_t i = 0; i < methods_.size(); ++i) {
            if (!methods_[i]->failure().empty() || !records_[i].row.is_ok()) continue;
            const std::string failure =
                harness::failure_of([&] { methods_[i]->method().pose(sequence_.scene); });
            fail(records_[i], failure);
        }
    }

    void draw(const scene::View& view) {
        const harness::TracedView traced =
            harness::trace_with_facts(*model_, sequence_.scene, view, options_.trace);
        if (!traced.has_truth()) {
            for (Record& record : records_)
                fail(record, traced.failure);
            return;
        }
        const score::ScoringTruth scoring =
            unbanded_truth(traced.truth.traced, options_.trace.intersections);
        const std::vector<truth::Curve> curves =
            score::counted_curves(traced.truth.traced.curves,
                                  options_.trace.truth.crease_rad,
                                  options_.trace.intersections);
        std::vector<harness::Evaluation> drawn =
            harness::method_evaluations(methods_, view, options_.measure);
        for (std::size_t i = 0; i < methods_.size(); ++i)
            if (!drawn[i].row.is_ok()) fail(records_[i], drawn[i].row.status);
        for (harness::Evaluation& baseline : baselines_of(traced.truth, scoring))
            drawn.push_back(std::move(baseline));
        std::optional<score::InkTruth> ink;
        if (options_.line_width_px) ink = harness::true_ink(traced.truth, *options_.line_width_px);
        core::parallel_for(drawn.size(), core::hardware_threads(), [&](std::size_t i) {
            if (!records_[i].row.is_ok()) return;
            take(drawn[i], curves, scoring, records_[i]);
            if (ink) take_ink(drawn[i], ink_before_, *ink, records_[i]);
        });
        ink_before_ = std::move(ink);
    }

    /// The first failure of a method is what its row says.
    static void fail(Record& record, const std::string& failure) {
        if (record.row.is_ok() && !failure.empty()) record.row.status = failure;
    }

    void fill(Record& record) const {
        MotionRow& row = record.row;
        const auto lines = score::false_lines(record.frames, harness::kTolerance_px);
        row.flicker = score::flicker(record.frames, harness::kTolerance_px);
        row.pops = score::count_pops(record.sights);
        row.lives = score::life_counts(lines);
        row.lives_cut = std::ranges::count_if(lines, [](const auto& line) { return line.is_cut; });
        row.image_hash = record.images.hex();
        if (!options_.line_width_px) return;
        row.soft = record.soft;
        row.ink = record.change;
    }

    Sequence& sequence_;
    harness::CellOptions options_;
    harness::PreparedMethods methods_;
    std::vector<Record> records_;  ///< the methods', then those of the baselines
    std::optional<truth::SceneModel> model_;
    std::optional<score::InkTruth> ink_before_;  ///< of the last frame
};

/// How fast the image moves where it moves fastest at the start: over the first 60th of a second.
double speed_px_per_s(scene::Scene scene, const scene::View& view) {
    constexpr double kMoment_s = 1.0 / 60;
    const scene::Projection projection(view);
    std::vector<glm::dvec2> before;
    double most_px = 0;
    for (const double time_s : {0.0, kMoment_s}) {
        scene::pose_scene(scene, time_s);
        std::size_t n = 0;
        for (const scene::Instance& instance : scene.instances) {
            for (const glm::vec3& p_object : scene.meshes[instance.mesh].positions) {
                const glm::dvec3 p = projection.to_clip(scene::to_world(instance, p_object));
                const glm::dvec2 p_px(p.x / p.z, p.y / p.z);
                if (time_s == 0) before.push_back(p_px);
                most_px = std::max(most_px, glm::length(p_px - before[n++]));
            }
        }
    }
    return most_px / kMoment_s;
}

/// An animated scene of the catalogue before its second view, which stands still: so many times
/// slower than it is that what moves fastest moves by the step at most.
Sequence sequence_of_motion(const std::string& name, const SequenceFrames& frames) {
    Sequence sequence = sequence_along(scene::PathKind::still, name, frames);
    scene::CameraPath& path = sequence.path;
    constexpr int kPoses = 16;
    std::vector<double> times_s;
    for (int i = 0; i <= kPoses; ++i)
        times_s.push_back(sequence.scene.animation->duration_s * i / kPoses);
    path.bounds = scene::bounds_of_poses(sequence.scene, times_s);
    const double most_px_per_s = frames.step_px * path.frames_per_s;
    const double times = std::ceil(speed_px_per_s(sequence.scene, path.start) / most_px_per_s);
    sequence.pose = [times](scene::Scene& scene, double time_s) {
        scene::pose_scene(scene, time_s / times);
    };
    return sequence;
}

std::int64_t total(const std::vector<std::int64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

/// Counts that a cell has if it did not fail.
void add_flicker(const core::PartOf<harness::OfCell<MotionRow>>& counts) {
    using F = score::Flicker;
    const auto flicker = counts.part(&MotionRow::flicker);
    flicker.add_derived(
        {"flicker", "0..1", "share of the counted pixels that appeared or disappeared"}, &F::share);
    flicker.add({"appeared_px", "px", "drawn pixels with none in reach a frame before"},
                &F::appeared);
    flicker.add({"disappeared_px", "px", "drawn pixels with none in reach a frame later"},
                &F::disappeared);
    flicker.add({"excused_px", "px", "such pixels where the truth itself appeared or disappeared"},
                &F::excused);
    flicker.add({"counted_px", "px", "drawn pixels of both frames of each step"}, &F::n_counted);
}

void add_pops(const core::PartOf<harness::OfCell<MotionRow>>& counts) {
    using P = score::PopCount;
    const auto pops = counts.part(&MotionRow::pops);
    pops.add({"pops", "", "features shown, then dropped, then shown again"}, &P::pops);
    pops.add({"feature_runs", "", "runs of frames in which one feature is there"}, &P::runs);
    pops.add({"feature_steps", "", "steps from frame to frame in these runs"}, &P::steps);
}

void add_false_lines(const core::PartOf<harness::OfCell<MotionRow>>& counts) {
    counts.add_derived({"false_lines", "", "lines drawn where none is"},
                       [](const MotionRow& m) { return total(m.lives); });
    counts.add({"false_lines_cut", "", "of them, in the first or last frame: they may live longer"},
               &MotionRow::lives_cut);
}

}  // namespace

std::vector<MotionRow> study_sequence(const std::vector<method::MethodConfig>& configs,
                                      Sequence& sequence,
                                      const harness::CellOptions& options) {
    Run run(configs, sequence, options);
    run.draw_all();
    return core::is_interrupted() ? std::vector<MotionRow>{} : run.rows();
}

Sequence sequence_along(scene::PathKind path,
                        const std::string& scene,
                        const SequenceFrames& frames) {
    harness::SceneViews scene_views = harness::make_scene_views(
        harness::load_scene(scene), {.width_px = frames.width_px, .height_px = frames.height_px});
    const scene::View& start =
        scene_views.views[std::min<std::size_t>(1, scene_views.views.size() - 1)];
    Sequence sequence{.scene = std::move(scene_views.scene), .step_px = frames.step_px};
    sequence.path =
        scene::make_path(path, start, scene::bounding_sphere(sequence.scene), frames.step_px);
    sequence.path.frame_count = frames.count;
    return sequence;
}

std::vector<Sequence> study_sequences(const SequenceFrames& frames) {
    using enum scene::PathKind;
    std::vector<Sequence> sequences;
    for (const auto& [name, kind] : {std::pair("torus", orbit),
                                     {"torus", dolly},
                                     {"cube", orbit},
                                     {"cube", shake},
                                     {"figure", orbit},
                                     {"figure", pan},
                                     {"tree", orbit},
                                     {"tree", shake},
                                     {"gear", orbit},
                                     {"gear", dolly}}) {
        sequences.push_back(sequence_along(kind, name, frames));
    }
    sequences.push_back(sequence_of_motion("gear", frames));
    return sequences;
}

const harness::SideTable<MotionRow>& motion_table() {
    static const auto kTable = [] {
        harness::SideTable<MotionRow> table(
            "motion.csv",
            "A line per cell of study `motion`: how a method's lines behave on one "
            "sequence, within 2 px; the cell's view is the camera's path.");
        table.add({"frames", "", "of the sequence"}, &MotionRow::frames);
        table.add({"frames_per_s", "1/s", "at which it is shown"}, &MotionRow::frames_per_s);
        table.add({"step_px", "px", "by which the image moves a frame"}, &MotionRow::step_px);
        const auto counts = table.part_if(&MotionRow::is_ok);
        add_flicker(counts);
        add_pops(counts);
        add_false_lines(counts);
        return table;
    }();
    return kTable;
}

const harness::SideTable<MotionRow>& ink_motion_table() {
    static const auto kTable = [] {
        harness::SideTable<MotionRow> table(
            "ink_motion.csv",
            "A line per cell of motion.csv, with --coverage: how the drawn share I and the true "
            "share C of pixels change from frame to frame, where they count in both.");
        using I = score::InkChange;
        const auto ink = table.part(&MotionRow::ink);
        ink.add({"ink_true_change_px", "px^2", "sum |change of C|"}, &I::true_px);
        ink.add({"ink_beyond_px", "px^2", "sum |change of I - change of C|"}, &I::beyond_px);
        return table;
    }();
    return kTable;
}

const harness::SideTable<Life>& lives_table() {
    static const auto kTable = [] {
        harness::SideTable<Life> table(
            "lives.csv",
            "A line per cell of motion.csv and length of life that a false line of it had.");
        table.add({"frames", "frames", "that such a line lived"}, &Life::frames);
        table.add({"count", "", "of such lines"}, &Life::count);
        return table;
    }();
    return kTable;
}

std::string life_lines(std::int64_t cell, const MotionRow& of) {
    std::string lines;
    for (std::size_t i = 0; i < of.lives.size(); ++i) {
        if (of.lives[i] != 0)
            lines += lives_table().line(cell, {static_cast<int>(i + 1), of.lives[i]});
    }
    return lines;
}

std::vector<std::string> motion_faults(const std::vector<MotionRow>& rows) {
    std::vector<std::string> faults;
    for (const MotionRow& row : rows) {
        if (row.method != "oracle" || !row.is_ok()) continue;
        const bool is_perfect = row.flicker.appeared + row.flicker.disappeared == 0 &&
                                row.pops.pops == 0 && row.lives.empty();
        if (is_perfect) continue;
        faults.push_back(
            fmt::format("the truth itself has {} px of flicker, {} pops and {} false lines on {}, "
                        "path {}",
                        row.flicker.appeared + row.flicker.disappeared,
                        row.pops.pops,
                        total(row.lives),
                        row.scene,
                        row.view));
    }
    return faults;
}

}  // namespace ink::studies
