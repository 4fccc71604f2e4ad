#include "buffers/codes/code_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

#include "buffers/packed_sink.h"
#include "scene/sharing/shared_work.h"

namespace ink::buffers {
namespace {

/// Rows of pixels that the largest object is taken to fill where no view says how large it is.
constexpr double kNominalHeight_px = 720;

InputParams input_params(const CodeParams& params) {
    InputParams inputs;
    inputs.normals = scene::NormalSource::patch;  // not read: they part corners at creases
    inputs.crease_deg = params.crease_deg;
    inputs.depth_format = params.depth_format;
    inputs.samples = params.samples;
    return inputs;
}

raster::PassFormat pass_format(const CodeParams& params, int bytes) {
    raster::PassFormat format;
    format.constant = true;
    format.store = bytes == 1 ? raster::Store::u8 : raster::Store::u16;
    format.depth = params.depth_format;
    format.halo_px = 1;
    return format;
}

CodeOptions code_options(const CodeParams& params, const CodeSetup& setup) {
    CodeOptions options;
    options.patches = {.crease_rad = glm::radians(params.crease_deg),
                       .weld_epsilon = params.weld_epsilon};
    options.turn_rad = setup.turn_rad;
    options.rounds = setup.rounds;
    options.range = setup.range;
    options.bytes = setup.bytes;
    return options;
}

template <class Code>
class DifferenceSink : public raster::TileSink {
  public:
    DifferenceSink(edge::Sides sides, int gain_bits, edge::EdgeImage& out)
        : sides_(sides), gain_bits_(gain_bits), out_(out) {}

    void finish(const raster::Tile& drawn) override {
        if (drawn.is_empty) return clear_tile(drawn, out_);
        const raster::Tile tile = output_tile(drawn, out_.width_px(), out_.height_px());
        if (tile.width_px == 0 || tile.height_px <= 0) return;
        edge::side_differences(
            {tile.row<Code>(0, 0), tile.width_px, tile.height_px, tile.stride},
            {out_.row(tile.y0_px) + tile.x0_px, tile.width_px, tile.height_px, out_.width_px()},
            sides_,
            gain_bits_);
    }

  private:
    edge::Sides sides_;
    int gain_bits_;
    edge::EdgeImage& out_;
};

glm::u8vec3 color_of(std::uint8_t code) {
    return glm::u8vec3(code);
}
glm::u8vec3 color_of(std::uint16_t code) {
    return {static_cast<std::uint8_t>(code & 0xff), static_cast<std::uint8_t>(code >> 8), 0};
}

template <class Code>
class ColorSink : public raster::TileSink {
  public:
    explicit ColorSink(core::Image<glm::u8vec3>& image) : image_(image) {}

    void finish(const raster::Tile& drawn) override {
        if (drawn.is_empty) return;
        const raster::Tile tile = output_tile(drawn, image_.width_px(), image_.height_px());
        for (int y = 0; y < tile.height_px; ++y) {
            const Code* const codes = tile.row<Code>(0, y);
            glm::u8vec3* const to = image_.row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x)
                to[x] = color_of(codes[x]);
        }
    }

  private:
    core::Image<glm::u8vec3>& image_;
};

}  // namespace

CodeMethod::CodeMethod(const CodeParams& params, const CodeSetup& setup)
    : params_(params),
      setup_(setup),
      format_(pass_format(params, setup.bytes)),
      inputs_(input_params(params)),
      surface_codes_(code_options(params, setup)) {}

void CodeMethod::prepare(const scene::Scene& scene) {
    inputs_.prepare(scene);
    make_codes(scene);
}

void CodeMethod::pose(const scene::Scene& scene) {
    inputs_.pose(scene);
    codes_in_clusters_.clear();
    if (!scene.animation && scene::scene_hash(scene) != coded_hash_) make_codes(scene);
}

void CodeMethod::make_codes(const scene::Scene& scene) {
    coded_hash_ = scene::scene_hash(scene);
    surface_codes_.prepare(scene);
    lengths_world_.clear();
    if (setup_.footprint == Footprint::object) {
        const double px_world = surface_codes_.largest_object() / kNominalHeight_px;
        if (px_world > 0 && setup_.length_px > 0) {
            lengths_world_.assign(scene::triangle_count(scene),
                                  static_cast<float>(px_world * setup_.length_px));
        }
    }
    const auto make = [&] { return surface_codes_.codes(lengths_world_); };
    take(scene.animation ? make() : scene::shared(scene, name_of_codes(), make));
}

