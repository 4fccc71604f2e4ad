#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/param.h"
#include "harness/method_configs.h"
#include "harness/suite.h"
#include "scene/scene.h"

namespace ink::studies {

/// One image of a stress axis: a scene from one view, drawn and scored like any other.
///
/// Its row is named by `scene_views`: the scene by what is drawn, the same along an axis, so that a
/// scene is one cluster of the interval; the view by axis and value, `<axis>=<value>`, so that no
/// two cases of a run share scene and view.
struct StressCase {
    std::string axis;
    double value = 0;
    harness::SceneViews scene_views;  ///< a scene and one view; the truth is of this
    /// What methods are given instead of the scene, where the axis is what numbers lose
    /// on their way to a renderer. Nothing: the scene itself.
    std::optional<scene::Scene> drawn = {};
    /// "key=value" or "method.key=value", for every method that has the parameter; others keep
    /// theirs.
    std::vector<std::string> settings = {};
    /// Times every `range_*` parameter of a packed code, and its threshold (as far as parameters
    /// reach).
    double code_gain = 1;
    /// Bits that a packed code is given instead of all of its own: ranges shrink by whole powers of
    /// two, and what the filter finds is scaled up by as many bits.
    std::optional<int> code_bits = {};
    std::optional<int> threads = {};  ///< of the methods, instead of the measure's
    std::string simd_target = {};     ///< of the kernels, by name; "" is the machine's best
};

/// `config` with the settings of a case; parameters that it does not have are passed over.
[[nodiscard]] harness::MethodConfig under_stress(const harness::MethodConfig& config,
                                                 const StressCase& stress);

/// How the values of an axis lie on a chart.
enum class AxisScale {
    linear,
    log,
    named,  ///< values are 1, 2, 3 ... and have names
};

/// The size of stress images.
struct StressSize {
    int width_px = 480;
    int height_px = 270;
};

/// One difficulty, and how it grows (section 9 of the design).
struct StressAxis {
    std::string name;   ///< what `--axes` and stress.csv call it
    std::string title;  ///< what its values are, for people
    std::string unit;   ///< "" for a pure number
    AxisScale scale = AxisScale::log;
    std::vector<double> values;                 ///< ascending, distinct; eight at least
    std::vector<std::string> value_names = {};  ///< one per value if the scale is `named`
    std::string sentence;                       ///< what is varied, and what stays
    /// Nothing that an image shows may depend on the value: images that differ are faults.
    bool same_images = false;
    /// The cases of a value; any value between the least and the greatest will do, of named axes
    /// only those listed. The same case on every machine.
    std::function<std::vector<StressCase>(double value, const StressSize& size)> cases;
};

/// All axes in the order of the design; names are unique.
[[nodiscard]] const std::vector<StressAxis>& stress_axes();

/// The axis called `name`. Throws core::Error that lists the known ones.
[[nodiscard]] const StressAxis& find_stress_axis(const std::string& name);

/// At most `count` (two at least) of an axis' values, evenly taken, first and last among them.
[[nodiscard]] std::vector<double> stress_values(const StressAxis& axis, int count);

}  // namespace ink::studies
