#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ink::core {

// The one door to toml++: for what is written, or read leniently. Files of people go through
// TomlReader (toml_reader.h), whose users compile without that library.

/// The texts as an array of TOML.
[[nodiscard]] toml::array array_of(const std::vector<std::string>& texts);

/// The texts of an array of TOML; what is no text is "", and what is no array has none.
[[nodiscard]] std::vector<std::string> texts_of(const toml::node_view<const toml::node>& node);

/// Parses a file's text. Throws Error (where = file and line) if it is no TOML.
[[nodiscard]] toml::table parse_toml(std::string_view text, const std::filesystem::path& file);

}  // namespace ink::core
