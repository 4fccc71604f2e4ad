#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "method/method_config.h"
#include "methods/registry.h"

namespace ink::methods {

/// The configuration that a preset file of the user's describes (methods/presets.h).
///
/// It may be called as a shipped preset, whose place it takes among all methods. Throws core::Error
/// that names the file and the line, also where it is called as any other method that there is.
[[nodiscard]] method::MethodConfig preset_config(const std::filesystem::path& file);

/// Gives each of `settings` to those that it means, as make_configs does, and reads all of them.
void apply_settings(const std::vector<std::string>& settings,
                    std::vector<method::MethodConfig>& configs);

/// Gives the truth's crease angle to the configurations that have it as their own: whose parameter
/// `crease_deg` is 40 by default, as the truth's is, and which nobody set.
void follow_crease(double crease_deg, std::vector<method::MethodConfig>& configs);

/// The configurations that a comma list of methods, some settings and some preset files name; an
/// empty list is every method.
///
/// A setting is `key=value` (for every method that knows the key) or `method.key=value`. Throws
/// core::Error for an unknown method, a method named twice, a key that nobody knows, a bad value.
[[nodiscard]] std::vector<method::MethodConfig> make_configs(
    const std::string& methods,
    const std::vector<std::string>& settings,
    const std::vector<std::string>& presets = {});

}  // namespace ink::methods
