#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/provenance.h"
#include "harness/cells/frame_counts.h"
#include "harness/scores/bins.h"
#include "raster/skips.h"
#include "scene/crease.h"
#include "scene/precision/weld_tolerance.h"
#include "score/attribution.h"
#include "score/intersections.h"
#include "score/score.h"
#include "score/soft_score.h"

namespace ink::harness {

/// One cell of an experiment: one method, with its settings, on one view; one row of rows.csv.
///
/// Empty optionals are written as empty fields, never as 0 or NaN.
struct Row {
    Row();
    Row(const Row&);
    Row(Row&&) noexcept;
    Row& operator=(const Row&);
    Row& operator=(Row&&) noexcept;
    ~Row();  // all of them compiled once: they are long, and many copy rows

    std::int64_t cell = 0;  ///< its number in rows.csv, as read back
    int setting = 0;        ///< of a line of sweep.csv its number within the cell, from 1; else 0
    std::string axis = {};  ///< of a study: what grows; "" where nothing does
    std::optional<double> value = {};  ///< where on the axis; of named values the number
    std::string method;
    std::string scene;
    std::string view;
    std::string projection;  ///< perspective | parallel
    std::string split;       ///< train | heldout | real
    std::string scene_kind;  ///< of thing that the scene is; "" where nobody said
    int width = 0;
    int height = 0;
    int threads = 1;
    std::uint64_t seed = 0;
    std::string params;                 ///< "key=value;key=value", every parameter
    std::optional<int> threshold = {};  ///< edge response from which a pixel counts as drawn
    std::string status = "ok";          ///< or what went wrong; the metrics below are then empty
    std::optional<double> f_2px;
    std::optional<double> f_1px;
    std::optional<double> precision_2px;
    std::optional<double> recall_2px;
    /// Which intersections all counts here go by, but for the next two.
    score::Intersections intersections = score::Intersections::above_crease;
    std::optional<score::CurveCount> above_crease_2px = {};       ///< at 2 px, if flat ones do not
    std::optional<score::CurveCount> all_intersections_2px = {};  ///< count, and if they do
    /// At 2 px, if crowded pixels count too (harness/truths/unscored_view.h): also where the view
    /// is `crowded`.
    std::optional<score::CurveCount> with_crowded_2px = {};
    /// What was found of each recall group (core/vocabulary.h), groups present only. As many count
    /// as drawn as are true, so that F of these counts, 2 k / (n + n), is the recall.
    std::map<std::string, score::CurveCount> by_class = {};
    std::optional<score::SoftScore> soft = {};  ///< of grey lines; nothing unless asked for
    std::optional<double> mean_width_px;
    std::optional<double> ap;
    std::int64_t k_2px = 0;  ///< counts at 2 px, so that values can be pooled
    std::int64_t n_pred = 0;
    std::int64_t n_truth = 0;
    std::int64_t unmatched_duplicates = 0;
    std::int64_t false_positives = 0;
    std::int64_t unmatched_truth = 0;
    std::int64_t false_negatives = 0;
    /// What false_positives and false_negatives are made of; nothing where nobody asked why.
    std::optional<score::CauseCounts> causes = {};
    std::optional<std::int64_t> k_1px;  ///< counts at 1 px; n_truth is the same
    std::optional<std::int64_t> n_pred_1px;
    /// Counts at each of kTolerances_px (harness/cells/cell.h): lines of tolerances.csv, not
    /// columns here. Empty where they were not asked for.
    std::vector<score::CurveCount> tolerance_sweep = {};
    /// Counts at 2 px of a random image of n_pred pixels (score/drawing.h); nothing where
    /// it was not asked for.
    std::optional<score::CurveCount> random_baseline = {};
    std::optional<std::int64_t> prepare_ns;
    std::optional<std::int64_t> pose_ns;
    std::optional<std::int64_t> draw_ns;  ///< lower quartile over repetitions: the one that ranks
    std::optional<std::int64_t> draw_ns_median;
    std::optional<std::int64_t> draw_ns_q75;  ///< upper quartile
    std::optional<std::int64_t> draw_ns_min;
    int draw_n = 0;                            ///< repetitions
    std::optional<std::int64_t> draw_wall_ns;  ///< lower quartiles: on the wall,
    std::optional<std::int64_t> draw_cpu_ns;   ///< and of the processor
    std::optional<std::int64_t> yardstick_ns;  ///< of the fixed work beside it (yardstick.h)
    std::string time_doubt;  ///< why the times are uncertain: waited, spread; "" if they are not
    std::string clock;       ///< that the times are by (timing.h); "" where nothing was timed
    std::optional<int> bytes_per_px;
    std::optional<CostFacts> cost = {};  ///< what its time is predicted from
    /// What the last timed drawing left undone; nothing for baselines and cells that failed.
    std::optional<raster::SkipCounts> skips = {};
    std::string skips_off = {};  ///< skips that were not allowed, "a;b"
    std::string image_hash;
    std::int64_t truth_px = 0;
    std::int64_t truth_merged_px = 0;
    double crowded_share = 0;
    double rounding_px = 0;  ///< that coordinates' rounding may move a vertex in the frame by
    std::int64_t triangles = 0;
    std::vector<BinCount> bins = {};                           ///< at 2 px: lines of bins.csv
    double crease_deg = 40;                                    ///< of the truth
    scene::CreaseSource creases = scene::CreaseSource::angle;  ///< of the truth
    double weld_epsilon = 0;                 ///< of the truth, share of each part's diagonal
    std::optional<double> contour_sky_px;    ///< visible length of contours before the sky,
    std::optional<double> contour_other_px;  ///< before another object,
    std::optional<double> contour_self_px;   ///< and before their own
    /// Truth and cross-check: share of their lines that only one of them has, confirmed.
    std::optional<double> reference_disagreement = std::nullopt;
    double crosscheck_px = 0;         ///< the length of line, both ways, of which that is a share
    double crosscheck_abstained = 0;  ///< the share of it on which the cross-check abstains
    /// Of that, by class: on another line that both have; classes with some only.
    std::map<std::string, double> coincident_px_by_class = {};
    /// The program and machine that the row comes from; null: these.
    std::shared_ptr<const core::Provenance> provenance = {};

