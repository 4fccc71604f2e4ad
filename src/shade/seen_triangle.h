#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "shade/shading.h"

namespace ink::shade {

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
        const glm::dvec3 opposite_a = glm::cross(job.p_clip[b], job.p_clip[c]);
        const double det = glm::dot(job.p_clip[a], opposite_a);
        const std::size_t side =
            det > 0 ? 1 : 0;  // y points down, z away: fronts turn the negative way
        const double sign = det > 0 ? 1 : -1;
        rows_ = {sign * opposite_a,
                 sign * glm::cross(job.p_clip[c], job.p_clip[a]),
                 sign * glm::cross(job.p_clip[a], job.p_clip[b])};
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
    std::array<glm::dvec3, 3> rows_;
    const Tone* uniform_ = nullptr;
    std::array<const Tone*, 3> tones_{};
};

}  // namespace ink::shade
