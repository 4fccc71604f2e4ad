#pragma once

#include <functional>
#include <vector>

#include "harness/cells/view_cells.h"
#include "method/method_config.h"
#include "scene/scene.h"
#include "scene/views/camera_path.h"
#include "studies/motion_table.h"

namespace ink::studies {

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
/// configuration, then the baselines `sampled`, `exact_corner` and `oracle`. Nothing is timed, and
/// no truth is held against the cross-check.
///
/// A method that throws in a frame is a row that says so. A frame whose truth is too large ends the
/// sequence: every row says so. On Ctrl-C there are no rows.
[[nodiscard]] std::vector<MotionRow> study_sequence(
    const std::vector<method::MethodConfig>& configs,
    Sequence& sequence,
    const harness::CellOptions& options);

/// The sequences of the study: scenes of the catalogue, `frame_count` frames, each path a quarter
/// of a pixel a frame, so that lines pass slowly over the pixel grid; last the gears, which turn as
/// slowly before a camera that stands still.
[[nodiscard]] std::vector<Sequence> study_sequences(int width_px, int height_px, int frame_count);

}  // namespace ink::studies
