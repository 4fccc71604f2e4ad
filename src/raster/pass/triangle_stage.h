#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/pass/attribute_planes.h"
#include "raster/pass/pass.h"
#include "raster/pass/setup.h"

namespace ink::raster {

/// The triangles made from one run of submitted ones, in order; a clipped one makes several.
struct Batch {
    std::vector<SetupTriangle> triangles;
    /// K per triangle; at most one of the two is filled: what the format does not store is not
    /// made.
    std::vector<CodePlane> code_planes;
    std::vector<FloatPlane> float_planes;
    PassStats stats;  ///< of this run: submitted, clipped, outside, without sample
};

/// Submitted triangles per batch: a batch of large triangles stays in the second-level cache.
inline constexpr std::size_t kBatchTriangles = 4096;

/// Whether a format's planes are CodePlanes (integer store and affine), else FloatPlanes.
[[nodiscard]] inline bool has_code_planes(const PassFormat& format) {
    return format.store != Store::f32 && format.interpolation == Interpolation::affine;
}

/// Clips and sets up the whole input: batch i holds triangles i * kBatchTriangles onwards.
[[nodiscard]] std::vector<Batch> set_up_batches(const PassFormat& format,
                                                const PassInput& input,
                                                const PixelRect& image,
                                                int threads);

/// Clips and sets up a short input after what `batch` holds already, on this thread.
void set_up_more(const PassFormat& format,
                 const PassInput& input,
                 const PixelRect& image,
                 Batch& batch);

}  // namespace ink::raster
