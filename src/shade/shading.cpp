#include "shade/shading.h"

#include <glm/trigonometric.hpp>
#include <numeric>
#include <optional>

#include "core/error.h"
#include "raster/pass/pass.h"
#include "scene/camera.h"
#include "shade/flat_patches.h"
#include "shade/lamps.h"
#include "shade/paints.h"
#include "shade/seen_triangle.h"

namespace ink::shade {
namespace {

constexpr std::uint32_t kNoTriangle = 0xffffffffU;

/// Colours the pixels of each tile, once it is known which triangles they see.
template <class Paint>
class PaintSink : public raster::TileSink {
  public:
    PaintSink(const PaintJob& job,
              const Paint& paint,
              const ToneParams& params,
              core::Image<Rgb>& image)
        : job_(job),
          paint_(paint),
          alpha_(params.splash_alpha),
          power_(params.splash_power),
          paper_(to_8_bit(job.frame.colors.paper)),
          image_(image) {}

    void finish(const raster::Tile& tile) override {
        std::uint32_t last = kNoTriangle;
        std::optional<SeenTriangle> triangle;
        for (int y = 0; y < tile.height_px; ++y) {
            Rgb* to = image_.row(tile.y0_px + y) + tile.x0_px;
            const std::uint32_t* ids = tile.row<std::uint32_t>(0, y);
            for (int x = 0; x < tile.width_px; ++x) {
                if (ids[x] == kNoTriangle) {
                    to[x] = paper_;
                    continue;
                }
                if (ids[x] != last) triangle.emplace(job_, last = ids[x]);
                to[x] = paint(*triangle, tile.x0_px + x + 0.5, tile.y0_px + y + 0.5);
            }
        }
    }

  private:
    [[nodiscard]] Rgb paint(const SeenTriangle& triangle, double x_px, double y_px) const {
        const Tone tone = triangle.at(x_px, y_px);
        const glm::vec3 color = paint_.color(tone, x_px, y_px);
        return to_8_bit(color * splashback(tone.cosine, alpha_, power_));
    }

    const PaintJob& job_;
    Paint paint_;
    double alpha_;
    int power_;
    Rgb paper_;
    core::Image<Rgb>& image_;
};

/// Draws which triangle each pixel sees, by the plain pass: it has a constant per triangle, and one
/// picture is done before clusters would be made.
void draw_tiles(const PaintJob& job, raster::TileSink& sink) {
    raster::PassFormat format;
    format.store = raster::Store::u32;
    format.constant = true;
    std::vector<std::uint32_t> ids(job.surface.triangles.size());
    std::iota(ids.begin(), ids.end(), 0U);
    raster::PassInput input;
    input.p_clip = job.p_clip;
    input.triangles = job.surface.triangles;
    input.constants = ids;
    const scene::View& view = job.frame.view;
    input.near = view.camera.near;
    input.far = view.camera.far;
    input.sky_code = {kNoTriangle};
    raster::draw_pass(format, input, view.width_px, view.height_px, job.frame.threads, sink);
}

std::vector<glm::dvec3> project(const scene::Surface& surface, const scene::View& view) {
    const scene::Projection projection(view);
    std::vector<glm::dvec3> p_clip;
    p_clip.reserve(surface.p_world.size());
    for (const glm::dvec3& p_world : surface.p_world)
        p_clip.push_back(projection.to_clip(p_world));
    return p_clip;
}

const ToneParams& tone_params(const Style& style) {
    return std::visit([](const auto& params) -> const ToneParams& { return params; }, style);
}

}  // namespace

void Shader::prepare(const scene::Scene& scene) {
    const ToneParams& params = tone_params(style_);
    const double crease_rad = glm::radians(params.crease_deg);
    surface_ = scene::flatten(scene, params.normals, crease_rad);
    spots_ = params.by == ShadeBy::face    ? face_spots(surface_)
             : params.by == ShadeBy::patch ? patch_spots(scene, crease_rad)
                                           : UniformSpots{};
    bounds_ = scene::bounding_sphere(scene);
    lamps_ = scene.lights;
}

std::vector<scene::OmniLight> Shader::lamps_of(const ShadeFrame& frame) const {
    const bool has_own = !lamps_.empty() && frame.lamps != LampSource::studio;
    if (has_own) return lamps_;
    if (frame.lamps == LampSource::own) {
        throw core::Error("--lights", "the scene has no light of its own", "studio");
    }
    return studio_lamps(frame.view.camera, bounds_);
}

core::Image<Rgb> Shader::draw(const ShadeFrame& frame) const {
    const scene::View& view = frame.view;
    core::Image<Rgb> image(view.width_px, view.height_px);
    const auto lamps = lamps_of(frame);
    const glm::vec3 ambient(static_cast<float>(tone_params(style_).ambient));
    const SurfaceTones tones = make_tones(surface_, spots_, lamps, ambient);
    const auto p_clip = project(surface_, view);
    const PaintJob job{surface_, spots_, tones, p_clip, frame};
    std::visit(
        [&](const auto& params) {
            PaintSink sink(job, paint_of(params, frame), params, image);
            draw_tiles(job, sink);
        },
        style_);
    return image;
}

}  // namespace ink::shade
