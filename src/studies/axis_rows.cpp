#include "studies/axis_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <utility>

#include "buffers/each_tile.h"
#include "buffers/full_buffer_method.h"
#include "core/named.h"
#include "core/parallel.h"
#include "core/simd.h"
#include "harness/scores/evaluations.h"
#include "raster/pass/pass.h"
#include "scene/box.h"
#include "scene/surface.h"

namespace ink::studies {
namespace {

// A float's rounding, many times over: what is beyond it was not rounded but lost.
constexpr float kSlack = 1e-4F;

constexpr float kSky = -7;  // no depth is

/// Looks at the pixels of a tile of a full buffer that something was drawn to.
void check_planes(const raster::Tile& tile,
                  const method::DepthCarrier& carrier,
                  CaseFaults& faults) {
    if (tile.is_empty) return;
    buffers::TileFloats buffer;
    std::array<buffers::TileFloats, 3> normal_buffers;
    const buffers::TilePlane depth =
        encoded_depth(tile, carrier, buffers::DepthSign::near_high, kSky, buffer);
    const auto normals = buffers::view_normals(tile, false, normal_buffers);
    for (int y = 0; y < tile.height_px; ++y) {
        for (int x = 0; x < tile.width_px; ++x) {
            const float d = depth.row(y)[x];
            if (d == kSky) continue;
            const glm::vec3 n{normals[0].row(y)[x], normals[1].row(y)[x], normals[2].row(y)[x]};
            faults.non_finite += std::isfinite(d) && scene::is_finite(n) ? 0 : 1;
            faults.overflow += d < -kSlack || d > 1 + kSlack ? 1 : 0;
        }
    }
}

/// The planes of a full buffer with depth in one encoding.
CaseFaults count_planes(const scene::Scene& scene,
                        const scene::View& view,
                        raster::DepthEncoding encoding) {
    buffers::InputParams params;
    params.depth_encoding = encoding;
    buffers::FullBuffers buffers(params, 0);
    buffers.prepare(scene);
    buffers.pose(scene);
    if (buffers.is_empty()) return {};
    const method::Frame frame{view, 1, raster::SkipSet::none()};
    const method::DepthCarrier carrier = buffers.see(frame);
    CaseFaults faults;
    buffers::EachTile check([&](const raster::Tile& tile) { check_planes(tile, carrier, faults); });
    edge::EdgeImage out(view.width_px, view.height_px);
    (void)buffers.draw(frame, carrier, kSky, check, out);
    return faults;
}

/// Whether no depth and no normal can take the code beyond its bits.
bool fits_its_bits(const method::LinearCode& code) {
    double least = code.offset;
    double most = code.offset;
    for (const double weight :
         {code.depth_weight, code.normal_weight[0], code.normal_weight[1], code.normal_weight[2]}) {
        least += std::min(weight, 0.0);
        most += std::max(weight, 0.0);
    }
    return least >= -0.5 && most < std::ldexp(1, code.bits) - 0.5;
}

const scene::Scene& drawn_scene(const Case& one) {
    return one.drawn ? *one.drawn : one.scene_views.scene;
}

harness::CellOptions options_of(const Case& one, harness::CellOptions options) {
    options.trace.crosscheck = false;
    options.scores_crowded = true;
    options.scores = harness::Scores::brief;
    options.measure.threads = one.threads.value_or(options.measure.threads);
    options.measure.max_repetitions = 0;
    return options;
}

harness::TracedView trace(const Case& one, const harness::TraceOptions& options) {
    const auto& scene_views = one.scene_views;
    truth::SceneModel model(scene_views.scene, options.truth);
    return harness::trace_with_facts(model, scene_views.scene, scene_views.views.front(), options);
}

/// What the configurations draw under a case; `overflow` counts the codes of each that overflowed.
std::vector<harness::Evaluation> draw(const Case& one,
                                      const std::vector<method::MethodConfig>& configs,
                                      const harness::MeasureOptions& measure,
                                      std::vector<std::int64_t>& overflow) {
    const scene::View& view = one.scene_views.views.front();
    // As nothing is timed, all may draw at once.
    harness::ViewDrawings drawings{view, configs.size(), 1, core::hardware_threads()};
    drawings.ready = [&](std::size_t first, std::size_t end) {
        std::vector<method::MethodConfig> under;
        for (std::size_t m = first; m < end; ++m)
            under.push_back(under_case(configs[m], one));
        return std::make_shared<harness::PreparedMethods>(
            harness::prepare_methods(under, drawn_scene(one)));
    };
    drawings.see = [&](std::size_t n, harness::PreparedMethod& method, const auto& drawn) {
        if (!drawn.row.is_ok()) return;
        overflow[n] = count_overflow(method.method(),
                                     method.config(),
                                     drawn_scene(one),
                                     {view, measure.threads, measure.skips});
    };
    return harness::draw_view(drawings, measure);
}

}  // namespace

CaseFaults count_inputs(const scene::Scene& scene, const scene::View& view) {
    CaseFaults counts;
    const scene::Projection projection(view);
    const scene::Surface surface =
        scene::flatten(scene, scene::NormalSource::patch, truth::TruthOptions{}.crease_rad);
    for (const glm::dvec3& p_world : surface.p_world) {
        counts.non_finite += scene::is_finite(p_world) ? 0 : 1;
        counts.non_finite += scene::is_finite(projection.to_clip(p_world)) ? 0 : 1;
    }
    for (const glm::vec3& n : surface.n_world)
        counts.non_finite += scene::is_finite(n) ? 0 : 1;
    using enum raster::DepthEncoding;
    for (const auto encoding : {inverse, linear, log, zbuffer24, zbuffer16, reversed_float})
        counts.add(count_planes(scene, view, encoding));
    return counts;
}

std::int64_t count_non_finite(const truth::Truth& truth) {
    std::int64_t count = 0;
    for (const truth::Curve& curve : truth.curves) {
        for (const truth::CurvePoint* point : {&curve.begin, &curve.end})
            count += scene::is_finite({point->x_px, point->y_px, point->w}) ? 0 : 1;
        count += std::isfinite(curve.deviation_rad) && std::isfinite(curve.view_angle_rad) ? 0 : 1;
        count += std::isnan(curve.gap) ? 1 : 0;
    }
    return count;
}

std::int64_t count_non_finite(const harness::Row& row) {
    std::int64_t count = 0;
    const std::optional<double> soft_f = row.soft ? row.soft->f() : std::nullopt;
    for (const std::optional<double>& share :
         {row.f_2px, row.precision_2px, row.recall_2px, soft_f})
        count += share && !(*share >= 0 && *share <= 1) ? 1 : 0;
    count += row.mean_width_px && !std::isfinite(*row.mean_width_px) ? 1 : 0;
    return count;
}

std::int64_t count_overflow(method::Method& method,
                            const method::MethodConfig& config,
                            const scene::Scene& scene,
                            const method::Frame& frame) {
    const std::optional<method::LinearCode> code = method.code();
    core::ParamValues settings = config.info->complete(config.settings);
    const auto overflow = settings.find("overflow");
    if (!code || overflow == settings.end() || !fits_its_bits(*code)) return 0;
    overflow->second = overflow->second == "wrap" ? "saturate" : "wrap";
    const auto other = config.info->make(settings);
    other->prepare(scene);
    other->pose(scene);
    const std::vector<method::Layer> own_layers = method.layers(frame);
    const std::vector<method::Layer> other_layers = other->layers(frame);
    const method::Layer* a = core::find_named(own_layers, "packed");
    const method::Layer* b = core::find_named(other_layers, "packed");
    if (a == nullptr || b == nullptr) return 0;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < a->rgb.size(); ++i)
        count += a->rgb.data()[i] == b->rgb.data()[i] ? 0 : 1;
    return count;
}

