#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "harness/cells/view_cells.h"
#include "harness/rows/row.h"
#include "harness/rows/side_tables.h"
#include "method/method_config.h"
#include "scene/scene.h"
#include "scene/views/camera_path.h"
#include "score/motion.h"

namespace ink::studies {

/// How one method's lines behave on one sequence: a row whose view is the camera's path and whose
/// hash is of all its images, and a line of motion.csv.
struct MotionRow : harness::Row {
    int frames = 0;
    double frames_per_s = 60;
    double step_px = 0;  ///< by which the image moves a frame
    score::Flicker flicker = {};
    score::PopCount pops = {};
    std::vector<std::int64_t> lives = {};      ///< of false lines: entry i lived i + 1 frames
    std::int64_t lives_cut = 0;                ///< of them those that may live longer than was seen
    std::optional<score::InkChange> ink = {};  ///< nothing unless grey lines are scored
};

/// A sentence for each sequence on which the truth itself flickers, pops or has false lines: a run
/// with one is invalid.
[[nodiscard]] std::vector<std::string> motion_faults(const std::vector<MotionRow>& rows);

/// The columns of motion.csv: cell, the sequence, then flicker, pops and false lines.
/// Scores are empty if it failed.
[[nodiscard]] const harness::SideTable<MotionRow>& motion_table();

/// The columns of ink_motion.csv, where grey lines are scored: cell, how their ink changes.
[[nodiscard]] const harness::SideTable<MotionRow>& ink_motion_table();

/// How many false lines of a cell lived so long.
struct Life {
    int frames = 0;
    std::int64_t count = 0;
};

/// The columns of lives.csv: cell, frames, count.
[[nodiscard]] const harness::SideTable<Life>& lives_table();

/// A line per length of life that a false line of the cell had, each ended; "" without any.
[[nodiscard]] std::string life_lines(std::int64_t cell, const MotionRow& of);

/// By how much the image of a sequence moves a frame, unless asked otherwise: lines pass slowly
/// over the pixel grid.
inline constexpr double kStep_px = 0.25;

/// A scene and how its camera moves, and perhaps the scene itself.
struct Sequence {
    scene::Scene scene;
    scene::CameraPath path = {};
    double step_px = 0;  ///< what the path was made from, for the rows
    /// Brings the scene, whose topology stays, to a time; empty where it stands still.
    std::function<void(scene::Scene&, double time_s)> pose = {};
};

/// Draws every frame of a sequence with every configuration and scores them against their truths
/// and each other (score/motion.h), 2 px, the band and the ignored pixels as everywhere: a row per
/// configuration, then the baselines `sampled`, `exact_corner` and `oracle`. Where the options have
/// a width of true lines, their ink too; the soft score is of all frames. Nothing is timed, and no
/// truth is held against the cross-check.
///
/// A method that throws in a frame is a row that says so. A frame whose truth is too large ends the
/// sequence: every row says so. On Ctrl-C there are no rows.
[[nodiscard]] std::vector<MotionRow> study_sequence(
    const std::vector<method::MethodConfig>& configs,
    Sequence& sequence,
    const harness::CellOptions& options);

/// What sequences have in common.
struct SequenceFrames {
    int width_px = 0;
    int height_px = 0;
    int count = 0;
    double step_px = kStep_px;
};

/// The sequences of the study: paths before scenes of the catalogue; last the gears, which turn as
/// slowly before a camera that stands still.
[[nodiscard]] std::vector<Sequence> study_sequences(const SequenceFrames& frames);

/// A scene, of the catalogue or a model file, from its second view on along a path.
[[nodiscard]] Sequence sequence_along(scene::PathKind path,
                                      const std::string& scene,
                                      const SequenceFrames& frames);

}  // namespace ink::studies
