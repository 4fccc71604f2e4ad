#pragma once

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>

#include "core/error.h"
#include "import/scene_stream.h"

// What tests of readers of meshes ask of what was read.

namespace ink::import {

using MeshReader = ImportReply (*)(std::string_view, const std::string&);

/// The only mesh in `file`, called "model" where the file gives no name.
inline ImportedMesh read_one(MeshReader read, const std::string& file) {
    ImportReply reply = read(file, "model");
    EXPECT_EQ(reply.status, ImportStatus::scene);
    EXPECT_EQ(reply.meshes.size(), 1U);
    EXPECT_EQ(reply.instances.size(), 1U);
    return reply.meshes.empty() ? ImportedMesh{} : std::move(reply.meshes.front());
}

/// What the reader complains of, and what it would take; empty, and a failure, if it does not.
inline std::string fault(MeshReader read, const std::string& file) {
    try {
        (void)read(file, "model");
    } catch (const core::Error& error) {
        return error.what_happened() + " (" + error.accepted() + ")";
    }
    ADD_FAILURE() << "it was read";
    return {};
}

inline double area(const ImportedMesh& mesh) {
    double twice = 0;
    for (const scene::Triangle& t : mesh.triangles) {
        const glm::dvec3& a = mesh.positions[t[0]];
        twice += glm::length(glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
    }
    return twice / 2;
}

/// Above 0 for a closed surface whose triangles are counter-clockwise from outside.
inline double volume(const ImportedMesh& mesh) {
    double six = 0;
    for (const scene::Triangle& t : mesh.triangles) {
        six +=
            glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]]));
    }
    return six / 6;
}

/// The unit cube's corners, x slowest, and its faces as quads.
inline constexpr std::array<std::array<int, 4>, 6> kCubeFaces{
    {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};
inline std::array<int, 3> cube_corner(int i) {
    return {i / 4, i / 2 % 2, i % 2};
}

/// Each corner in a line of its own, such as "v 0 0 1".
inline std::string cube_corners(const std::string& before = "", const std::string& after = "\n") {
    std::string text;
    for (int i = 0; i < 8; ++i) {
        const auto p = cube_corner(i);
        text += before + std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' +
                std::to_string(p[2]) + after;
    }
    return text;
}

/// Each face in a line of its own, such as "4 0 1 3 2"; corners are counted from `first`.
inline std::string cube_faces(const std::string& before, int first, const std::string& end = "\n") {
    std::string text;
    for (const auto& face : kCubeFaces) {
        text += before;
        for (const int corner : face)
            text += ' ' + std::to_string(corner + first);
        text += end;
    }
    return text;
}

inline void expect_unit_cube(const ImportedMesh& mesh) {
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_DOUBLE_EQ(volume(mesh), 1);
    EXPECT_DOUBLE_EQ(area(mesh), 6);
}
inline void expect_unit_cube(MeshReader read, const std::string& file) {
    expect_unit_cube(read_one(read, file));
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// What is replaced in a sound file, by what, and a part of what its reader says then.
struct Fault {
    const char* what;
    const char* by;
    const char* message;
};

inline void expect_faults(MeshReader read,
                          const std::string& sound,
                          const std::vector<Fault>& faults) {
    for (const auto& [what, by, message] : faults)
        EXPECT_NE(fault(read, replaced(sound, what, by)).find(message), std::string::npos)
            << what << " -> " << by << ": " << fault(read, replaced(sound, what, by));
}

}  // namespace ink::import
