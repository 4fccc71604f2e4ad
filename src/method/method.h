#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/image.h"
#include "core/param.h"
#include "edge/edge_image.h"
#include "edge/laplacian.h"
#include "method/cost.h"
#include "method/depth_code.h"
#include "raster/depth/depth.h"
#include "raster/pass/pass.h"
#include "raster/skips.h"
#include "scene/prepared_scene.h"
#include "scene/scene.h"
#include "scene/surface.h"

namespace ink::method {

/// What a method works on: what its colour and its panel say on charts.
enum class Family {
    packed,           ///< depth and normal in a code of a byte or two
    full_buffers,     ///< depth and normal as floats
    ids,              ///< numbers of objects, patches or triangles
    edges_and_hulls,  ///< edges of the mesh as lines, or the mesh drawn again behind itself
    other,            ///< nobody said: a guest, or a preset that the registry does not know
};

/// All of them, in the order of legends and panels.
inline constexpr std::array kFamilies = {
    Family::packed, Family::full_buffers, Family::ids, Family::edges_and_hulls, Family::other};

/// "packed", "full_buffers", ...: as tables spell it.
[[nodiscard]] std::string_view name_of(Family family);

/// The shape that tells a method from others of its family.
enum class Marker { circle, square, diamond, up, down, plus, cross, left, right };

/// All of them, in the order in which methods of a family stand.
inline constexpr std::array kMarkers = {Marker::circle,
                                        Marker::square,
                                        Marker::diamond,
                                        Marker::up,
                                        Marker::down,
                                        Marker::plus,
                                        Marker::cross,
                                        Marker::left,
                                        Marker::right};

/// "circle", "square", ...: as tables spell it; `up`, `down`, `left` and `right` are triangles.
[[nodiscard]] std::string_view name_of(Marker marker);

/// What a method is told of one frame.
struct Frame {
    scene::View view;
    int threads = 1;             ///< 1 is plain serial; the image must not depend on it
    raster::SkipSet skips = {};  ///< what may be left undone; the image must not depend on it
};

/// What a linear code reads of the surface, and how it comes to the pixels.
struct CodeInputs {
    scene::NormalSource normals = scene::NormalSource::patch;
    double crease_rad = 0;  ///< dihedral deviation from which on an edge parts two patches
    RangeSource depth_range = RangeSource::fit;
    raster::Interpolation interpolation = raster::Interpolation::affine;
    bool at_vertices = true;  ///< summed at vertices and interpolated; else summed at pixels
    bool renormalise = false;
};

/// A method whose code is a linear sum may declare it: the cost model, the planner and the
/// cancellation study read this, nothing else.
///
/// A pixel's code is offset + depth_weight * depth + the normal's share, rounded to nearest;
/// `sky_code` where nothing is seen.
struct LinearCode {
    raster::DepthEncoding encoding = raster::DepthEncoding::inverse;
    double offset = 0;
    double depth_weight = 0;       ///< code units for depth 0..1 (near = high)
    double normal_weight[3] = {};  ///< code units for each view-space component's 0..1, (n+1)/2
    int sky_code = 0;
    int bits = 8;
    bool wraps = false;  ///< else it saturates
    CodeInputs inputs;
    edge::LaplacianResponse response;
};

/// One decision of a method that plans by the scene: what it chose, and the reason in a sentence.
struct PlanLine {
    std::string what;
    std::string why;
};

/// An image of something that a method has inside, for who wants to see why it errs.
struct Layer {
    std::string name;  ///< what `inkbench draw --layer` calls it: small letters and underscores
    core::Image<glm::u8vec3> rgb;  ///< of the view's size
    /// Of an image of codes these themselves, a plane each; else none.
    std::vector<core::Image<std::uint16_t>> codes = {};
};

/// One outline method. It sees a scene and a camera and draws edge responses; it never sees the
/// truth, the score, another method or the clock. The harness owns the clock and calls the stages
/// in this order.
///
/// A method is used by one thread at a time. Drawing the same view twice gives the same image,
/// and an empty or invisible scene gives zeros.
class Method {
  public:
    virtual ~Method() = default;

    /// Once per topology: adjacency, patches, labels, normals. What stays while an animation goes
    /// on, such as codes, is of the pose in which the scene stands here. What others make of a
    /// scene as well is asked of `scene`, which makes it once for all. The scene outlives the
    /// method's use of it; what it was prepared as does not.
    virtual void prepare(const scene::PreparedScene& scene) = 0;

    /// Whenever a vertex or an instance moved, and once after prepare: world positions and what
    /// depends on them. `scene` has the topology that was prepared.
    virtual void pose(const scene::PreparedScene& scene) = 0;

    /// Once per frame: everything it does there, its own rasterization included. `out` arrives with
    /// the view's size and any content, and leaves with an edge response in every pixel.
    virtual void draw(const Frame& frame, edge::EdgeImage& out) = 0;

    /// Images of what it has inside for this frame, the names the same for every frame: drawn
    /// anew, not timed, the same for every thread count. Empty for a method that shows nothing.
    [[nodiscard]] virtual std::vector<Layer> layers(const Frame& /*frame*/) { return {}; }

