#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string_view>

namespace ink::import {

/// The endings of what is read, as the table in README.md has them.
inline constexpr std::string_view kReadEndings =
    ".gltf, .glb, .ply, .stl, .off, .obj, .mdl, .md2, .md3, .fbx";

[[nodiscard]] bool has_read_ending(const std::filesystem::path& path);

/// A kind of model file that is known and not read.
struct OtherFormat {
    std::string_view name;     ///< with its article
    std::string_view endings;  ///< one blank between two
    /// What its text begins with, behind the prolog of XML, white space as one blank; that of an
    /// IFF file behind FORM and its length. Empty: nothing that is its own.
    std::array<std::string_view, 3> marks;
    std::string_view way;  ///< to one that is read; each was tried, but for the maker's own
};

[[nodiscard]] std::span<const OtherFormat> other_formats();

/// Throws Refusal, which names format and way, if `head`, the beginning of a file, has the mark of
/// one of these formats.
void refuse_by_content(std::string_view head);

/// The same for a file's ending. What is UTF-16 and has none of them is refused as such.
void refuse_by_ending(const std::filesystem::path& path, std::string_view head);

}  // namespace ink::import
