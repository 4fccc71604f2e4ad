#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/param.h"
#include "method/method.h"

namespace ink::methods {

/// A preset that is to be written: what parse_preset reads, and how it came about.
struct PresetFile {
    std::string name;
    const method::MethodInfo* method = nullptr;
    core::ParamValues settings;
    /// Lines of [provenance], values as TOML spells them (see toml_text). Nothing of time, machine
    /// or commit: the same command writes the same bytes.
    std::vector<std::pair<std::string, std::string>> provenance;
};

/// Throws core::Error (where = `where`) for what cannot be the name of a method.
void check_name(const std::string& name, const std::string& where);

/// `text` in quotes, as TOML has it.
[[nodiscard]] std::string toml_text(const std::string& text);

/// The file's text, settings in the order of the method's table.
[[nodiscard]] std::string preset_toml(const PresetFile& preset);

/// A method at settings of its own, under a name of its own: what `inkbench tune` finds.
///
/// As a file:
///
///     name = "mote4_tuned"
///     method = "mote4"
///
///     [settings]
///     range_depth = 81.5
///     normals = "patch"
///
///     [provenance]
///     command = "inkbench tune mote4 ..."
struct Preset {
    std::string name;            ///< small letters, digits and underscores
    std::string method;          ///< the method whose code it runs
    core::ParamValues settings;  ///< over that method's defaults
    std::string command;         ///< what made it, or "" if nobody says
};

/// Reads a preset; `where` is the file's name, for messages. Keys of [provenance] are not looked
/// at, `command` apart.
///
/// Throws core::Error (where = "file:line") for text that is no TOML, a key that is missing or
/// unknown, a value of another type, a name that cannot be one, a method that is not among `bases`,
/// a setting that it does not have or does not accept.
[[nodiscard]] Preset parse_preset(std::string_view text,
                                  const std::string& where,
                                  const std::vector<method::MethodInfo>& bases);

/// A row for the registry: the method of `preset` among `bases`, with the preset's settings as
/// defaults.
///
/// The sweep has eight settings: the tuned ones, those lines of the method's own sweep that leave
/// the tuned parameters alone, and steps of the tuned parameters to both sides, which show how
/// sharp the optimum is.
[[nodiscard]] method::MethodInfo preset_method(const Preset& preset,
                                               const std::vector<method::MethodInfo>& bases);

}  // namespace ink::methods
