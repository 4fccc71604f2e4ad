#pragma once

#include <array>
#include <string_view>

namespace ink::method {

/// What a method works on: what its colour and its panel say on charts.
enum class Family {
    packed,           ///< depth and normal in a code of a byte or two
    full_buffers,     ///< depth and normal as floats
    ids,              ///< numbers of objects, patches or triangles
    edges_and_hulls,  ///< edges of the mesh as lines, or the mesh drawn again behind itself
    other,            ///< nobody said: a guest, or a preset that the registry does not know
};

/// All of them, in the order of legends and panels.
inline constexpr std::array kFamilies = {
    Family::packed, Family::full_buffers, Family::ids, Family::edges_and_hulls, Family::other};

/// "packed", "full_buffers", ...: as tables spell it.
[[nodiscard]] std::string_view name_of(Family family);

/// The shape that tells a method from others of its family.
enum class Marker { circle, square, diamond, up, down, plus, cross, left, right };

/// All of them, in the order in which methods of a family stand.
inline constexpr std::array kMarkers = {Marker::circle,
                                        Marker::square,
                                        Marker::diamond,
                                        Marker::up,
                                        Marker::down,
                                        Marker::plus,
                                        Marker::cross,
                                        Marker::left,
                                        Marker::right};

/// "circle", "square", ...: as tables spell it; `up`, `down`, `left` and `right` are triangles.
[[nodiscard]] std::string_view name_of(Marker marker);

}  // namespace ink::method
