#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/cell.h"
#include "harness/method_configs.h"
#include "scene/camera_path.h"
#include "scene/scene.h"

namespace ink::studies {

/// A crease of the rolling cube in one frame.
struct RollSample {
    double roll_rad = 0;
    double length_px = 0;   ///< visible
    double covered_px = 0;  ///< of that, with a drawn pixel within 2 px
    double step = 0;        ///< of the code across it, as predicted; 0 without a prediction
    bool is_blind = false;  ///< predicted: the code cannot show it

    [[nodiscard]] double recall() const { return length_px > 0 ? covered_px / length_px : 0; }
};

/// An angle at which a code has no step across a crease, and where the crease was lost.
struct Vanishing {
    double predicted_rad = 0;
    /// The middle of the angles at which less than half of the crease was drawn; nothing if there
    /// are none near the prediction.
    std::optional<double> measured_rad = {};
    /// Recall in a frame at the very angle: what else than the step shows there, such as depth's
    /// kink; nothing if it was not drawn.
    std::optional<double> recall_there = {};
};

/// How one method draws one crease of the cube while the camera rolls once round.
struct RollCurve {
    std::string method;
    std::string params;
    std::string status = "ok";              ///< or why there are no samples
    int crease = 0;                         ///< 0, 1, 2: by the number of its edge
    bool is_predicted = false;              ///< the method declares a code
    std::vector<RollSample> samples = {};   ///< by angle, evenly over a whole turn
    std::vector<Vanishing> vanishing = {};  ///< none without a prediction

    /// The least recall over the turn, and the mean; 1 where there are no samples.
    [[nodiscard]] double least_recall() const;
    [[nodiscard]] double mean_recall() const;
};

/// The cube roll: a cube whose three seen faces turn round the view direction.
struct RollOptions {
    harness::MeasureOptions measure = {};
    std::filesystem::path cache = {};  ///< of truths; empty: none
    int frame_count = 180;             ///< over one whole turn
    int size_px = 320;                 ///< of the square image
};

/// The scene of the roll and its path.
[[nodiscard]] scene::Scene roll_scene();
[[nodiscard]] scene::CameraPath roll_path(const scene::Scene& scene, const RollOptions& options);

/// Draws the roll with every configuration: a curve per method and crease. A method that fails has
/// one, without samples, that says why. Predictions come from declared codes and the cube's
/// geometry alone (linear_code/roll_prediction.h). On Ctrl-C there are no curves.
[[nodiscard]] std::vector<RollCurve> study_roll(const std::vector<harness::MethodConfig>& configs,
                                                const RollOptions& options);

/// Where a crease vanished near `predicted_rad`: the middle of the samples in a row, round the
/// turn, whose recall is below one half, of those rows that come within 15 degrees the nearest.
[[nodiscard]] std::optional<double> measured_vanishing(const std::vector<RollSample>& samples,
                                                       double predicted_rad);

}  // namespace ink::studies
