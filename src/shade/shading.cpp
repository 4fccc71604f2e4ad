#include "shade/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <numeric>
#include <optional>

#include "raster/pass/pass.h"
#include "scene/camera.h"
#include "shade/tones.h"

namespace ink::shade {
namespace {

// Styles made ready for pixels: the types that the loop over pixels is compiled with. Each gives
// the colour of a tone at a point of the view, in its pixels.
template <class Params>
class Paint;

/// Surface times light.
template <>
class Paint<GouraudParams> {
  public:
    Paint(const GouraudParams&, const ShadeFrame& frame) : surface_(frame.colors.surface) {}
    [[nodiscard]] glm::vec3 color(const Tone& tone, double, double) const {
        return surface_ * tone.light;
    }

  private:
    glm::vec3 surface_;
};

/// Surface times an entry of the table.
template <>
class Paint<ToonParams> {
  public:
    Paint(const ToonParams& params, const ShadeFrame& frame)
        : surface_(frame.colors.surface), table_(make_toon_table(params.steps, params.dark)) {}
    [[nodiscard]] glm::vec3 color(const Tone& tone, double, double) const {
        return surface_ * look_up(table_, brightness(tone.light));
    }

  private:
    glm::vec3 surface_;
    ToonTable table_;
};

/// Cool to warm.
template <>
class Paint<GoochParams> {
  public:
    Paint(const GoochParams& params, const ShadeFrame& frame)
        : params_(params), surface_(frame.colors.surface) {}
    [[nodiscard]] glm::vec3 color(const Tone& tone, double, double) const {
        return gooch(tone.cosine, params_, surface_);
    }

  private:
    GoochParams params_;
    glm::vec3 surface_;
};

/// Ink on strokes, surface between them.
template <>
class Paint<StrokeParams> {
  public:
    Paint(const StrokeParams& params, const ShadeFrame& frame)
        : params_(params), colors_(frame.colors), px_(1.0 / frame.samples_per_px) {}
    [[nodiscard]] glm::vec3 color(const Tone& tone, double x, double y) const {
        const StrokeShares shares = stroke_shares(1 - brightness(tone.light), params_);
        const bool is_ink = is_on_stroke(x * px_, y * px_, shares, params_.spacing_px);
        return is_ink ? colors_.ink : colors_.surface;
    }

  private:
    StrokeParams params_;
    Colors colors_;
    double px_;
};

/// What all tiles of an image read; borrowed.
struct PaintJob {
    const scene::Surface& surface;
    const UniformSpots& spots;
    const SurfaceTones& tones;
    const std::vector<glm::dvec3>& p_clip;
    const ShadeFrame& frame;
};

/// A triangle as its pixels see it.
///
/// Shares of the corners are perspective-correct without any division by w: each is the determinant
/// of the pixel's ray with the other two corners in clip space (Olano and Greer, "Triangle scan
/// conversion using 2D homogeneous coordinates", 1997), so that corners behind the eye do no harm.
class SeenTriangle {
  public:
    SeenTriangle(const PaintJob& job, std::uint32_t index) {
        const auto& [a, b, c] = job.surface.triangles[index];
        const glm::dvec3 p_a = corner(job, a), p_b = corner(job, b), p_c = corner(job, c);
        const glm::dvec3 opposite_a = glm::cross(p_b, p_c);
        const double det = glm::dot(p_a, opposite_a);
        const std::size_t side =
            det > 0 ? 1 : 0;  // y points down, z away: fronts turn the negative way
        const double sign = det > 0 ? 1 : -1;
        rows_ = {sign * opposite_a, sign * glm::cross(p_c, p_a), sign * glm::cross(p_a, p_b)};
        const std::uint32_t spot = job.spots.of.empty() ? UniformSpots::kNone : job.spots.of[index];
        if (spot != UniformSpots::kNone) {
            uniform_ = &job.tones.spots[side][spot];
            return;
        }
        const std::vector<Tone>& tones = job.tones.vertices[side];
        tones_ = {&tones[a], &tones[b], &tones[c]};
    }

