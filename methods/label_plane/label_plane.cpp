#include "methods/label_plane/label_plane.h"

#include <glm/trigonometric.hpp>

#include "buffers/codes/patch_labels.h"
#include "buffers/layer_images.h"
#include "buffers/surface_values.h"
#include "scene/animation.h"

namespace ink::methods {
namespace {

buffers::CodeLayout layout(const LabelPlane::Params& params) {
    const bool is_byte = params.bits == LabelPlane::Bits::eight;
    return {.store = is_byte ? raster::Store::u8 : raster::Store::u16,
            .planes = 1,
            .fields = {{.ranges = {.depth = params.range_depth}, .bits = is_byte ? 8 : 16}}};
}

raster::PassFormat pass_format(const LabelPlane::Params& params, raster::Store store) {
    raster::PassFormat format;
    format.interpolants = 1;
    format.constant = true;
    format.store = store;
    format.overflow = raster::Overflow::wrap;
    format.interpolation = params.interpolation;
    format.depth = params.depth_format;
    format.halo_px = 1;
    return format;
}

buffers::InputParams input_params(const LabelPlane::Params& params) {
    buffers::InputParams inputs;
    inputs.depth_range = params.depth_range;
    inputs.normals = scene::NormalSource::patch;  // not read; these leave corners shared
    inputs.crease_deg = params.crease_deg;
    inputs.interpolation = params.interpolation;
    inputs.depth_format = params.depth_format;
    return inputs;
}

/// A label per triangle; those without area have label 0 and cover nothing.
std::vector<std::uint32_t> labels_of(const scene::Scene& scene, const LabelPlane::Params& params) {
    const buffers::SmoothMesh mesh = buffers::make_smooth_mesh(
        scene,
        {.crease_rad = glm::radians(params.crease_deg), .weld_epsilon = params.weld_epsilon});
    const int bits = params.bits == LabelPlane::Bits::eight ? 8 : 16;
    // Apart by the threshold and what rounding may add: |L| <= 2 on a plane.
    const std::vector<std::uint32_t> of_faces =
        buffers::patch_labels(mesh, {.bits = bits, .least_difference = params.threshold + 3});
    const std::vector<std::uint32_t> face_of = buffers::faces_of_triangles(scene, mesh.topology);
    std::vector<std::uint32_t> labels(face_of.size(), 0);
    for (std::size_t t = 0; t < labels.size(); ++t) {
        if (face_of[t] != buffers::SmoothMesh::kNone) labels[t] = of_faces[face_of[t]];
    }
    return labels;
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Labels alone.
        {{"range_depth", "0"}},
        {},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // One pixel wide instead of two: less to thin.
        {{"response", "positive"}},
        // Less of the byte to depth: fewer lines on curved surfaces, fewer contours.
        {{"range_depth", "127"}},
        {{"range_depth", "1020"}},
        {{"threshold", "8"}},
        {{"threshold", "16"}},
        // Twice the bytes: steps of depth as fine as 16 bits hold.
        {{"bits", "16"}, {"range_depth", "4080"}, {"threshold", "32"}},
        {{"bits", "16"},
         {"range_depth", "4080"},
         {"threshold", "32"},
         {"interpolation", "perspective"}},
    };
}

}  // namespace

