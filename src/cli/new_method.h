#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ink::cli {

/// Adds a method called `name` to the source tree at `root`: a copy of methods/_template with its
/// names changed, and its lines in methods/registry.cpp and methods/CMakeLists.txt. Returns the
/// files that are new or changed, relative to `root`.
///
/// A name is of small letters, digits and underscores, begins with a letter and is no word of C++
/// that the template has. Throws core::Error, with nothing written, for another name, one that is
/// taken, or a `root` that is no source tree of Inkbench.
std::vector<std::filesystem::path> add_new_method(const std::filesystem::path& root,
                                                  const std::string& name);

}  // namespace ink::cli
