#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/param.h"
#include "method/method.h"

namespace ink::methods {

/// A preset that is to be written: what methods/presets.h reads, and how it came about.
struct PresetFile {
    std::string name;
    const method::MethodInfo* method = nullptr;
    core::ParamValues settings;
    /// Lines of [provenance], values as TOML spells them (see toml_text). Nothing of time, machine
    /// or commit: the same command writes the same bytes.
    std::vector<std::pair<std::string, std::string>> provenance;
};

/// `text` in quotes, as TOML has it.
[[nodiscard]] std::string toml_text(const std::string& text);

/// The file's text, settings in the order of the method's table.
[[nodiscard]] std::string preset_toml(const PresetFile& preset);

}  // namespace ink::methods
