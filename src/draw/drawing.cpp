#include "draw/drawing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/error.h"
#include "core/named.h"
#include "draw/palette.h"
#include "edge/bit_mask.h"
#include "edge/thin.h"
#include "image_io/image_file.h"
#include "methods/antialias.h"
#include "shade/compose.h"

namespace ink::draw {
namespace {

std::unique_ptr<method::Method> make_ready(const harness::SceneViews& scene_views,
                                           const method::MethodConfig& config) {
    std::unique_ptr<method::Method> method = config.info->make(config.settings);
    method->prepare(scene_views.scene);
    method->pose(scene_views.scene);
    return method;
}

edge::EdgeImage draw_method(const harness::SceneViews& scene_views,
                            const method::MethodConfig& config,
                            const scene::View& view,
                            const DrawOptions& options) {
    edge::EdgeImage edge_responses(view.width_px, view.height_px);
    make_ready(scene_views, config)->draw({view, options.threads, options.skips}, edge_responses);
    return edge_responses;
}

/// Edge responses where the lines lie once they are thinned.
edge::EdgeImage keep_thinned(edge::EdgeImage edge_responses, int threshold) {
    const edge::Mask mask = edge::thin(edge::threshold(edge_responses, threshold));
    for (std::size_t i = 0; i < edge_responses.size(); ++i) {
        if (mask.data()[i] == 0) edge_responses.data()[i] = 0;
    }
    return edge_responses;
}

/// The lines as they are to look, in samples.
edge::EdgeImage style_lines(edge::EdgeImage edge_responses,
                            int threshold,
                            const DrawOptions& options) {
    const int n = options.antialias;
    if (options.line_width_px == 0) return shade::widen(edge_responses, n);
    const auto samples = static_cast<int>(std::lround(options.line_width_px * n));
    return shade::widen(keep_thinned(std::move(edge_responses), threshold), std::max(samples, 1));
}

glm::vec3 brightness_of(const glm::u8vec3& color) {
    return glm::vec3(color) / 255.0F;
}

shade::Colors shade_colors(const DrawOptions& options, const glm::u8vec3& ink) {
    shade::Colors colors;
    if (options.paper) colors.paper = brightness_of(*options.paper);
    if (options.surface) {
        colors.surface = brightness_of(*options.surface);
    } else if (std::holds_alternative<shade::StrokeParams>(*options.shading)) {
        colors.surface = colors.paper;
    }
    colors.ink = brightness_of(ink);
    return colors;
}

/// What lies under the lines, at n x n the view's size.
RgbImage draw_under(const harness::SceneViews& scene_views,
                    const scene::View& view,
                    const DrawOptions& options) {
    if (!options.shading)
        return {view.width_px, view.height_px, options.paper.value_or(kPaper.rgb)};
    shade::Shader shader(*options.shading);
    shader.prepare(scene_views.scene);
    const shade::Colors colors = shade_colors(options, options.ink.value_or(kInk.rgb));
    return shader.draw({view, colors, options.antialias, options.threads});
}

/// The method with its lines as wide as is asked for, as far as it goes.
method::MethodConfig with_width(const method::MethodConfig& config, double line_width_px) {
    core::ParamValues settings;
    for (const core::Param& param : config.info->params) {
        if (param.name != "width_px" || line_width_px == 0) continue;
        settings[param.name] =
            core::format_param(param, std::clamp(line_width_px, param.min, param.max));
    }
    return method::with(config, settings);
}

}  // namespace

Drawing make_drawing(const harness::SceneViews& scene_views,
                     const method::MethodConfig& config,
                     const DrawOptions& options) {
    const int n = options.antialias;
    const scene::View view = methods::enlarged(scene_views.views.front(), n);
    const int threshold = method::threshold_of(config);
    const shade::Ink ink{options.ink.value_or(kInk.rgb), threshold};
    RgbImage under = draw_under(scene_views, view, options);
    Drawing drawing;
    if (options.shading) drawing.shading = shade::dither(shade::average(under, n), options.dither);
    if (config.info->draws_ink) {
        drawing.edge_responses = draw_method(scene_views,
                                             with_width(config, options.line_width_px),
                                             scene_views.views.front(),
                                             options);
        drawing.image = shade::dither(
            shade::lay_ink(drawing.edge_responses, shade::average(under, n), ink.color),
            options.dither);
        return drawing;
    }
    const edge::EdgeImage lines =
        style_lines(draw_method(scene_views, config, view, options), threshold, options);
    drawing.edge_responses = shade::average(lines, n);
    const RgbImage image = shade::compose(lines, std::move(under), ink);
    drawing.image = shade::dither(shade::average(image, n), options.dither);
    return drawing;
}

void write_drawing(const RgbImage& image, const std::filesystem::path& path) {
    image_io::write_png(image, path, {{image_io::kMixedText, "linear"}});
}

std::vector<method::Layer> draw_layers(const harness::SceneViews& scene_views,
                                       const method::MethodConfig& config,
                                       const DrawOptions& options) {
    return make_ready(scene_views, config)
        ->layers({scene_views.views.front(), options.threads, options.skips});
}

method::Layer draw_layer(const harness::SceneViews& scene_views,
                         const method::MethodConfig& config,
                         const std::string& name,
                         const DrawOptions& options) {
    std::vector<method::Layer> layers = draw_layers(scene_views, config, options);
    if (method::Layer* layer = core::find_named(layers, name)) return std::move(*layer);
    throw core::Error("--layer",
                      fmt::format("{} has no layer '{}'", config.info->name, name),
                      layers.empty() ? "a method that has layers, like mote4"
                                     : fmt::format("{}", fmt::join(core::names_of(layers), ", ")));
}

}  // namespace ink::draw
