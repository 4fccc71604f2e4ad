#pragma once

#include <hwy/cache_control.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/pass/aligned_array.h"
#include "scene/clusters.h"
#include "scene/surface.h"

namespace ink::raster {

/// Vertices of a cluster are padded to whole vectors of this many lanes, triangles too.
inline constexpr std::size_t kLanePad = 16;

[[nodiscard]] constexpr std::size_t lane_padded(std::size_t count) {
    return (count + kLanePad - 1) / kLanePad * kLanePad;
}

/// A surface laid out for vector registers: cluster by cluster, one array per coordinate.
///
/// All of a cluster lies in one block, since clusters are visited in the order of their distance:
/// each is one place that has to be fetched.
///
/// World positions are kept as floats where every one of them is a float (instances that are not
/// moved), which halves what a frame reads; else as doubles. Either way the numbers are the
/// surface's.
class LaneMesh {
  public:
    LaneMesh() = default;
    /// `surface` is borrowed for the mesh's life; `clusters` are its own. Normals may be missing.
    LaneMesh(const scene::Surface& surface, scene::Clusters clusters);
    explicit LaneMesh(const scene::Surface& surface)
        : LaneMesh(surface, scene::make_clusters(surface)) {}

    /// Takes the positions, normals, bounds and cones of a surface of the same triangles, corner by
    /// corner, that has moved.
    void update(const scene::Surface& moved);

    [[nodiscard]] const scene::Surface& surface() const { return *surface_; }
    [[nodiscard]] const scene::Clusters& clusters() const { return clusters_; }
    [[nodiscard]] bool has_normals() const { return has_normals_; }
    [[nodiscard]] bool has_float_positions() const { return is_float_; }

    /// Coordinate `axis` of a cluster's vertices; padded with its last one.
    [[nodiscard]] const float* float_positions(std::size_t cluster, int axis) const {
        return at<float>(cluster, static_cast<std::size_t>(axis) * padded(cluster));
    }
    [[nodiscard]] const double* double_positions(std::size_t cluster, int axis) const {
        return at<double>(cluster, static_cast<std::size_t>(axis) * padded(cluster));
    }
    [[nodiscard]] const float* normals(std::size_t cluster, int axis) const {
        const std::size_t before = is_float_ ? 3 : 6;
        return at<float>(cluster, (before + static_cast<std::size_t>(axis)) * padded(cluster));
    }
    /// The corners of a cluster's triangles as its vertices, and which of its triangles each is:
    /// first | second << 8 | third << 16 | index << 24. Padded with 0.
    [[nodiscard]] const std::int32_t* corners(std::size_t cluster) const {
        const std::size_t before = (is_float_ ? 3U : 6U) + (has_normals_ ? 3U : 0U);
        return at<std::int32_t>(cluster, before * padded(cluster));
    }

    /// Asks for a part of a cluster's block ahead of its use: 0 .. kPrefetchParts - 1, one at a
    /// time, because only so many lines can be on their way. (Inlined by force: GCC takes a
    /// function that does nothing else for one without effect, and leaves out its calls.)
    static constexpr std::size_t kPrefetchParts = 3;
    HWY_INLINE void prefetch(std::size_t cluster, std::size_t part) const {
        const std::size_t begin = first_byte_[cluster] / kLineBytes;
        const std::size_t count = first_byte_[cluster + 1] / kLineBytes - begin;
        const std::size_t end = begin + count * (part + 1) / kPrefetchParts;
        for (std::size_t line = begin + count * part / kPrefetchParts; line < end; ++line)
            hwy::Prefetch(bytes_.data() + line * kLineBytes);
    }

    /// Asks for what says where a cluster's block lies, and for the cluster itself.
    HWY_INLINE void prefetch_place(std::size_t cluster) const {
        hwy::Prefetch(&first_byte_[cluster]);
        prefetch_bounds(cluster);
    }
    /// Asks for the cluster itself, which may lie in two lines.
    HWY_INLINE void prefetch_bounds(std::size_t cluster) const {
        const scene::Cluster* const at = &clusters_.clusters[cluster];
        hwy::Prefetch(at);
        hwy::Prefetch(reinterpret_cast<const std::byte*>(at + 1) - 1);
    }
    /// Vertex `i` of a cluster: the surface's own numbers.
    [[nodiscard]] glm::dvec3 position(std::size_t cluster, std::size_t i) const {
        glm::dvec3 p;
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = is_float_ ? static_cast<double>(float_positions(cluster, axis)[i])
                                : double_positions(cluster, axis)[i];
        }
        return p;
    }

    /// Which of its cluster's triangles it is, of what corners() has; above its index may stand one
    /// bit more.
    [[nodiscard]] static constexpr std::size_t index_of(std::uint32_t corners) {
        static_assert(scene::kMaxClusterTriangles <= 128);
        return corners >> 24 & 127;
    }

  private:
    /// Of a cache line, and of the largest vector: blocks and their arrays begin at one.
    static constexpr std::size_t kLineBytes = 64;
    static_assert(kLanePad * sizeof(float) % kLineBytes == 0);

    void lay_out();
    void fill();
    [[nodiscard]] std::size_t padded(std::size_t cluster) const {
        return lane_padded(clusters_.clusters[cluster].vertex_count);
    }
    /// The `count`-th T of a cluster's block.
    template <class T>
    [[nodiscard]] const T* at(std::size_t cluster, std::size_t count) const {
        return reinterpret_cast<const T*>(bytes_.data() + first_byte_[cluster]) + count;
    }

    const scene::Surface* surface_ = nullptr;
    scene::Clusters clusters_;
    bool is_float_ = true;
    bool has_normals_ = false;
    std::vector<std::size_t> first_byte_;  ///< of a cluster's block, and the end
    AlignedArray<std::byte> bytes_;
};

}  // namespace ink::raster
