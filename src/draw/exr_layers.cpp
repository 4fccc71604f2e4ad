#include "draw/exr_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/provenance.h"
#include "core/srgb.h"
#include "draw/error_image.h"
#include "harness/cells/cell.h"
#include "harness/truths/tracing.h"
#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "score/coverage.h"
#include "truth/cracks.h"

namespace ink::draw {
namespace {

using image_io::ExrAttribute;
using image_io::ExrChannel;
using image_io::ExrFile;
using image_io::HalfImage;

/// As light, which OpenEXR holds; `layer` is "" for the image itself, else a name with its dot.
void add_colours(const RgbImage& image, const std::string& layer, ExrFile& file) {
    std::array<float, 256> light{};
    for (std::size_t v = 0; v < light.size(); ++v)
        light[v] = static_cast<float>(core::light_of(static_cast<double>(v) / 255));
    constexpr std::array<const char*, 3> kNames = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
        const auto channel = [&](const glm::u8vec3& rgb) { return light[rgb[c]]; };
        file.channels.push_back({layer + kNames[static_cast<std::size_t>(c)],
                                 HalfImage{core::mapped<float>(image, channel)}});
    }
}

core::Image<std::uint32_t> whole_numbers(const core::Image<std::uint8_t>& image) {
    return core::mapped<std::uint32_t>(image, [](std::uint8_t v) { return v; });
}

HalfImage shares(const edge::EdgeImage& image) {
    return {core::mapped<float>(image, [](std::uint8_t v) { return static_cast<float>(v) / 255; })};
}

/// Rows of the matrix for row vectors: p * matrix is p in view space, which looks along -z.
std::array<float, 16> world_to_camera(const scene::Camera& camera) {
    std::array<float, 16> matrix{};
    const glm::dvec3 moved = camera.view_from_world * -camera.eye_world;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            matrix[static_cast<std::size_t>(4 * i + j)] =
                static_cast<float>(camera.view_from_world[i][j]);
        matrix[static_cast<std::size_t>(12 + i)] = static_cast<float>(moved[i]);
    }
    matrix[15] = 1;
    return matrix;
}

void append(const std::vector<ExrAttribute>& more, std::vector<ExrAttribute>& attributes) {
    attributes.insert(attributes.end(), more.begin(), more.end());
}

/// What is drawn.
std::vector<ExrAttribute> place(const harness::SceneViews& scene_views) {
    const scene::Camera& camera = scene_views.views.front().camera;
    const glm::dvec3& eye = camera.eye_world;
    return {{"ink:scene", scene_views.scene.name},
            {"ink:view", camera.name},
            {"ink:eye_world", fmt::format("{} {} {}", eye.x, eye.y, eye.z)},
            camera.is_parallel()
                ? image_io::ExrAttribute{"ink:height_world", camera.height_world}
                : image_io::ExrAttribute{"ink:fov_y_deg", glm::degrees(camera.fov_y_rad)},
            {"ink:near", camera.near}};
}

/// The same, and by what.
std::vector<ExrAttribute> origin(const harness::SceneViews& scene_views) {
    const core::Provenance& p = core::provenance();
    std::vector<ExrAttribute> attributes = {
        {"Software", fmt::format("inkbench {}", p.version)},
        {"worldtocamera", world_to_camera(scene_views.views.front().camera)},
        {"ink:commit", fmt::format("{}{}", p.commit, p.dirty ? "+" : "")}};
    append(place(scene_views), attributes);
    return attributes;
}