    /// The tone at a point of the image; one just outside takes that of the border.
    [[nodiscard]] Tone at(double x_px, double y_px) const {
        if (uniform_ != nullptr) return *uniform_;
        double shares[3];
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3& row = rows_[i];
            shares[i] = std::max(0.0, row.x * x_px + row.y * y_px + row.z);
            sum += shares[i];
        }
        Tone tone;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto share = static_cast<float>(sum > 0 ? shares[i] / sum : 1.0 / 3);
            tone.light += share * tones_[i]->light;
            tone.cosine += share * tones_[i]->cosine;
        }
        return tone;
    }

  private:
    /// By coordinates that are linear along lines of the world.
    static glm::dvec3 corner(const PaintJob& job, std::uint32_t index) {
        const glm::dvec3& p_clip = job.p_clip[index];
        return job.frame.view.camera.is_parallel() ? p_clip / p_clip.z : p_clip;
    }

    std::array<glm::dvec3, 3> rows_;
    const Tone* uniform_ = nullptr;
    std::array<const Tone*, 3> tones_{};
};

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
    raster::PassFormat format{.constant = true, .store = raster::Store::u32};
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

ToonTable make_toon_table(int steps, double dark) {
    ToonTable table{};
    for (std::size_t i = 0; i < kToonEntries; ++i) {
        const int level = static_cast<int>(i) * steps / static_cast<int>(kToonEntries);
        const double share = steps > 1 ? static_cast<double>(level) / (steps - 1) : 1;
        table[i] = static_cast<float>(dark + (1 - dark) * share);
    }
    return table;
}

float look_up(const ToonTable& table, float brightness) {
    const auto entry = static_cast<std::size_t>(std::max(brightness, 0.0F) * kToonEntries);
    return table[std::min(entry, kToonEntries - 1)];
}

glm::vec3 gooch(float cosine, const GoochParams& params, const glm::vec3& surface) {
    const glm::vec3 cool = glm::vec3(0, 0, static_cast<float>(params.blue)) +
                           static_cast<float>(params.cool_share) * surface;
    const auto yellow = static_cast<float>(params.yellow);
    const glm::vec3 warm =
        glm::vec3(yellow, yellow, 0) + static_cast<float>(params.warm_share) * surface;
    const float lit = (1 + cosine) / 2;
    return params.lit == LitSide::cool ? lit * cool + (1 - lit) * warm
                                       : lit * warm + (1 - lit) * cool;
}

float splashback(float cosine, double alpha, int power) {
    const auto a = static_cast<float>(alpha);
    const float base = a * std::min(std::abs(cosine), 1.0F) + (1 - a);
    float result = 1;
    for (int i = 0; i < power; ++i)
        result *= base;
    return result;
}

StrokeShares stroke_shares(float darkness, const StrokeParams& params) {
    constexpr float kThinnest = 0.15F;
    constexpr float kWidest = 0.5F;
    const auto share = [&](double from, double to) {
        if (darkness < from) return 0.0F;
        const double way = to > from ? std::min((darkness - from) / (to - from), 1.0) : 1;
        return kThinnest + (kWidest - kThinnest) * static_cast<float>(way);
    };
    return {share(params.single_from, params.crossed_from), share(params.crossed_from, 1)};
}

bool is_on_stroke(double x_px, double y_px, const StrokeShares& shares, double spacing_px) {
    const auto hits = [&](double along_px, float share) {
        const double turns = along_px / (std::numbers::sqrt2 * spacing_px);
        return turns - std::floor(turns) < share;
    };
    return hits(x_px + y_px, shares.single) || hits(x_px - y_px, shares.crossed);
}

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

core::Image<Rgb> Shader::draw(const ShadeFrame& frame) const {
    const scene::View& view = frame.view;
    core::Image<Rgb> image(view.width_px, view.height_px);
    const auto lamps = lamps_.empty() ? studio_lamps(view.camera, bounds_) : lamps_;
    const glm::vec3 ambient(static_cast<float>(tone_params(style_).ambient));
    const SurfaceTones tones = make_tones(surface_, spots_, lamps, ambient);
    const auto p_clip = project(surface_, view);
    const PaintJob job{surface_, spots_, tones, p_clip, frame};
    std::visit(
        [&]<class Params>(const Params& params) {
            PaintSink sink(job, Paint<Params>(params, frame), params, image);
            draw_tiles(job, sink);
        },
        style_);
    return image;
}

}  // namespace ink::shade
