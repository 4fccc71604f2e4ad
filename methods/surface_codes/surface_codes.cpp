#include "methods/surface_codes/surface_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <string>

#include "methods/surface_codes/patch_labels.h"
#include "methods/surface_codes/surface_graph.h"
#include "scene/precision/weld_tolerance.h"

namespace ink::methods {
namespace {

/// Rows of pixels that the largest object is taken to fill where no view says how large it is.
constexpr double kNominalHeight_px = 720;

/// Up and down between 0 and the highest of `count` codes, over and over.
class Fold {
  public:
    explicit Fold(int count) : most_(count - 1) {}

    /// Steps after which it comes again.
    [[nodiscard]] std::int32_t period() const { return 2 * most_; }
    [[nodiscard]] std::int32_t wrapped(std::int64_t phase) const {
        const std::int64_t rest = phase % period();
        return static_cast<std::int32_t>(rest < 0 ? rest + period() : rest);
    }
    [[nodiscard]] std::int32_t code(std::int32_t distance, std::int32_t phase) const {
        const std::int64_t whole = std::int64_t{period()} * kStep;
        std::int64_t at = (distance + std::int64_t{phase} * kStep) % whole;
        if (at > whole / 2) at = whole - at;
        return static_cast<std::int32_t>(at / kStep);
    }
    /// Calls visit(phase) for those at which a distance has a code: on the way up and down.
    template <class Visit>
    void for_each_phase(std::int32_t distance, std::int32_t code, Visit visit) const {
        if (code < 0 || code > most_) return;
        visit(wrapped(code - distance / kStep));
        if (code == 0 || code == most_) return;
        visit(wrapped(-code - (distance + kStep - 1) / kStep));
    }

  private:
    std::int32_t most_;
};

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

/// Per face a code from its distance, in units of kStep: the distance and the phase of its patch, a
/// whole number of steps, to and fro between the ends of the range.
///
/// Codes of a patch so change by no more steps than its distances. Phases are found patch by patch,
/// the largest area first, so that as little as possible of the borders with those before has codes
/// that belong together; where a patch is free, patches that follow each other in the file get
/// phases far apart.
std::vector<std::uint8_t> phased_codes(const SmoothMesh& mesh,
                                       std::span<const std::int32_t> distances,
                                       const CodeRange& range) {
    const Fold fold(range.highest - range.lowest + 1);
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
        for (const PatchBorders::Side& side : borders.of(patch)) {
            const std::uint32_t other = mesh.patch_of[side.beyond];
            const std::int32_t distance = distances[side.face];
            if (other == patch) {
                losses.add_fold(distance, distances[side.beyond], side.length);
            } else if (phases[other] >= 0) {
                losses.add(distance, fold.code(distances[side.beyond], phases[other]), side.length);
            }
        }
        phases[patch] = losses.best_from(start, stride);
    }
    std::vector<std::uint8_t> codes(mesh.face_count());
    for (std::size_t f = 0; f < codes.size(); ++f) {
        codes[f] = static_cast<std::uint8_t>(range.lowest +
                                             fold.code(distances[f], phases[mesh.patch_of[f]]));
    }
    return codes;
}

}  // namespace

void SurfaceCodes::prepare(const scene::PreparedScene& scene) {
    mesh_ = make_smooth_mesh(scene, options_.patches);
    face_of_ = *faces_of_triangles(scene, *mesh_, options_.patches.weld_epsilon);
}

std::vector<std::uint32_t> SurfaceCodes::codes(std::span<const float> length_world) {
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
    const std::vector<std::uint8_t> of_faces = phased_codes(mesh, distances, options_.range);
    const auto lowest = static_cast<std::uint32_t>(options_.range.lowest);
    std::vector<std::uint32_t> codes(face_of_.size());
    std::transform(face_of_.begin(), face_of_.end(), codes.begin(), [&](std::uint32_t face) {
        return face == SmoothMesh::kNone ? lowest : of_faces[face];
    });
    return codes;
}

std::vector<std::uint32_t> SurfaceCodes::object_codes(const scene::PreparedScene& scene,
                                                      double length_px) {
    const auto length_world = static_cast<float>(largest_object() / kNominalHeight_px * length_px);
    std::vector<float> lengths;
    if (length_world > 0) lengths.assign(scene::triangle_count(scene), length_world);
    const std::string name = fmt::format("surface codes {} {} {} {} {} {} {} {}",
                                         options_.patches.crease_rad,
                                         options_.patches.weld_epsilon,
                                         options_.turn_rad,
                                         options_.rounds,
                                         options_.range.lowest,
                                         options_.range.highest,
                                         options_.range.least_difference,
                                         length_world);
    return *scene.get(name, [&] { return codes(lengths); });
}

double SurfaceCodes::largest_object() const {
    double largest = 0;
    for (const scene::Box& box : scene::object_boxes(mesh_->topology))
        largest = std::max(largest, box.diagonal());
    return largest;
}

}  // namespace ink::methods
