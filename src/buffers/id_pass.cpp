#include "buffers/id_pass.h"

#include <glm/trigonometric.hpp>
#include <utility>

#include "core/hash.h"

namespace ink::buffers {
namespace {

/// Normals are not read; those of patches leave corners shared.
InputParams input_params(const IdParams& params) {
    InputParams inputs;
    inputs.normals = scene::NormalSource::patch;
    inputs.crease_deg = params.crease_deg;
    inputs.depth_format = params.depth_format;
    inputs.samples = params.samples;
    return inputs;
}

raster::PassFormat pass_format(const IdParams& params, int halo_px) {
    raster::PassFormat format;
    format.constant = true;
    format.store = raster::Store::u32;
    format.depth = params.depth_format;
    format.halo_px = halo_px;
    return format;
}

/// Each byte 64..255, so that every colour stands out from the sky.
glm::u8vec3 color_of(std::uint32_t id) {
    const std::uint64_t bits = core::Hasher().value(id).result();
    glm::u8vec3 color;
    for (int i = 0; i < 3; ++i)
        color[i] = static_cast<std::uint8_t>(64 + (bits >> (8 * i + 32) & 0xff) * 191 / 255);
    return color;
}

class ColorSink : public raster::TileSink {
  public:
    explicit ColorSink(core::Image<glm::u8vec3>& image) : image_(image) {}

    void finish(const raster::Tile& drawn) override {
        if (drawn.is_empty) return;
        const raster::Tile tile = output_tile(drawn, image_.width_px(), image_.height_px());
        for (int y = 0; y < tile.height_px; ++y) {
            const std::uint32_t* const ids = tile.row<std::uint32_t>(0, y);
            glm::u8vec3* const to = image_.row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x) {
                if (ids[x] != kNoId) to[x] = color_of(ids[x]);
            }
        }
    }

  private:
    core::Image<glm::u8vec3>& image_;
};

}  // namespace

IdPass::IdPass(const IdParams& params, int halo_px)
    : params_(params), format_(pass_format(params, halo_px)), inputs_(input_params(params)) {}

std::vector<std::uint32_t> IdPass::ids_of(const scene::Scene& scene) const {
    return surface_ids(
        scene,
        params_.of,
        {.crease_rad = glm::radians(params_.crease_deg), .weld_epsilon = params_.weld_epsilon});
}

void IdPass::prepare(const scene::Scene& scene) {
    inputs_.prepare(scene);
    ids_ = ids_of(scene);
    posed_hash_ = scene::scene_hash(scene);
    have_ids_changed_ = true;
}

bool IdPass::prepare_like(const IdPass& other, const scene::Scene& scene) {
    if (!inputs_.prepare_like(other.inputs_)) return false;
    const bool has_same_ids = params_.of == other.params_.of &&
                              params_.crease_deg == other.params_.crease_deg &&
                              params_.weld_epsilon == other.params_.weld_epsilon;
    ids_ = has_same_ids ? other.ids_ : ids_of(scene);
    posed_hash_ = scene::scene_hash(scene);
    have_ids_changed_ = true;
    return true;
}

void IdPass::pose(const scene::Scene& scene) {
    inputs_.pose(scene);
    const bool bends_count =
        params_.of == IdSource::patch || params_.of == IdSource::object_and_patch;
    const std::uint64_t hash = scene::scene_hash(scene);
    if (!bends_count || hash == posed_hash_) return;
    posed_hash_ = hash;
    std::vector<std::uint32_t> ids = ids_of(scene);
    have_ids_changed_ = have_ids_changed_ || ids != ids_;
    ids_ = std::move(ids);
}

raster::MeshResult IdPass::draw(const method::Frame& frame,
                                bool may_keep_still,
                                raster::TileSink& sink) {
    inputs_.see(frame);
    raster::MeshInput input = inputs_.mesh_input(frame);
    input.constants = ids_;
    input.sky_code = {kNoId};
    input.may_keep_still = input.may_keep_still && may_keep_still;
    if (have_ids_changed_ || !may_keep_still) input.moved_objects = std::nullopt;
    have_ids_changed_ = false;
    return pass_.draw(format_, input, sink);
}

raster::SkipCounts IdPass::draw_lines(const method::Frame& frame,
                                      raster::TileSink& sink,
                                      edge::EdgeImage& out) {
    const raster::MeshResult result = draw(frame, true, sink);
    finish(result, out);
    return result.skips;
}

method::Layer IdPass::layer(const method::Frame& frame) {
    method::Layer layer{"ids", {frame.view.width_px, frame.view.height_px}};
    if (is_empty()) return layer;
    ColorSink sink(layer.rgb);
    (void)draw(frame, false, sink);
    inputs_.forget_image();
    return layer;
}

method::Cost IdPass::cost() const {
    method::Cost cost;
    cost.passes = 1;
    cost.buffer_bytes_per_px = format_.bytes_per_px();
    cost.fill = method::fill_work(format_);
    return cost;
}

}  // namespace ink::buffers