/// What codes of a scene that does not move depend on.
std::string CodeMethod::name_of_codes() const {
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

void CodeMethod::take(std::vector<std::uint32_t> codes) {
    have_codes_changed_ = have_codes_changed_ || codes != codes_;
    codes_ = std::move(codes);
    codes_in_clusters_.clear();
}

/// Codes in the order in which the pass comes by its triangles.
void CodeMethod::order_codes(const raster::LaneMesh& mesh) {
    const std::vector<std::uint32_t>& ids = mesh.clusters().triangle_ids;
    if (codes_in_clusters_.size() == ids.size()) return;
    codes_in_clusters_.resize(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
        codes_in_clusters_[i] = static_cast<std::uint8_t>(codes_[ids[i]]);
}

/// Codes whose steps cover the footprint of every triangle where it is now seen.
void CodeMethod::follow_view() {
    if (setup_.footprint != Footprint::view || setup_.length_px == 0) return;
    const scene::Surface& surface = inputs_.surface();
    const scene::Projection projection(inputs_.view());
    std::vector<float> lengths(surface.triangles.size());
    for (std::size_t t = 0; t < lengths.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const glm::dvec3 center = (surface.p_world[a] + surface.p_world[b] + surface.p_world[c]);
        const double w = std::max(projection.to_clip(center / 3.0).z, inputs_.view().camera.near);
        lengths[t] = static_cast<float>(w / projection.focal_px() * setup_.length_px);
    }
    if (lengths == lengths_world_) return;
    lengths_world_ = std::move(lengths);
    take(surface_codes_.codes(lengths_world_));
}

raster::MeshResult CodeMethod::draw_to(raster::TileSink& sink,
                                       const method::Frame& frame,
                                       bool may_leave_out) {
    inputs_.see(frame);
    follow_view();
    raster::MeshInput input = inputs_.mesh_input(frame);
    input.constants = codes_;
    if (setup_.bytes == 1) {
        order_codes(*input.mesh);
        input.constants_in_clusters = codes_in_clusters_;
    }
    input.sky_code = {0};
    input.flat_gives_zero = may_leave_out;
    input.may_keep_still = input.may_keep_still && may_leave_out;
    if (have_codes_changed_ || !may_leave_out) input.moved_objects = std::nullopt;
    have_codes_changed_ = false;
    return pass_.draw(format_, input, sink);
}

void CodeMethod::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (inputs_.is_empty() || out.is_empty()) return out.fill(0);
    const edge::Sides sides =
        params_.samples == Samples::corner ? edge::Sides::square : edge::Sides::forward;
    DifferenceSink<std::uint8_t> bytes(sides, setup_.gain_bits, out);
    DifferenceSink<std::uint16_t> pairs(sides, setup_.gain_bits, out);
    raster::TileSink* const sink =
        setup_.bytes == 1 ? static_cast<raster::TileSink*>(&bytes) : &pairs;
    const raster::MeshResult result = draw_to(*sink, frame, true);
    inputs_.finish(result, out);
    skip_counts_ = result.skips;
}

std::vector<method::Layer> CodeMethod::layers(const method::Frame& frame) {
    method::Layer layer{"codes", {frame.view.width_px, frame.view.height_px}};
    if (!inputs_.is_empty()) {
        ColorSink<std::uint8_t> bytes(layer.rgb);
        ColorSink<std::uint16_t> pairs(layer.rgb);
        raster::TileSink* const sink =
            setup_.bytes == 1 ? static_cast<raster::TileSink*>(&bytes) : &pairs;
        (void)draw_to(*sink, frame, false);
        inputs_.forget_image();
    }
    return {layer};
}

method::Cost CodeMethod::cost() const {
    method::Cost cost;
    cost.passes = 1;
    cost.buffer_bytes_per_px = format_.bytes_per_px();
    cost.fill = method::fill_work(format_);
    // Each side: two differences cut at 0, of which one is nothing, joined. Then the largest.
    const double sides = params_.samples == Samples::corner ? 4 : 2;
    const double largest = 3 * sides + (sides - 1);
    if (setup_.bytes == 1) {
        cost.filter = {1, 1, largest + setup_.gain_bits};  // doubled so often
    } else {
        // Samples parted into bytes, the larger of both, shifted and cut.
        const double samples = params_.samples == Samples::corner ? 4 : 3;
        cost.filter = {2, 1, 2 * samples + 2 * largest + 1 + 2};
    }
    return cost;
}

}  // namespace ink::buffers
