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
};

/// How codes follow the surface.
struct CodeOptions {
    buffers::PatchOptions patches;
    double turn_rad = 0;  ///< turning of the normal that costs a step; 0: a patch has one code
    int rounds = 0;       ///< of lifting one side of creases that end inside a patch
    CodeRange range;
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
    [[nodiscard]] std::vector<std::uint32_t> codes(std::span<const float> length_world);

    /// The codes of the scene that was prepared, where every step covers so many pixels if the
    /// largest object fills the height of 720; 0: no length. Made once and kept with the scene.
    [[nodiscard]] std::vector<std::uint32_t> object_codes(const scene::PreparedScene& scene,
                                                          double length_px);

    /// The diameter of the largest object, world units: of the box round it.
    [[nodiscard]] double largest_object() const;
    [[nodiscard]] const SmoothMesh& mesh() const { return *mesh_; }
    /// Of the codes that were made last.
    [[nodiscard]] const SlitCount& slits() const { return slits_; }

  private:
    CodeOptions options_;
    std::shared_ptr<const SmoothMesh> mesh_ = std::make_shared<const SmoothMesh>();
    std::vector<std::uint32_t> face_of_;  ///< per triangle
    SlitCount slits_;
};

}  // namespace ink::methods
