#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "import/assimp/dae_cameras.h"

namespace ink::import {

/// A COLLADA file as Assimp is given it: Assimp passes over much in silence, so the document is
/// checked, and changed into one that says the same in words that Assimp heeds.
struct DaeFile {
    std::string text;
    std::vector<std::string> notes;
    bool has_motion = false;
    std::vector<DaeCamera> cameras;
};

/// Whether a file is COLLADA, by its ending or its first words.
[[nodiscard]] bool is_dae(const std::filesystem::path& path);

/// The document in a .dae or .zae file. Morph controllers become geometries of their weights'
/// shape, views (`lookat`) become matrices, what the file hides and all animations are taken out.
///
/// Throws Refusal for what is not read: skew, holes, surfaces without a mesh, references into other
/// files, joints that are not told apart. Throws Error for a damaged file, and for what it names
/// and does not hold.
[[nodiscard]] DaeFile read_dae(const std::filesystem::path& path);
/// The same of a document's text.
[[nodiscard]] DaeFile read_dae_text(std::string_view text);

}  // namespace ink::import
