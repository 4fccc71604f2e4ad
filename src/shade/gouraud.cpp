#include "shade/gouraud.h"

#include <array>
#include <vector>

#include "scene/camera.h"
#include "shade/lamps.h"

namespace ink::shade {
namespace {

constexpr std::size_t kChannels = 4;  // red, green, blue, and one that stays 0: the set has no 3

/// The light that every vertex sends to the eye from one of its sides.
std::vector<float> light_vertices(const scene::Surface& surface,
                                  double side,
                                  std::span<const scene::OmniLight> lamps,
                                  const GouraudOptions& options) {
    std::vector<float> values(surface.p_world.size() * kChannels);
    for (std::size_t i = 0; i < surface.p_world.size(); ++i) {
        const glm::dvec3 n_world = side * glm::dvec3(surface.n_world[i]);
        const glm::vec3 color =
            options.surface * light_at(surface.p_world[i], n_world, lamps, options.ambient);
        for (int c = 0; c < 3; ++c)
            values[i * kChannels + static_cast<std::size_t>(c)] = color[c];
    }
    return values;
}

class PictureSink : public raster::TileSink {
  public:
    explicit PictureSink(core::Image<glm::vec3>& picture) : picture_(picture) {}

    void finish(const raster::Tile& tile) override {
        for (int y = 0; y < tile.height_px; ++y) {
            glm::vec3* to = picture_.row(tile.y0_px + y) + tile.x0_px;
            const float* red = tile.row<float>(0, y);
            const float* green = tile.row<float>(1, y);
            const float* blue = tile.row<float>(2, y);
            for (int x = 0; x < tile.width_px; ++x)
                to[x] = {red[x], green[x], blue[x]};
        }
    }

  private:
    core::Image<glm::vec3>& picture_;
};

std::vector<glm::dvec3> project(const scene::Surface& surface, const scene::View& view) {
    const scene::Projection projection(view);
    std::vector<glm::dvec3> p_clip;
    p_clip.reserve(surface.p_world.size());
    for (const glm::dvec3& p_world : surface.p_world)
        p_clip.push_back(projection.to_clip(p_world));
    return p_clip;
}

}  // namespace

core::Image<glm::vec3> draw_gouraud(const scene::Scene& scene,
                                    const scene::View& view,
                                    const GouraudOptions& options) {
    core::Image<glm::vec3> picture(view.width_px, view.height_px);
    const scene::Surface surface = scene::flatten(scene, options.normals, options.crease_rad);
    const std::vector<scene::OmniLight> lamps =
        scene.lights.empty() ? studio_lamps(view.camera, scene::bounding_sphere(scene))
                             : scene.lights;
    const auto p_clip = project(surface, view);
    const auto front = light_vertices(surface, 1, lamps, options);
    const auto back = light_vertices(surface, -1, lamps, options);
    const auto facing = scene::facings(surface, view.camera.eye_world);

    raster::PassFormat format;
    format.interpolants = kChannels;
    format.store = raster::Store::f32;
    format.interpolation = options.interpolation;
    raster::PassInput input;
    input.p_clip = p_clip;
    input.triangles = surface.triangles;
    input.values = front;
    input.values_back = back;
    input.facing = facing;
    input.near = view.camera.near;
    input.far = view.camera.far;
    input.sky_f32 = {options.paper.r, options.paper.g, options.paper.b, 0};
    PictureSink sink(picture);
    raster::draw_pass(format, input, view.width_px, view.height_px, options.threads, sink);
    return picture;
}

}  // namespace ink::shade
