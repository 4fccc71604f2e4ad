#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/param.h"
#include "harness/cells/view_cells.h"
#include "harness/suite/suite.h"
#include "method/method_config.h"
#include "scene/scene.h"

namespace ink::studies {

/// What a study draws: one image of an axis, by every method.
///
/// Its rows are named by `scene_views`: the scene by what is drawn, the same along an axis, so that
/// a scene is one cluster of the interval; the view by axis and value, `<axis>=<value>`, so that no
/// two cases of a run share scene and view.
struct Case {
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
[[nodiscard]] method::MethodConfig under_case(const method::MethodConfig& config, const Case& one);

/// How the values of an axis lie on a chart.
enum class AxisScale {
    linear,
    log,
    named,  ///< values are 1, 2, 3 ... and have names
};

/// The size of images whose study leaves it open.
struct CaseSize {
    int width_px = 480;
    int height_px = 270;
};

/// What must not happen, however hard a case is.
struct CaseFaults {
    /// Numbers that are NaN or infinite: placed and projected vertices, normals, the planes of a
    /// full buffer in every depth encoding, the truth's curves, the declared code, the scores.
    std::int64_t non_finite = 0;
    /// Codes beyond what they may hold: depths outside 0..1, and pixels at which a packed
    /// code whose ranges fit its bits comes out otherwise if it may wrap.
    std::int64_t overflow = 0;
    std::int64_t lost = 0;       ///< 1 if the cell has no result
    std::int64_t differing = 0;  ///< 1 if the image differs where the axis allows none to

    [[nodiscard]] bool is_clean() const {
        return non_finite == 0 && overflow == 0 && lost == 0 && differing == 0;
    }
    void add(const CaseFaults& more);
};

/// One thing that grows, and what is drawn as it does: a study is some of these, and nothing else.
/// The engine draws every case with every method, traces, scores, compares and writes rows.
struct Axis {
    std::string name;   ///< the column `axis` of its rows
    std::string title;  ///< what its values are, for people
    std::string unit;   ///< "" for a pure number
    AxisScale scale = AxisScale::log;
    std::vector<double> values;                 ///< ascending, distinct
    std::vector<std::string> value_names = {};  ///< one per value if the scale is `named`
    std::string sentence;                       ///< what is varied, and what stays
    /// Nothing that an image shows may depend on the value: images that differ are faults. All of
    /// its values are then looked at together.
    bool same_images = false;
    /// The cases of a value; any value between the least and the greatest will do, of named axes
    /// only those listed. The same case on every machine.
    std::function<std::vector<Case>(double value, const CaseSize& size)> cases;
};

/// At most `count` (two at least) of an axis' values, evenly taken, first and last among them.
[[nodiscard]] std::vector<double> axis_values(const Axis& axis, int count);

/// A value of an axis as people read it: "1e-07", "20 deg", "zbuffer16 z16".
[[nodiscard]] std::string format_value(const Axis& axis, double value);

/// All axes of difficulty in the order of the design; names are unique, and each has eight values
/// at least.
[[nodiscard]] const std::vector<Axis>& stress_axes();

/// The axis called `name`. Throws core::Error that lists the known ones.
[[nodiscard]] const Axis& find_stress_axis(const std::string& name);

}  // namespace ink::studies