std::vector<AxisRow> axis_rows(const Case& one,
                               const std::vector<method::MethodConfig>& configs,
                               const harness::CellOptions& options) {
    std::optional<core::ForcedSimdTarget> forced;
    for (const core::SimdTarget& target : core::simd_targets()) {
        if (target.name == one.simd_target) forced.emplace(target);
    }
    const scene::View& view = one.scene_views.views.front();
    const harness::CellOptions own = options_of(one, options);
    const harness::TracedView traced = trace(one, own.trace);
    std::vector<std::int64_t> overflow(configs.size() + harness::kBaselines);
    std::vector<harness::Evaluation> drawn = draw(one, configs, own.measure, overflow);
    harness::finish_evaluations(one.scene_views.scene, view, traced, own, drawn);
    CaseFaults given = count_inputs(drawn_scene(one), view);
    given.non_finite += count_non_finite(traced.truth.traced);
    std::vector<AxisRow> rows;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        harness::Row& row = drawn[i].row;
        row.axis = one.axis;
        row.value = one.value;
        row.triangles = static_cast<std::int64_t>(scene::triangle_count(drawn_scene(one)));
        harness::clear_times(row);
        CaseFaults faults = given;
        faults.non_finite += count_non_finite(row);
        faults.overflow += overflow[i];
        // A difficulty takes no line out of the image: where all are gone the case is lost. Lines
        // that a zoom has made too dense to score are there.
        faults.lost = row.is_ok() || row.status.starts_with("crowded") ? 0 : 1;
        rows.push_back({std::move(row), faults});
    }
    return rows;
}

