#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "methods/surface_codes/surface_codes.h"
#include "scene/prepared_scene.h"

namespace ink::methods {

/// Faces at four neighbouring samples, as random views show them, and whether the pixel between
/// them is a line.
struct SeenSquare {
    /// Faces side by side, `pairs` of them, whose codes may differ by more than one; ascending.
    std::array<std::array<std::uint32_t, 2>, 4> sides{};
    std::uint32_t pairs = 0;
    std::uint32_t is_line = 0;

    [[nodiscard]] bool operator==(const SeenSquare&) const = default;
};

/// Squares, and how often each was seen.
struct SeenSquares {
    std::vector<SeenSquare> list;
    std::vector<float> weights;
};

/// From where a scene is looked at.
struct RandomViews {
    std::size_t poses = 1;
    int views = 1;  ///< of each pose
    std::uint32_t seed = 7;
    int width_px = 1280, height_px = 720;
};

/// Calls its argument with a scene in pose after pose.
using EachPose = std::function<void(const std::function<void(const scene::PreparedScene&)>&)>;

/// The squares of random views of poses, all of the scene that `codes` was prepared with; lines are
/// those that the mesh tells (LookupMethod). Left out is what codes cannot change: where sky is
/// seen, or only faces that go smoothly over into each other.
///
/// Seeded: the same on every machine. Where squares grow too many for memory, those of each pose
/// that come first.
[[nodiscard]] SeenSquares seen_squares(const SurfaceCodes& codes,
                                       double crease_deg,
                                       const RandomViews& from,
                                       const EachPose& each_pose);

/// Heights of a mesh's faces with which fewer of the squares are wrong, made of those of
/// SurfaceCodes::heights(), by a search of so many `moves`.
///
/// A square is right if codes differ somewhere in it by a line's least difference where it is a
/// line, and nowhere else. A move raises or lowers a face of a wrong square, and as little as
/// possible round it, so that what goes smoothly over into each other still differs by a step at
/// most; or it shifts a whole patch. It stays if what is lost of all squares, by their weights, is
/// no more than before. Seeded: the same on every machine.
[[nodiscard]] std::vector<std::int32_t> repaired_heights(const SmoothMesh& mesh,
                                                         const CodeRange& range,
                                                         const SeenSquares& squares,
                                                         const std::vector<std::int32_t>& heights,
                                                         int moves);

}  // namespace ink::methods
