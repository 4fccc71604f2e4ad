#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "import/scene_stream.h"

// Our own readers of files of meshes. Each takes a whole file and the name that its object has
// where the file gives none, and throws core::Error that names the line or byte at which the file
// is wrong.

namespace ink::import {

/// PLY 1.0: text or binary of both byte orders; faces of any number of corners and triangle strips;
/// normals and texture coordinates of vertices; elements and properties in any order. Others are
/// read over.
[[nodiscard]] ImportReply read_ply(std::string_view file, const std::string& name);

/// STL: text or binary, told by content. All solids of a file are one object, called as its only
/// solid. Facet normals are given to the facet's corners.
[[nodiscard]] ImportReply read_stl(std::string_view file, const std::string& name);
/// Whether a file is STL text by the first words of its first two lines.
[[nodiscard]] bool is_stl_text(std::string_view file);
/// Whether it can be binary STL, which has no mark: it is as long as its count says, or longer and
/// no text.
[[nodiscard]] bool is_binary_stl(std::string_view file);

/// OFF: with normals, colours and texture coordinates (of which normals are kept), a vertex or face
/// a line. Of four coordinates, n, or binary: refused.
[[nodiscard]] ImportReply read_off(std::string_view file, const std::string& name);
/// Whether a file begins with one of the words OFF, NOFF, STCN4OFF ...
[[nodiscard]] bool is_off(std::string_view file);

/// Wavefront OBJ: an `o` makes an object (one that comes again goes on), a material a part. Corners
/// are the same vertex where position and normal are. Surfaces are refused; curves, lines and
/// points are left out with a note.
[[nodiscard]] ImportReply read_obj(std::string_view file, const std::string& name);
/// All of the file of a name beside the model; nothing if there is none.
using FilesBeside = std::function<std::string(const std::string&)>;

/// With the material libraries in files beside it, of which transparency is noted; one that is
/// missing is no fault. With `has_texcoords` corners are the same vertex only where that is, too.
[[nodiscard]] ImportReply read_obj(std::string_view file,
                                   const std::string& name,
                                   const FilesBeside& beside,
                                   bool has_texcoords = false);

}  // namespace ink::import
