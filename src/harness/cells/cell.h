#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edge/edge_image.h"
#include "harness/clock/timing.h"
#include "harness/rows/row.h"
#include "harness/truths/tracing.h"
#include "method/method_config.h"
#include "raster/skips.h"
#include "score/attribution.h"
#include "score/drawing.h"
#include "score/score.h"

namespace ink::harness {

/// What is allowed where one view is drawn again and again to be timed: all skips but
/// `temporal_reuse`. With it, every drawing but the first would cost next to nothing, which is no
/// method's time for that view.
[[nodiscard]] raster::SkipSet skips_of_repeated_drawings();

/// `allowed` without the skips of these names; "all" is every one. Throws core::Error
/// (where = "--no-skip") that lists the names if one is unknown.
[[nodiscard]] raster::SkipSet without_skips(raster::SkipSet allowed,
                                            const std::vector<std::string>& names);

/// The skips that `allowed` forbids: names joined by ';' in the order of the table, "" if none.
[[nodiscard]] std::string forbidden_skips(const raster::SkipSet& allowed);

/// How often and with what a method is timed.
struct MeasureOptions {
    int threads = 1;          ///< of the method
    int min_repetitions = 9;  ///< whatever they take
    int max_repetitions = 60;
    double budget_s = 0.02;  ///< a method on a view stops repeating after this much drawing
    /// It stops before, after its least repetitions, when its median lies by no more than this
    /// share above its least time; 0: never.
    double precision = 0.05;
    raster::SkipSet skips = skips_of_repeated_drawings();
    const core::WorkClock* clock = &core::machine_clock();
};

/// The tolerances at which every cell is scored, for the tolerance sweep: how near the lines lie.
inline constexpr std::array<double, 5> kTolerances_px = {
    kStrictTolerance_px, 1.5, kTolerance_px, 3, 4};

/// What is scored: an image, at a threshold, against a prepared truth.
struct Scored {
    score::Strokes strokes;  ///< what of it was scored at its threshold
    score::PixelList drawn;  ///< what of them counts at 2 px
    score::Score at_2px;
    std::vector<score::CurveCount> tolerance_sweep;  ///< at each of kTolerances_px, 1 px first
    std::array<score::CurveCount, 99> curve{};
    score::WrongPixels
        wrong_2px;  ///< the pixels behind at_2px's false_positives and false_negatives
    score::Attribution attribution;  ///< why: empty until MissPredictor fills it
};

/// How `image` is scored: band, ignored pixels and `threshold`, at kTolerance_px.
[[nodiscard]] score::ScoreOptions score_options(int threshold);

/// Scores `image` at `threshold` with all tolerances and the whole curve at 2 px, against
/// list_tolerances() of the truth.
[[nodiscard]] Scored score_image(const edge::EdgeImage& image,
                                 std::span<const score::TruthLists> lists,
                                 int threshold);

/// Writes the metrics of `scored` into `row`.
void fill_scores(const Scored& scored, Row& row);

/// Writes only those of a score at 2 px.
void fill_score_2px(const score::Score& at_2px, Row& row);

/// Writes into `row` what a method that did not fail left undone, and what it was not allowed to.
void fill_skips(const DrawTimes& times, const raster::SkipSet& allowed, Row& row);

/// One method made ready for one scene: prepared, posed, both timed.
class PreparedMethod {
  public:
    /// Makes, prepares and poses. What `scene` has already made counts as long as it took to make,
    /// as often as the method asks for it. A method that throws is not prepared: see `failure`.
    PreparedMethod(const method::MethodConfig& config, const scene::PreparedScene& scene);

    [[nodiscard]] const method::MethodConfig& config() const { return config_; }
    [[nodiscard]] const std::string& failure() const { return failure_; }
    [[nodiscard]] method::Method& method() { return *method_; }
    [[nodiscard]] int threshold() const { return threshold_; }
    /// A row with everything that is known before a view is drawn.
    [[nodiscard]] Row row() const;

  private:
    method::MethodConfig config_;
    std::unique_ptr<method::Method> method_;
    std::string failure_;
    core::ParamValues settings_;
    int threshold_ = 128;
    std::int64_t prepare_ns_ = 0;
    std::int64_t pose_ns_ = 0;
};

using PreparedMethods = std::vector<std::unique_ptr<PreparedMethod>>;

/// All made ready for one scene.
[[nodiscard]] PreparedMethods prepare_methods(std::span<const method::MethodConfig> configs,
                                              const scene::PreparedScene& scene);

/// Triangles times methods that are ready together: a method prepares 600 bytes a triangle in the
/// mean, and twice 1 GB beside the truths of large scenes keep a comparison of all methods below 4
/// on two cores.
inline constexpr std::size_t kTrianglesAtOnce = 1'500'000;

/// How many methods may be ready for a scene at a time. At least 1.
[[nodiscard]] std::size_t most_at_once(const scene::Scene& scene,
                                       std::size_t triangles_at_once = kTrianglesAtOnce);

/// Draws a view turn by turn (A B C, B C A, ...), so that a machine that slows down slows all
/// alike, and none always follows the same one; the first round warms up, gives the images and is
/// not counted. Between the turns a fixed piece of work is timed (Yardstick).
///
/// `images[i]` and the result's [i] are of method i. A method that throws, or whose images
/// differ between rounds, gets a failure and is left out of later rounds; the others go on. A
/// method from outside draws once, and its time is its own (OutsideMethod).
[[nodiscard]] std::vector<DrawTimes> draw_in_turns(const PreparedMethods& methods,
                                                   const scene::View& view,
                                                   const MeasureOptions& options,
                                                   std::vector<edge::EdgeImage>& images);

/// "key=value;key=value" in the order of names.
[[nodiscard]] std::string join_params(const core::ParamValues& values);

}  // namespace ink::harness
