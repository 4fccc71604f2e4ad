#pragma once

#include <toml++/toml.h>
#include <string>
#include <string_view>
#include <vector>

#include "core/param.h"

namespace ink::methods {

// What files of methods and of presets have in common. Each throws core::Error (where =
// "file:line") that says what would have been accepted; `where` is the file's name.

/// The file's keys and values; `what` it is, for messages.
[[nodiscard]] toml::table parse_toml(std::string_view text,
                                     const std::string& where,
                                     const std::string& what);

/// "file:line" of a value.
[[nodiscard]] std::string place_of(const toml::node& node, const std::string& where);

/// `what` has no other keys.
void refuse_unknown_keys(const toml::table& file,
                         const std::vector<std::string>& known,
                         const std::string& what,
                         const std::string& where);

/// The text behind `key`, which must be there; `needed` names the keys that must.
[[nodiscard]] std::string text_of(const toml::table& table,
                                  const char* key,
                                  const std::string& where,
                                  const char* needed);

/// The parameter called `name`; `place` of the name.
[[nodiscard]] const core::Param& param_of(const std::vector<core::Param>& params,
                                          const std::string& name,
                                          const std::string& place);

/// Settings as the command line spells them.
[[nodiscard]] core::ParamValues read_settings(const toml::table& settings,
                                              const std::vector<core::Param>& params,
                                              const std::string& where);

}  // namespace ink::methods
