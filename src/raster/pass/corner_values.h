#pragma once

#include <cstddef>

#include "raster/pass/pass.h"

namespace ink::raster {

/// Vertices that values are wanted for, one array per number.
struct CornerBatch {
    std::size_t count = 0;
    const double* w = nullptr;  ///< distance along the view direction, at least the near plane's
    const double* inv_w = nullptr;  ///< 1/w as the screen position was made with
    const float* n_world[3] = {};   ///< normals, unit but at cuts; null where the surface has none
};

/// Where the values go: plane k of vertex i to front[k][i].
struct CornerPlanes {
    float* front[kMaxPlanes] = {};
    float* back[kMaxPlanes] = {};  ///< for triangles seen from their back; null if nobody asks
};

/// A method's share of the vertex stage: what it interpolates, from distance and normal.
class CornerValues {
  public:
    virtual ~CornerValues() = default;
    /// Arrays are padded to kLanePad and may be written that far. Called from several threads. The
    /// values of a vertex depend on that vertex alone.
    virtual void compute(const CornerBatch& in, const CornerPlanes& out) const = 0;
};

/// A value that is a linear sum of 1/w and the normal: base + per_q / w + per_normal . n.
struct LinearValue {
    double base = 0;
    double per_q = 0;
    float per_normal[3] = {};  ///< world space
};

/// Computes `planes` linear values in vector registers; on the back the normal counts negated.
///
/// float(base + per_q * inv_w) in double, then the normal's products added in float, x first. A
/// plane without weights for the normal does not read it, unless `reads_all`.
void compute_linear(const LinearValue* values,
                    int planes,
                    bool reads_all,
                    const CornerBatch& in,
                    const CornerPlanes& out);

}  // namespace ink::raster