core::ParamTable<LabelPlane::Params> LabelPlane::table() {
    core::ParamTable<Params> table;
    return table.choice(&Params::bits, "bits", {"8", "16"}, "Bits of a code.")
        .number(&Params::range_depth,
                "range_depth",
                {0, 65535},
                "code",
                "Codes that depth 0..1 spans, modulo the code's range.")
        .number(&Params::crease_deg,
                "crease_deg",
                {0, 180},
                "deg",
                "Least dihedral deviation of an edge between two smooth patches.")
        .number(&Params::weld_epsilon,
                "weld_epsilon",
                {0, 0.01},
                "",
                "Vertices of an object this near are welded for its patches, as a share of its "
                "diagonal.")
        .choice(&Params::depth_range,
                "depth_range",
                {"fit", "camera"},
                "What depth 0..1 spans: the scene's bounding sphere, or the camera's near and far.")
        .choice(&Params::interpolation,
                "interpolation",
                {"affine", "perspective"},
                "Linear on the screen, as 1998's hardware did, or on the surface.")
        .choice(&Params::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth test.")
        .choice(&Params::response,
                "response",
                {"absolute", "positive"},
                "|L|, or its positive half (one pixel wide).")
        .number(
            &Params::clip_bits, "clip_bits", {0, 7}, "bits", "Low bits of the response cleared.")
        .number(
            &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
}

LabelPlane::LabelPlane(const Params& params)
    : params_(params),
      packer_(layout(params),
              buffers::DepthSign::near_high,
              buffers::Quantise::sum,
              raster::Overflow::wrap),
      format_(pass_format(params, packer_.layout().store)),
      inputs_(input_params(params)) {}

void LabelPlane::prepare(const scene::Scene& scene) {
    inputs_.prepare(scene);
    give_labels(scene);
}

void LabelPlane::pose(const scene::Scene& scene) {
    inputs_.pose(scene);
    if (!scene.animation && scene::scene_hash(scene) != labelled_hash_) give_labels(scene);
}

void LabelPlane::give_labels(const scene::Scene& scene) {
    labelled_hash_ = scene::scene_hash(scene);
    have_labels_changed_ = true;
    if (!scene.animation) {
        labels_ = labels_of(scene, params_);
        return;
    }
    scene::Scene resting = scene;
    scene::pose_scene(resting, 0);
    labels_ = labels_of(resting, params_);
}

raster::SkipCounts LabelPlane::draw_to(const method::Frame& frame,
                                       edge::EdgeImage& out,
                                       buffers::FrameCodes* codes) {
    inputs_.see(frame);
    const method::DepthCarrier carrier(
        raster::DepthEncoding::inverse, params_.interpolation, inputs_.range());
    const buffers::PackedFilter filter{
        .wraps = true, .response = {.response = params_.response, .clip_bits = params_.clip_bits}};
    const buffers::LinearValues values({buffers::linear_code(inputs_.linear_channels(),
                                                             packer_.layout().fields.front().ranges,
                                                             buffers::DepthSign::near_high)},
                                       false);
    raster::MeshInput input = inputs_.mesh_input(frame);
    input.values = &values;
    input.constants = labels_;
    if (have_labels_changed_) input.moved_objects = std::nullopt;
    have_labels_changed_ = false;
    // |L| <= 2 inside a triangle: two clipped bits leave nothing of it.
    input.flat_gives_zero = params_.interpolation == raster::Interpolation::affine &&
                            params_.clip_bits >= 2 && codes == nullptr;
    buffers::PackedSink sink(packer_, carrier, filter, out);
    if (codes != nullptr) {
        input.may_keep_still = false;
        sink.keep_codes(*codes);
    }
    const raster::MeshResult result = pass_.draw(format_, input, sink);
    inputs_.finish(result, out);
    return result.skips;
}

void LabelPlane::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (inputs_.is_empty()) return out.fill(0);
    skip_counts_ = draw_to(frame, out, nullptr);
}

std::vector<method::Layer> LabelPlane::layers(const method::Frame& frame) {
    const int width_px = frame.view.width_px;
    const int height_px = frame.view.height_px;
    buffers::FrameCodes codes(1, {width_px, height_px, std::uint16_t{0}});
    edge::EdgeImage edge_responses(width_px, height_px);
    if (!inputs_.is_empty()) (void)draw_to(frame, edge_responses, &codes);
    return {{"packed", buffers::code_image(codes, packer_.layout())},
            {"filtered", buffers::response_image(edge_responses, params_.threshold)}};
}

method::Cost LabelPlane::cost() const {
    method::Cost cost;
    cost.passes = 1;
    cost.interpolants = 1;
    cost.values_per_vertex = 1;
    cost.buffer_bytes_per_px = format_.bytes_per_px();
    cost.fill = method::fill_work(format_);
    const double bytes = params_.bits == Bits::eight ? 1 : 2;
    // 4 m and four differences; the short way round, up and down; size, and at most 255.
    cost.filter = {bytes, 1, 5 + 2 + 1 + 1 + (params_.clip_bits > 0 ? 1.0 : 0.0)};
    return cost;
}

method::MethodInfo label_plane() {
    method::MethodInfo info = method::method_info<LabelPlane>(
        "label_plane",
        "this project; labels of smooth patches, and the plane of MOTE's depth",
        "a label of the smooth patch plus depth in one byte, 4-neighbour Laplacian");
    info.family = method::Family::packed;
    info.marker = method::Marker::right;
    info.tunables = {{"range_depth", {{0, 1020}}}, {"threshold", {{1, 64}}}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
