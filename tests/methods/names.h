#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "methods/registry.h"

/// What tests over every method or every scene are named by.
namespace ink::methods {

inline std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const method::MethodInfo& info : registry())
        names.push_back(info.name);
    return names;
}

/// Whether a method draws creases, as most do; the others draw contours alone, from outside.
inline bool draws_creases(std::string_view method) {
    constexpr std::array<std::string_view, 6> kContoursOnly = {"polygon_offset",
                                                               "polygon_offset_tuned",
                                                               "back_faces",
                                                               "inverted_hull",
                                                               "blurred_silhouette",
                                                               "rim"};
    return std::find(kContoursOnly.begin(), kContoursOnly.end(), method) == kContoursOnly.end();
}

/// Whether a method finds lines of flat faces: where it looks at n.v alone, a face is dark as a
/// whole or not at all (shading_lines_test.cpp says what it draws of a ball).
inline bool draws_polyhedra(std::string_view method) {
    return method != "rim";
}

/// Whether a method takes a plane's own slope for a line at grazing angles: it compares bare depth
/// or looks at n.v, as today's practice does.
inline bool draws_grazing_planes(std::string_view method) {
    return method == "rim" || method == "ids_depth";
}

/// Whether a method's image depends on which side of a face is its front.
inline bool knows_sides(std::string_view method) {
    return method == "back_faces" || method == "inverted_hull";
}

}  // namespace ink::methods