void note_differences(const Axis& axis, std::vector<AxisRow>& rows) {
    if (!axis.same_images) return;
    std::map<std::pair<std::string, std::string>, const harness::Row*> first;  // scene and method
    for (AxisRow& of : rows) {
        if (!of.row.is_ok()) continue;
        const auto [known, is_new] = first.try_emplace({of.row.scene, of.row.method}, &of.row);
        if (known->second->image_hash == of.row.image_hash) continue;
        of.faults.differing = 1;
        of.row.status = fmt::format("differs: the image is another than at {} {}",
                                    axis.name,
                                    format_value(axis, *known->second->value));
    }
}

const harness::SideTable<AxisRow>& faults_table() {
    static const auto kTable = [] {
        harness::SideTable<AxisRow> table("stress.csv",
                                          "A line per cell of study `stress`: what went wrong; its "
                                          "place on an axis of difficulty "
                                          "and its scores are in the row.");
        using C = CaseFaults;
        const auto faults = table.part(&AxisRow::faults);
        faults.add(
            {"non_finite", "", "numbers that are NaN or infinite, of view, truth and scores"},
            &C::non_finite);
        faults.add({"overflow", "", "codes that overflowed"}, &C::overflow);
        faults.add({"lost_cell", "", "1 if the cell has no result"}, &C::lost);
        faults.add({"differing", "", "1 if the image differs where the axis allows none to"},
                   &C::differing);
        return table;
    }();
    return kTable;
}

std::vector<AxisRow> read_faults(const core::CsvTable& csv, const harness::RowIndex& rows) {
    return faults_table().read_with_rows(
        csv, rows, [](AxisRow& of, const harness::Row& row) { of.row = row; });
}

const core::TableOf<Axis>& axes_table() {
    static const auto kTable = [] {
        core::TableOf<Axis> table("axes.csv", "A line per axis of the run: what it varies.");
        table.add_derived({"axis", "", "as in rows.csv"}, &Axis::name);
        table.add_derived({"title", "", "what its values are"}, &Axis::title);
        table.add_derived({"unit", "", "of its values; empty for a pure number"}, &Axis::unit);
        table.add_derived({"is_log", "", "true: values lie on a logarithmic scale"},
                          [](const Axis& axis) { return axis.scale == AxisScale::log; });
        table.add_derived({"sentence", "", "what is varied, and what stays"}, &Axis::sentence);
        table.add_derived(
            {"value_names", "", "of named values 1, 2, 3 and so on, a;b;c; empty for numbers"},
            [](const Axis& axis) { return fmt::format("{}", fmt::join(axis.value_names, ";")); });
        return table;
    }();
    return kTable;
}

}  // namespace ink::studies
