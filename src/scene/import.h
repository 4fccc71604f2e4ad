#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace ink::scene {

/// How far a foreign file is trusted: it is parsed in a child process that cannot do more than
/// this.
struct ImportLimits {
    std::filesystem::path
        child;           ///< the import executable; empty: `inkbench_import` beside this program
    double wall_s = 60;  ///< it is killed after this long
    std::uint64_t memory_bytes = 8ULL << 30;  ///< of address space
    std::uint64_t output_bytes = 8ULL << 30;  ///< of scene data it may hand back
};

/// The scene in any file that Assimp reads, checked (`check_scene`), named by the file's stem, with
/// the file's own cameras (near and far fitted) and its node tree flattened to instances.
///
/// Throws Error with where = the path: no such file, empty, not a model, cut short, no triangle, a
/// vertex that is not finite, or a child that crashed, hung or asked for too much memory. Z-up
/// formats arrive as Assimp turns them. The scene's split is held-out.
[[nodiscard]] Scene import_scene(const std::filesystem::path& path,
                                 const ImportLimits& limits = {});

}  // namespace ink::scene
