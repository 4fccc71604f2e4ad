#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "methods/surface_codes/smooth_mesh.h"
#include "methods/surface_codes/surface_distance.h"

namespace ink::methods {

/// Numbers that codes take. What is empty has a number apart from them.
struct CodeRange {
    int lowest = 2;
    int highest = 255;
    /// Codes that differ by less belong together.
    int least_difference = 2;

    [[nodiscard]] int count() const { return highest - lowest + 1; }
};

/// How codes follow the surface.
struct CodeOptions {
    buffers::PatchOptions patches;
    double turn_rad = 0;  ///< turning of the normal that costs a step; 0: a patch has one code
    int rounds = 0;       ///< of lifting one side of creases that end inside a patch
    CodeRange range;
};

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
    /// That of a height in units of kStep, which may be below 0.
    [[nodiscard]] std::int32_t code(std::int64_t height) const {
        const std::int64_t whole = std::int64_t{period()} * kStep;
        std::int64_t at = height % whole;
        if (at < 0) at += whole;
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

/// One code of a byte per triangle of a scene: what methods without interpolants draw.
///
/// Codes are functions of the scene as it stands when it is prepared, and of a footprint: the
/// length that a step must cover at least. So they stay while a scene moves. Deterministic. An
/// empty scene has none.
class SurfaceCodes {
  public:
    explicit SurfaceCodes(const CodeOptions& options) : options_(options) {}

    /// Welds and cuts the scene as it stands. O(n log n).
    void prepare(const scene::PreparedScene& scene);

    /// A code per triangle. `length_world` holds a length per triangle at least that a step covers
    /// there, or nothing: then steps are as short as the surface makes them.
    [[nodiscard]] std::vector<std::uint32_t> codes(std::span<const float> length_world) {
        return codes_of(heights(length_world));
    }
    /// The same before it is folded: a height per face, in units of kStep. Where a face goes
    /// smoothly over into another they differ by a step at most.
    [[nodiscard]] std::vector<std::int32_t> heights(std::span<const float> length_world);
    /// Per triangle the code of its face's height.
    [[nodiscard]] std::vector<std::uint32_t> codes_of(std::span<const std::int32_t> heights) const;

    /// The codes of the scene that was prepared, where every step covers so many pixels if the
    /// largest object fills the height of 720; 0: no length. Made once and kept with the scene.
    [[nodiscard]] std::vector<std::uint32_t> object_codes(const scene::PreparedScene& scene,
                                                          double length_px);

    /// What heights() takes then.
    [[nodiscard]] std::vector<float> object_lengths(double length_px) const;

    /// The diameter of the largest object, world units: of the box round it.
    [[nodiscard]] double largest_object() const;
    [[nodiscard]] const SmoothMesh& mesh() const { return *mesh_; }
    /// Per triangle, see faces_of_triangles().
    [[nodiscard]] const std::vector<std::uint32_t>& face_of() const { return face_of_; }
    [[nodiscard]] const CodeRange& range() const { return options_.range; }
    /// Of the codes that were made last.
    [[nodiscard]] const SlitCount& slits() const { return slits_; }

  private:
    CodeOptions options_;
    std::shared_ptr<const SmoothMesh> mesh_ = std::make_shared<const SmoothMesh>();
    std::vector<std::uint32_t> face_of_;  ///< per triangle
    SlitCount slits_;
};

}  // namespace ink::methods
