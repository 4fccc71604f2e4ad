#pragma once

#include <cstdint>
#include <vector>

#include "methods/surface_codes/seen_squares.h"

namespace ink::methods {

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