/// What a score is to know of a truth.
std::vector<ExrAttribute> facts_of_truth(const TruthOrigin& origin) {
    std::vector<ExrAttribute> attributes = {
        {"ink:crease_deg", glm::degrees(origin.options.crease_rad)},
        {"ink:creases",
         std::string(
             scene::kCreaseSourceNames.at(static_cast<std::size_t>(origin.options.creases)))},
        {"ink:weld_epsilon", origin.options.weld_epsilon},
        {"ink:labels", "0 none 1 contour 2 boundary 3 crease 4 intersection 5 seam 7 ignore"},
        {"ink:ignore_label", static_cast<double>(truth::LineClass::ignore)},
        {"ink:band_px", static_cast<double>(harness::kBand_px)}};
    if (!origin.command.empty()) attributes.push_back({"ink:command", origin.command});
    return attributes;
}

}  // namespace

void write_truth_exr(const TruthOrigin& truth_origin,
                     const truth::Truth& truth,
                     const std::filesystem::path& path) {
    ExrFile file;
    add_colours(truth_image(truth.labels), "", file);
    if (!truth.layers.w.is_empty()) {
        file.channels.push_back({"Z", truth.layers.w});
        file.channels.push_back({"id.triangle", truth.layers.triangle});
        file.channels.push_back({"id.patch", truth.layers.patch});
        file.channels.push_back({"facing.Y", truth.layers.n_dot_v});
        file.channels.push_back({"sampled.Y", shares(truth.sampled)});
        file.channels.push_back({"exact_corner.Y", shares(truth.exact_corner)});
    }
    file.channels.push_back({"class.label", whole_numbers(truth.labels)});
    file.channels.push_back({"class.below_crease", whole_numbers(truth.below_crease)});
    const truth::Cracks cracks =
        truth::draw_cracks(truth.curves, truth.labels.width_px(), truth.labels.height_px());
    file.channels.push_back({"crack.right", whole_numbers(cracks.right)});
    file.channels.push_back({"crack.below", whole_numbers(cracks.below)});
    file.channels.push_back({kCoverageChannel,
                             score::draw_coverage(truth.curves,
                                                  truth.labels.width_px(),
                                                  truth.labels.height_px(),
                                                  score::kLineWidth_px)});
    file.attributes = origin(truth_origin.scene_views);
    file.attributes.push_back({kLineWidthAttribute, score::kLineWidth_px});
    append(facts_of_truth(truth_origin), file.attributes);
    image_io::write_exr(file, path);
}

void write_truth_png(const TruthOrigin& truth_origin,
                     const harness::ViewTruth& truth,
                     const std::filesystem::path& path) {
    const core::Image<std::uint8_t> labels = truth.counted_labels();
    std::vector<ExrAttribute> attributes = place(truth_origin.scene_views);
    append(facts_of_truth(truth_origin), attributes);
    image_io::Texts texts;
    for (const ExrAttribute& attribute : attributes) {
        const auto* number = std::get_if<double>(&attribute.value);
        texts[attribute.name] =
            number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(attribute.value);
    }
    if (truth.intersections == score::Intersections::all) {
        const auto& below = truth.traced.below_crease;
        const auto flat = std::count_if(
            below.data(), below.data() + below.size(), [](int value) { return value != 0; });
        texts["ink:below_crease_px"] = fmt::format("{}", flat);
    }
    image_io::write_png(labels, path, texts);
}

void write_drawing_exr(const harness::SceneViews& scene_views,
                       const method::MethodConfig& config,
                       const Drawing& drawing,
                       const std::vector<method::Layer>& layers,
                       const std::filesystem::path& path) {
    ExrFile file;
    add_colours(drawing.image, "", file);
    if (!drawing.shading.is_empty()) add_colours(drawing.shading, "shading.", file);
    file.channels.push_back({"response.Y", shares(drawing.edge_responses)});
    file.attributes = origin(scene_views);
    for (const method::Layer& layer : layers)
        add_colours(layer.rgb, layer.name + ".", file);
    file.attributes.push_back({image_io::kMixedText, std::string("linear")});
    file.attributes.push_back({"ink:method", config.info->name});
    file.attributes.push_back(
        {"ink:params", harness::join_params(config.info->complete(config.settings))});
    image_io::write_exr(file, path);
}

}  // namespace ink::draw
