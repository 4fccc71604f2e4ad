#include "methods/surface_codes/code_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

#include "buffers/each_tile.h"
#include "buffers/packed_sink.h"
#include "edge/side_differences.h"

namespace ink::methods {
namespace {

/// Rows of pixels that the largest object is taken to fill where no view says how large it is.
constexpr double kNominalHeight_px = 720;

CodeOptions code_options(const CodeParams& params, const CodeSetup& setup) {
    CodeOptions options = setup;
    options.patches = {.crease_rad = glm::radians(params.crease_deg),
                       .weld_epsilon = params.weld_epsilon};
    return options;
}

/// Edge responses of a tile.
template <class Code>
void draw_differences(const raster::Tile& drawn,
                      edge::Sides sides,
                      int gain_bits,
                      edge::EdgeImage& out) {
    if (drawn.is_empty) return buffers::clear_tile(drawn, out);
    const raster::Tile tile = buffers::output_tile(drawn, out.width_px(), out.height_px());
    if (tile.width_px <= 0 || tile.height_px <= 0) return;
    edge::side_differences(
        {tile.row<Code>(0, 0), tile.width_px, tile.height_px, tile.stride},
        {out.row(tile.y0_px) + tile.x0_px, tile.width_px, tile.height_px, out.width_px()},
        sides,
        gain_bits);
}

glm::u8vec3 color_of(std::uint8_t code) {
    return glm::u8vec3(code);
}
glm::u8vec3 color_of(std::uint16_t code) {
    return {static_cast<std::uint8_t>(code & 0xff), static_cast<std::uint8_t>(code >> 8), 0};
}

/// Calls use(code) with a code of the type that holds so many bytes.
template <class Use>
auto with_code(int bytes, Use use) {
    return bytes == 1 ? use(std::uint8_t{}) : use(std::uint16_t{});
}

}  // namespace

CodePass::CodePass(const CodeParams& params, const CodeSetup& setup)
    : ConstantPass(
          buffers::constant_inputs(params),
          buffers::constant_format(
              setup.bytes == 1 ? raster::Store::u8 : raster::Store::u16, params.depth_format, 1),
          0,
          true),
      params_(params),
      setup_(setup),
      surface_codes_(code_options(params, setup)) {}

std::vector<std::uint32_t> CodePass::constants_of(const scene::PreparedScene& scene) {
    surface_codes_.prepare(scene);
    lengths_world_.clear();
    if (setup_.footprint == Footprint::object) {
        const double px_world = surface_codes_.largest_object() / kNominalHeight_px;
        if (px_world > 0 && setup_.length_px > 0) {
            lengths_world_.assign(scene::triangle_count(scene),
                                  static_cast<float>(px_world * setup_.length_px));
        }
    }
    return *scene.get(name_of_codes(), [&] { return surface_codes_.codes(lengths_world_); });
}

/// What codes of a scene depend on.
std::string CodePass::name_of_codes() const {
    return fmt::format("surface codes {} {} {} {} {} {} {} {} {} {}",
                       params_.crease_deg,
                       params_.weld_epsilon,
                       setup_.turn_rad,
                       setup_.rounds,
                       setup_.range.lowest,
                       setup_.range.highest,
                       setup_.range.least_difference,
                       setup_.range.is_second,
                       setup_.bytes,
                       lengths_world_.empty() ? 0 : lengths_world_.front());
}

/// Codes whose steps cover the footprint of every triangle where it is now seen.
void CodePass::follow_view(const method::Frame& /*frame*/) {
    if (setup_.footprint != Footprint::view || setup_.length_px == 0) return;
    const scene::Surface& surface = inputs().surface();
    const scene::Projection projection(inputs().view());
    std::vector<float> lengths(surface.triangles.size());
    for (std::size_t t = 0; t < lengths.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const glm::dvec3 center = (surface.p_world[a] + surface.p_world[b] + surface.p_world[c]);
        const double w = std::max(projection.to_clip(center / 3.0).z, inputs().view().camera.near);
        lengths[t] = static_cast<float>(w / projection.focal_px() * setup_.length_px);
    }
    if (lengths == lengths_world_) return;
    lengths_world_ = std::move(lengths);
    take(surface_codes_.codes(lengths_world_));
}

raster::SkipCounts CodeMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    const bool has_corners = samples_ == buffers::Samples::corner;
    const edge::Sides sides = has_corners ? edge::Sides::square : edge::Sides::forward;
    return with_code(setup_.bytes, [&](auto code) {
        buffers::EachTile sink([&](const raster::Tile& tile) {
            draw_differences<decltype(code)>(tile, sides, setup_.gain_bits, out);
        });
        return pass().draw_lines(frame, sink, out);
    });
}

std::vector<method::Layer> CodeMethod::layers(const method::Frame& frame) {
    method::Layer layer = with_code(setup_.bytes, [&](auto code) {
        using Code = decltype(code);
        return pass().layer<Code>(frame, "codes", [](Code each) { return color_of(each); });
    });
    layer.codes = {core::mapped<std::uint16_t>(layer.rgb, [&](const glm::u8vec3& color) {
        return static_cast<std::uint16_t>(setup_.bytes == 1 ? color.x : color.x | color.y << 8);
    })};
    return {std::move(layer)};
}

}  // namespace ink::methods
