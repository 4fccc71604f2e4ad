#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bake/coded_mesh.h"
#include "draw/outline_svg.h"
#include "experiment/run_data.h"
#include "harness/suite/suite.h"

namespace ink::report {

/// A mesh as live/mesh.js unpacks it.
struct PackedMesh {
    std::vector<std::uint8_t> bytes;  ///< deflated, in zlib's format
    std::size_t place_count = 0;      ///< points, and places of vertices that are at no point
};

/// The arrays of a mesh, and its vertices in the poses of a scene that moves.
///
/// Nothing is lost. Of each number stays what the one before it, or another array, does not tell;
/// the lowest bytes of all numbers of an array stand before the next ones.
[[nodiscard]] PackedMesh packed_mesh(const bake::CodedMesh& mesh,
                                     std::span<const bake::MovingVertices> poses);

/// The largest scene that a live page takes: it holds the mesh as text, and browsers hold that
/// twice while they read it.
inline constexpr std::size_t kMostLiveTriangles = 8'000'000;

/// The exact lines of a view; none where they were not traced.
using ViewLines = std::vector<draw::ClassPath>;

/// The page that draws a scene on the reader's own GPU with the methods' shaders, side by side: one
/// HTML file that needs no other and no network.
///
/// It holds the scene as it stands, with the codes that methods draw at default parameters
/// (bake/coded_mesh.h), its views, and of one that moves even poses, which play. With a run, it
/// shows each method's F, or soft F of ink, at each of its views that the run has of a scene of
/// that name, or why there is none; with `lines`, as many as views, it lays those over the picture.
/// What it shows is drawn by its own scripts (live/). Throws
/// core::Error (where = the scene) for a scene without triangles, or of more than
/// kMostLiveTriangles.
[[nodiscard]] std::string live_page(const harness::SceneViews& scene_views,
                                    const std::optional<experiment::RunData>& run,
                                    std::span<const ViewLines> lines = {});

/// Where the page of a scene lies for a run's own page to link to it, below the run's folder.
[[nodiscard]] std::filesystem::path live_page_path(const std::string& scene_name);

}  // namespace ink::report