    [[nodiscard]] bool is_ok() const { return status == "ok"; }
    /// Whether it is from outside: its times are no drawing's here.
    [[nodiscard]] bool has_own_clock() const { return clock == "own" || clock == "children"; }
    /// Whether rounding of coordinates moves something in the view so far that it can be seen.
    [[nodiscard]] bool shows_rounding() const { return rounding_px > scene::kUnseen_px; }
    /// Whether its counts at 2 px say something: it came out, and was scored.
    [[nodiscard]] bool is_scored() const { return is_ok() && f_2px.has_value(); }
};

/// Empties what a score says, but for `with_crowded_2px`: of a row whose view has none.
void clear_scores(Row& row);

/// Copies what a score says: an equal image at an equal threshold scores the same.
void copy_scores(const Row& from, Row& to);

/// Empties what holds times or follows from them: two runs of one plan then have the same rows.
void clear_times(Row& row);

/// Where a row's image was taken: scene, view, width and height in pixels.
using Place = std::tuple<std::string, std::string, int, int>;
[[nodiscard]] Place place_of(const Row& row);

/// The program and machine that a row comes from.
[[nodiscard]] const core::Provenance& provenance_of(const Row& row);

/// The row of the truth itself. It is scored against each choice of what counts by the truth of
/// that choice, so that it is 1 in every column that is an F.
inline constexpr std::string_view kOracle = "oracle";

/// Whether `method` is one of the rows that the harness makes itself: none, sampled, exact_corner,
/// oracle.
[[nodiscard]] bool is_baseline(std::string_view method);

}  // namespace ink::harness
