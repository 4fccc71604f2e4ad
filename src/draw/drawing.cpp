#include "draw/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <utility>

#include "core/error.h"
#include "draw/palette.h"
#include "edge/thin.h"
#include "shade/compose.h"
#include "shade/widen.h"

namespace ink::draw {
namespace {

constexpr double kHandWidth_px = 2;  // unless a width is asked for

int threshold_of(const harness::Entrant& entrant) {
    return std::stoi(entrant.info->complete(entrant.settings).at("threshold"));
}

/// The subject's first view, n x n its size.
scene::View enlarged_view(const harness::Subject& subject, int n) {
    scene::View view = subject.views.front();
    const std::int64_t width = std::int64_t{view.width_px} * n;
    const std::int64_t height = std::int64_t{view.height_px} * n;
    if (width > 16384 || height > 16384 || width * height > (std::int64_t{1} << 27)) {
        throw core::Error(
            "--antialias",
            fmt::format("{} times {}x{} is too large", n, view.width_px, view.height_px),
            "at most 16384 a side and 2^27 pixels in all");
    }
    view.width_px = static_cast<int>(width);
    view.height_px = static_cast<int>(height);
    return view;
}

std::unique_ptr<method::Method> make_ready(const harness::Subject& subject,
                                           const harness::Entrant& entrant) {
    std::unique_ptr<method::Method> method = entrant.info->make(entrant.settings);
    method->prepare(subject.scene);
    method->pose(subject.scene);
    return method;
}

edge::EdgeImage draw_method(const harness::Subject& subject,
                            const harness::Entrant& entrant,
                            const scene::View& view,
                            const DrawOptions& options) {
    edge::EdgeImage strengths(view.width_px, view.height_px);
    make_ready(subject, entrant)->draw({view, options.threads, options.skips}, strengths);
    return strengths;
}

/// One pixel wide where strengths reach the threshold.
edge::Mask thin_lines(const edge::EdgeImage& strengths, int threshold) {
    edge::Mask mask(strengths.width_px(), strengths.height_px());
    std::transform(strengths.data(), strengths.data() + strengths.size(), mask.data(), [&](int s) {
        return static_cast<std::uint8_t>(s >= threshold ? 1 : 0);
    });
    return edge::thin(mask);
}

/// Strengths where the lines lie once they are thinned.
edge::EdgeImage keep_thinned(edge::EdgeImage strengths, int threshold) {
    const edge::Mask mask = thin_lines(strengths, threshold);
    for (std::size_t i = 0; i < strengths.size(); ++i) {
        if (mask.data()[i] == 0) strengths.data()[i] = 0;
    }
    return strengths;
}

/// The lines as they are to look, in samples.
edge::EdgeImage style_lines(edge::EdgeImage strengths, int threshold, const DrawOptions& options) {
    const int n = options.antialias;
    const bool has_width = options.line_width_px > 0;
    if (options.hand) {
        const shade::HandPen pen{
            n, has_width ? options.line_width_px : kHandWidth_px, options.seed};
        return shade::draw_by_hand(thin_lines(strengths, threshold), *options.hand, pen);
    }
    if (!has_width) return shade::widen(strengths, n);
    const auto samples = static_cast<int>(std::lround(options.line_width_px * n));
    return shade::widen(keep_thinned(std::move(strengths), threshold), std::max(samples, 1));
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

}  // namespace

Drawing make_drawing(const harness::Subject& subject,
                     const harness::Entrant& entrant,
                     const DrawOptions& options) {
    const int n = options.antialias;
    const scene::View view = enlarged_view(subject, n);
    const int threshold = threshold_of(entrant);
    const shade::Ink ink{options.ink.value_or(kInk.rgb), threshold};
    const edge::EdgeImage lines =
        style_lines(draw_method(subject, entrant, view, options), threshold, options);

    Drawing drawing;
    drawing.strengths = shade::average(lines, n);
    RgbImage under(view.width_px, view.height_px, options.paper.value_or(kPaper.rgb));
    if (options.shading) {
        shade::Shader shader(*options.shading);
        shader.prepare(subject.scene);
        under = shader.draw({view, shade_colors(options, ink.color), n, options.threads});
        drawing.shading = shade::dither(shade::average(under, n), options.dither);
    }
    const RgbImage picture = shade::compose(lines, std::move(under), ink);
    drawing.picture = shade::dither(shade::average(picture, n), options.dither);
    return drawing;
}

std::vector<method::Layer> draw_layers(const harness::Subject& subject,
                                       const harness::Entrant& entrant,
                                       const DrawOptions& options) {
    return make_ready(subject, entrant)
        ->layers({subject.views.front(), options.threads, options.skips});
}

method::Layer draw_layer(const harness::Subject& subject,
                         const harness::Entrant& entrant,
                         const std::string& name,
                         const DrawOptions& options) {
    std::string known;
    for (method::Layer& layer : draw_layers(subject, entrant, options)) {
        if (layer.name == name) return std::move(layer);
        known += (known.empty() ? "" : ", ") + layer.name;
    }
    throw core::Error("--layer",
                      fmt::format("{} has no layer '{}'", entrant.info->name, name),
                      known.empty() ? "a method that has layers, like mote4" : known);
}

}  // namespace ink::draw
