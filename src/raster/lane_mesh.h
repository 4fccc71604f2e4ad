#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/aligned_array.h"
#include "scene/clusters.h"
#include "scene/surface.h"

namespace ink::raster {

/// Vertices of a cluster are padded to whole vectors of this many lanes, triangles too.
inline constexpr std::size_t kLanePad = 16;

/// A surface laid out for vector registers: cluster by cluster, one array per coordinate.
///
/// World positions are kept as floats where every one of them is a float (instances that are not
/// moved), which halves what a frame reads; else as doubles. Either way the numbers are the
/// surface's.
class LaneMesh {
  public:
    LaneMesh() = default;
    /// `surface` is borrowed for the mesh's life. Normals may be missing.
    explicit LaneMesh(const scene::Surface& surface);

    /// Takes the positions, normals, bounds and cones of a surface of the same triangles, corner by
    /// corner, that has moved.
    void update(const scene::Surface& moved);

    [[nodiscard]] const scene::Surface& surface() const { return *surface_; }
    [[nodiscard]] const scene::Clusters& clusters() const { return clusters_; }
    [[nodiscard]] bool has_normals() const { return normals_[0].size() > 0; }
    [[nodiscard]] bool has_float_positions() const { return is_float_; }

    /// Coordinate `axis` of a cluster's vertices; padded with its last one.
    [[nodiscard]] const float* float_positions(std::size_t cluster, int axis) const {
        return floats_[static_cast<std::size_t>(axis)].data() + first_vertex_[cluster];
    }
    [[nodiscard]] const double* double_positions(std::size_t cluster, int axis) const {
        return doubles_[static_cast<std::size_t>(axis)].data() + first_vertex_[cluster];
    }
    [[nodiscard]] const float* normals(std::size_t cluster, int axis) const {
        return normals_[static_cast<std::size_t>(axis)].data() + first_vertex_[cluster];
    }
    /// Corner 0, 1 or 2 of a cluster's triangles, as vertices of the cluster; padded with 0.
    [[nodiscard]] const std::uint8_t* corners(std::size_t cluster, int corner) const {
        return corners_[static_cast<std::size_t>(corner)].data() + first_triangle_[cluster];
    }

  private:
    void lay_out();
    void fill();

    const scene::Surface* surface_ = nullptr;
    scene::Clusters clusters_;
    bool is_float_ = true;
    std::vector<std::uint32_t> first_vertex_;
    std::vector<std::uint32_t> first_triangle_;
    std::array<AlignedArray<float>, 3> floats_;
    std::array<AlignedArray<double>, 3> doubles_;
    std::array<AlignedArray<float>, 3> normals_;
    std::array<AlignedArray<std::uint8_t>, 3> corners_;
};

}  // namespace ink::raster
