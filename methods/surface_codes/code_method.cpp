#include "methods/surface_codes/code_method.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

#include "buffers/each_tile.h"
#include "buffers/packed_sink.h"
#include "methods/surface_codes/baked_codes.h"

namespace ink::methods {
CodeOptions code_options(const CodeParams& params, const CodeSetup& setup) {
    CodeOptions options = setup;
    options.patches = {.crease_rad = glm::radians(params.crease_deg),
                       .weld_epsilon = params.weld_epsilon};
    return options;
}

CodePass::CodePass(const CodeParams& params, const CodeSetup& setup)
    : ConstantPass(buffers::constant_inputs(params),
                   buffers::constant_format(raster::Store::u8, params.depth_format, setup.halo_px),
                   0,
                   true),
      params_(params),
      setup_(setup),
      surface_codes_(code_options(params, setup)) {}

std::vector<std::uint32_t> CodePass::constants_of(const scene::PreparedScene& scene) {
    lengths_world_.clear();
    if (setup_.is_repaired) return repaired_codes(scene, params_, setup_);
    surface_codes_.prepare(scene);
    return surface_codes_.object_codes(scene, object_length_px(setup_));
}

/// Codes whose steps cover the footprint of every triangle where it is now seen.
void CodePass::follow_view(const method::Frame& /*frame*/) {
    if (setup_.is_repaired || setup_.footprint != Footprint::view || setup_.length_px == 0) return;
    const scene::Surface& surface = inputs().surface();
    const scene::Projection projection(inputs().view());
    std::vector<float> lengths(surface.triangles.size());
    for (std::size_t t = 0; t < lengths.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const glm::dvec3 center = (surface.p_world[a] + surface.p_world[b] + surface.p_world[c]);
        const double w = std::max(projection.to_clip(center / 3.0).z, inputs().view().camera.near);
        lengths[t] = static_cast<float>(setup_.length_px / projection.px_per_world(w));
    }
    if (lengths == lengths_world_) return;
    lengths_world_ = std::move(lengths);
    take(surface_codes_.codes(lengths_world_));
}

void CodeMethod::draw_tile(const raster::Tile& drawn, edge::EdgeImage& image) const {
    if (drawn.is_empty) return buffers::clear_tile(drawn, image);
    const raster::Tile tile = buffers::output_tile(drawn, image.width_px(), image.height_px());
    if (tile.width_px <= 0 || tile.height_px <= 0) return;
    const core::ImageView<std::uint8_t> out{
        image.row(tile.y0_px) + tile.x0_px, tile.width_px, tile.height_px, image.width_px()};
    const bool has_corners = samples_ == buffers::Samples::corner;
    const edge::Sides sides = has_corners ? edge::Sides::square : edge::Sides::forward;
    edge::side_differences(
        {tile.row<std::uint8_t>(0, 0), tile.width_px, tile.height_px, tile.stride},
        out,
        sides,
        gain_bits_);
    add_lines(tile, sides, out);
}

raster::SkipCounts CodeMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    buffers::EachTile sink([&](const raster::Tile& tile) { draw_tile(tile, out); });
    return pass().draw_lines(frame, sink, out);
}

std::vector<method::Layer> CodeMethod::layers(const method::Frame& frame) {
    method::Layer layer = pass().layer<std::uint8_t>(
        frame, "codes", [](std::uint8_t code) { return glm::u8vec3(code); });
    layer.codes = {core::mapped<std::uint16_t>(
        layer.rgb, [](const glm::u8vec3& color) { return std::uint16_t{color.x}; })};
    return {std::move(layer)};
}

}  // namespace ink::methods
