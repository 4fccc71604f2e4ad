#pragma once

#include <optional>
#include <vector>

#include "harness/tables/side_table.h"
#include "method/method_config.h"
#include "studies/axis.h"

namespace ink::studies {

/// A crease of the rolling cube in one image.
struct RollSample {
    int crease = 0;             ///< by the number of its edge
    bool is_predicted = false;  ///< the method declares a code
    double roll_rad = 0;
    double length_px = 0;   ///< visible
    double covered_px = 0;  ///< of that, with a drawn pixel within 2 px
    double step = 0;        ///< of the code across it, as predicted; 0 without a prediction
    bool is_blind = false;  ///< predicted: the code cannot show it

    [[nodiscard]] double recall() const { return length_px > 0 ? covered_px / length_px : 0; }
};

/// An angle at which a code has no step across a crease, and where the crease was lost.
struct Vanishing {
    int crease = 0;  ///< by the number of its edge
    double predicted_rad = 0;
    /// The middle of the angles at which less than half of the crease was drawn; nothing if there
    /// are none near the prediction.
    std::optional<double> measured_rad = {};
    /// Recall in a frame at the very angle: what else than the step shows there, such as depth's
    /// kink; nothing if it was not drawn.
    std::optional<double> recall_there = {};
};

/// The cube, and the camera before it (or another scene of its size) after a roll.
[[nodiscard]] scene::Scene roll_scene();
[[nodiscard]] scene::Camera rolled_camera(const scene::Scene& scene, double roll_deg);

/// How the cube is rolled.
struct RollOptions {
    int angles = 180;   ///< over one whole turn
    int size_px = 320;  ///< of the square image
};

/// The cube roll: a cube whose three seen faces turn round the view direction, at even angles and
/// at those at which the code that a method declares has no step across a crease.
///
/// Its observer writes creases.csv and vanishing.csv. Predictions come from declared codes and the
/// cube's geometry alone (studies/roll_prediction.h).
[[nodiscard]] Axis roll_axis(const std::vector<method::MethodConfig>& configs,
                             const RollOptions& options = {});

/// Where a crease vanished near `predicted_rad`: the middle of the samples in a row, round the
/// turn, whose recall is below one half, of those rows that come within 15 degrees the nearest.
[[nodiscard]] std::optional<double> measured_vanishing(const std::vector<RollSample>& samples,
                                                       double predicted_rad);

/// creases.csv: how a cell draws a crease.
[[nodiscard]] const harness::SideTable<RollSample>& creases_table();
/// vanishing.csv: the cell is the method's at the angle.
[[nodiscard]] const harness::SideTable<Vanishing>& vanishing_table();

}  // namespace ink::studies
