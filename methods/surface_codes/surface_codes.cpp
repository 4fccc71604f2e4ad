#include "methods/surface_codes/surface_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <string>
#include <utility>

#include "methods/surface_codes/patch_labels.h"
#include "methods/surface_codes/surface_distance.h"
#include "scene/precision/weld_tolerance.h"

namespace ink::methods {
namespace {

/// Rows of pixels that the largest object is taken to fill where no view says how large it is.
constexpr double kNominalHeight_px = 720;

/// What is lost of a patch's borders at each phase.
class Losses {
  public:
    Losses(const Fold& fold, int least_difference)
        : fold_(fold),
          reach_(least_difference - 1),
          lost_(static_cast<std::size_t>(fold.period())) {}

    void start() { std::fill(lost_.begin(), lost_.end(), 0.0); }
    /// A distance that must not come near a code.
    void add(std::int32_t distance, std::int32_t code, double length) {
        for (int d = -reach_; d <= reach_; ++d) {
            fold_.for_each_phase(distance, code + d, [&](std::int32_t phase) {
                lost_[static_cast<std::size_t>(phase)] += length;
            });
        }
    }
    /// Two distances of one patch that must not be folded onto each other: at no end between them.
    void add_fold(std::int32_t distance0, std::int32_t distance1, double length) {
        const std::int32_t middle = (distance0 + distance1) / (2 * kStep);
        for (int d = -reach_; d <= reach_; ++d) {
            lost_[static_cast<std::size_t>(fold_.wrapped(d - middle))] += length;
            lost_[static_cast<std::size_t>(fold_.wrapped(d - middle + fold_.period() / 2))] +=
                length;
        }
    }
    /// The phase that loses least, the first of equals from `start` on.
    [[nodiscard]] std::int32_t best_from(std::int32_t start, std::int32_t stride) const {
        std::int32_t best = start;
        for (std::int32_t i = 0; i < fold_.period(); i += stride) {
            const std::int32_t phase = fold_.wrapped(start + i);
            if (lost_[static_cast<std::size_t>(phase)] < lost_[static_cast<std::size_t>(best)])
                best = phase;
        }
        return best;
    }

  private:
    const Fold& fold_;
    int reach_;
    std::vector<double> lost_;
};

/// Per face its distance and the phase of its patch, a whole number of steps, in units of kStep.
///
/// Codes, to and fro between the ends of the range, so change within a patch by no more steps than
/// its distances. Phases are found patch by patch, the largest area first, so that as little as
/// possible of the borders with those before has codes that belong together; where a patch is free,
/// patches that follow each other in the file get phases far apart.
std::vector<std::int32_t> phased_heights(const SmoothMesh& mesh,
                                         std::vector<std::int32_t> distances,
                                         const CodeRange& range) {
    const Fold fold(range.count());
    const PatchBorders borders(mesh);
    std::vector<std::int32_t> greatest(mesh.patch_count, 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        greatest[mesh.patch_of[f]] = std::max(greatest[mesh.patch_of[f]], distances[f]);
    std::vector<std::int32_t> phases(mesh.patch_count, -1);  // -1: not yet
    Losses losses(fold, range.least_difference);
    for (const std::uint32_t patch : patches_by_area(mesh)) {
        // A patch of one code needs no more of them than tell it from others of its kind.
        const std::int32_t stride = greatest[patch] < kStep ? range.least_difference : 1;
        const auto starts = static_cast<std::uint32_t>(fold.period() / 2 / stride);
        const auto start = static_cast<std::int32_t>(scattered(patch, starts)) * stride;
        losses.start();
        for (const BorderSide& side : borders.of(patch)) {
            const std::uint32_t other = mesh.patch_of[side.beyond];
            const std::int32_t distance = distances[side.face];
            const std::int32_t beyond = distances[side.beyond];
            if (other == patch) {
                losses.add_fold(distance, beyond, side.length);
            } else if (phases[other] >= 0) {
                losses.add(
                    distance, fold.code(beyond + std::int64_t{phases[other]} * kStep), side.length);
            }
        }
        phases[patch] = losses.best_from(start, stride);
    }
    for (std::size_t f = 0; f < distances.size(); ++f)
        distances[f] += phases[mesh.patch_of[f]] * kStep;
    return distances;
}

}  // namespace

void SurfaceCodes::prepare(const scene::PreparedScene& scene) {
    mesh_ = make_smooth_mesh(scene, options_.patches);
    face_of_ = *faces_of_triangles(scene, *mesh_, options_.patches.weld_epsilon);
}

std::vector<std::int32_t> SurfaceCodes::heights(std::span<const float> length_world) {
    const SmoothMesh& mesh = *mesh_;
    slits_ = {};
    std::vector<std::int32_t> distances(mesh.face_count(), 0);
    if (options_.turn_rad > 0) {
        StepCosts costs{options_.turn_rad, {}};
        if (!length_world.empty()) {
            costs.length_world.resize(mesh.face_count());
            for (std::size_t f = 0; f < mesh.face_count(); ++f)
                costs.length_world[f] = length_world[mesh.topology.faces[f].triangle];
        }
        SurfaceGraph graph(mesh, costs);
        if (options_.rounds > 0) steepen_short_slits(mesh, graph);
        distances = surface_distance(mesh, graph, options_.rounds, &slits_);
    }
    return phased_heights(mesh, std::move(distances), options_.range);
}

std::vector<std::uint32_t> SurfaceCodes::codes_of(std::span<const std::int32_t> heights) const {
    const Fold fold(options_.range.count());
    std::vector<std::uint32_t> codes(face_of_.size());
    std::transform(face_of_.begin(), face_of_.end(), codes.begin(), [&](std::uint32_t face) {
        const int code = face == SmoothMesh::kNone ? 0 : fold.code(heights[face]);
        return static_cast<std::uint32_t>(options_.range.lowest + code);
    });
    return codes;
}

std::vector<float> SurfaceCodes::object_lengths(double length_px) const {
    const auto length_world = static_cast<float>(largest_object() / kNominalHeight_px * length_px);
    if (length_world > 0) return std::vector<float>(face_of_.size(), length_world);
    return {};
}

std::vector<std::uint32_t> SurfaceCodes::object_codes(const scene::PreparedScene& scene,
                                                      double length_px) {
    const std::vector<float> lengths = object_lengths(length_px);
    const std::string name = fmt::format("surface codes {} {} {} {} {} {} {} {}",
                                         options_.patches.crease_rad,
                                         options_.patches.weld_epsilon,
                                         options_.turn_rad,
                                         options_.rounds,
                                         options_.range.lowest,
                                         options_.range.highest,
                                         options_.range.least_difference,
                                         lengths.empty() ? 0 : lengths.front());
    return *scene.get(name, [&] { return codes(lengths); });
}

double SurfaceCodes::largest_object() const {
    double largest = 0;
    for (const scene::Box& box : scene::object_boxes(mesh_->topology))
        largest = std::max(largest, box.diagonal());
    return largest;
}

}  // namespace ink::methods
