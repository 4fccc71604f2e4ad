#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "truth/eye_view.h"

namespace ink::truth {

/// Two neighbouring pixel centres and the faces seen there (kNoFace: sky). A walk goes along the
/// segment between them, s = 0 at the one, 1 at the other.
struct CentrePair {
    double x_px = 0, y_px = 0;  ///< of s = 0
    double dx = 0, dy = 0;      ///< one of them 1 or -1, the other 0
    std::uint32_t from = kNoFace;
    std::uint32_t to = kNoFace;

    /// The same, from the other end.
    [[nodiscard]] CentrePair reversed() const { return {x_px + dx, y_px + dy, -dx, -dy, to, from}; }
};

/// A face that a walk ran over: q = 1/w there is slope * s + offset, up to s_end.
struct WalkedPiece {
    double s_end = 0;
    double slope = 0, offset = 0;
};

/// A feature edge where a walk crossed it.
struct CrossedFeature {
    std::uint32_t edge = 0;
    double s = 0;
    double q = 0;
};

/// What a walk over the mesh met.
struct SurfaceWalk {
    bool reached = false;                   ///< the other face, without crossing a feature edge
    bool has_left_patch = false;            ///< it went on in what no vertices join, over no crack
    std::optional<CrossedFeature> feature;  ///< the first feature edge it crossed
    std::vector<WalkedPiece> pieces;

    /// 1/w of the walked surface at s, nothing where the walk did not come.
    [[nodiscard]] std::optional<double> q_at(double s) const;
    /// How far it came.
    [[nodiscard]] double end() const;
};

/// Walks over the mesh from `pair.from` at s = 0 towards s = 1, until it reaches `pair.to`, crosses
/// a feature edge, or ends with its surface or beyond s = 1. A face within 1e-3 px of the far
/// centre counts as reached there. Writes over `out`, so that its memory is used again; from sky it
/// stays empty.
void walk_surface(const EyeView& eye, const CentrePair& pair, SurfaceWalk& out);

}  // namespace ink::truth