    /// Bytes a pixel of its buffers takes, depth included.
    [[nodiscard]] virtual int bytes_per_px() const = 0;

    /// What the last draw left undone; all 0 before the first, and where a method skips nothing.
    [[nodiscard]] virtual raster::SkipCounts skip_counts() const { return {}; }

    /// What a frame of it does: a function of its settings alone. One that declares nothing
    /// (passes = 0) gets no predicted time.
    [[nodiscard]] virtual Cost cost() const { return {}; }

    /// Its code, if that is one linear sum.
    [[nodiscard]] virtual std::optional<LinearCode> code() const { return std::nullopt; }

    /// What it chose for the scene that was prepared, and why; empty for methods that plan nothing.
    [[nodiscard]] virtual std::vector<PlanLine> plan() const { return {}; }
};

/// A parameter in which a method is worth tuning. The search starts at its default.
struct Tunable {
    std::string param;
    /// Low and high end: narrower than what the parameter accepts, where the rest is known to be of
    /// no use. Else all that it accepts is searched.
    std::optional<std::pair<double, double>> range = {};
};

/// Parameters whose sum has a limit: the ranges of a packed code, which must not overflow.
struct SumLimit {
    std::vector<std::string> params;
    double limit = 0;
};

/// A row of the registry: all that is known of a method before it is made. Charts, tables, tuner
/// and notebooks read this and keep no lists of their own.
struct MethodInfo {
    std::string name;     ///< = folder = TOML key = value in rows = legend
    std::string source;   ///< who described it, and where
    std::string summary;  ///< one line for `inkbench list`
    std::vector<core::Param>
        params;  ///< includes `threshold`, the edge response at which it is scored
    Family family = Family::other;   ///< its colour and panel; every registered method has one
    Marker marker = Marker::circle;  ///< its own within its family
    /// What `inkbench tune` searches unless told otherwise, in this order; none: the threshold.
    std::vector<Tunable> tunables = {};
    std::vector<SumLimit> sum_limits = {};
    /// The method whose settings this one changes; "" for a method of its own.
    std::string preset_of = "";
    /// It plans by the scene: its bytes and its code are not known without one.
    bool is_planned = false;
    /// What it draws depends on the threshold, not only what of that is scored.
    bool draws_by_threshold = false;
    /// Its edge responses are shares of pixels, of 255: ink, not strengths.
    bool draws_ink = false;
    /// Settings that span what the method can do, from its fastest to its most exact: over these
    /// its Pareto front is drawn. Eight at least; each is complete()d with the defaults.
    std::vector<core::ParamValues> sweep = {};

    /// A method with these settings, the rest at their defaults. Throws core::Error, where = name.
    std::function<std::unique_ptr<Method>(const core::ParamValues&)> make;
    /// The given settings and all defaults as text: what a row records.
    std::function<core::ParamValues(const core::ParamValues&)> complete;

    /// Bytes a pixel of its buffers takes with these settings; nothing if that is planned.
    [[nodiscard]] std::optional<int> bytes_per_px(const core::ParamValues& settings) const {
        return is_planned ? std::nullopt : std::optional(make(settings)->bytes_per_px());
    }
};

/// Makes a method from the values of its parameters that were given; errors name `where`.
using MakeMethod = std::unique_ptr<Method> (*)(const core::ParamRows& rows,
                                               const core::ParamValues& values,
                                               std::string_view where);

/// A MethodInfo of what is code of a method, whatever its class.
[[nodiscard]] MethodInfo method_info(std::string_view name,
                                     const core::ParamRows& rows,
                                     bool draws_by_threshold,
                                     MakeMethod make);

/// A MethodInfo from a class `M` with a nested `Params`, a static `table()` of its parameters, a
/// constructor from `Params`, `kDrawsByThreshold` if it draws by the threshold, and `kDrawsInk` if
/// it draws ink: what is code of a method. The rest is data: methods/<name>/<name>.toml.
template <class M>
[[nodiscard]] MethodInfo method_info(std::string_view name) {
    constexpr bool kByThreshold = requires {
        M::kDrawsByThreshold;
    };
    const MakeMethod make = [](const core::ParamRows& rows,
                               const core::ParamValues& values,
                               std::string_view where) -> std::unique_ptr<Method> {
        typename M::Params params{};
        rows.read(&params, values, where);
        return std::make_unique<M>(params);
    };
    MethodInfo info = method_info(name, M::table().rows(), kByThreshold, make);
    info.draws_ink = requires {
        M::kDrawsInk;
    };
    return info;
}

/// Appends the row `threshold`, which every method has.
template <class P>
core::ParamTable<P>& add_threshold(core::ParamTable<P>& table,
                                   const char* doc = "Least edge response of a line pixel.") {
    return table.number(&P::threshold, "threshold", {1, 255}, "", doc);
}

/// The same of a method whose edge responses are all or nothing.
template <class P>
core::ParamTable<P>& add_threshold_of_two(core::ParamTable<P>& table) {
    return add_threshold(table, "Least edge response of a line pixel; it draws only 0 and 255.");
}

}  // namespace ink::method
