#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/param.h"
#include "methods/registry.h"

namespace ink::harness {

/// A method as it takes part: which, and with which settings.
struct MethodConfig {
    const method::MethodInfo* info = nullptr;
    core::ParamValues settings;  ///< what the user set; the rest is default
    /// Keeps `info` where it is a row of no registry, but a preset of the user's.
    std::shared_ptr<const method::MethodInfo> owned = nullptr;
    bool is_outside = false;  ///< its images and times come from elsewhere (OutsideMethod)
};

/// "key=value" or "method.key=value", as it is written.
struct Setting {
    std::string method;  ///< "" means all that know the key
    std::string key;
    std::string value;
    std::string text;
};

/// The configuration with `settings` over its own.
[[nodiscard]] MethodConfig with(MethodConfig config, const core::ParamValues& settings);

/// Throws core::Error (where = "--set") for other text.
[[nodiscard]] Setting parse_setting(const std::string& text);

/// The parameter that a setting is for; null if it is for other methods, or of a key that this one
/// does not know.
[[nodiscard]] const core::Param* param_of(const Setting& setting, const MethodConfig& config);

/// "a, b,c" as its parts without the blanks round them, empty ones left out.
[[nodiscard]] std::vector<std::string> split_list(const std::string& text);

/// The configuration that a preset file of the user's describes (methods/presets.h).
///
/// It may be called as a shipped preset, whose place it takes among all methods. Throws core::Error
/// that names the file and the line, also where it is called as any other method that there is.
[[nodiscard]] MethodConfig preset_config(const std::filesystem::path& file);

/// The edge response (1..255) from which a pixel of `config` counts as drawn.
[[nodiscard]] int threshold_of(const MethodConfig& config);

/// Gives each of `settings` to those that it means, as make_configs does, and reads all of them.
void apply_settings(const std::vector<std::string>& settings, std::vector<MethodConfig>& configs);

/// Gives the truth's crease angle to the configurations that have it as their own: whose parameter
/// `crease_deg` is 40 by default, as the truth's is, and which nobody set.
void follow_crease(double crease_deg, std::vector<MethodConfig>& configs);

/// Whether a method of the registry looks once per pixel at the surface, so that `sampled` is what
/// it may hope for; false for those that draw edges or hulls, and for names that the registry does
/// not know.
[[nodiscard]] bool takes_one_sample(const std::string& method);

/// The configurations that a comma list of methods, some settings and some preset files name; an
/// empty list is every method.
///
/// A setting is `key=value` (for every method that knows the key) or `method.key=value`. Throws
/// core::Error for an unknown method, a method named twice, a key that nobody knows, a bad value.
[[nodiscard]] std::vector<MethodConfig> make_configs(const std::string& methods,
                                                     const std::vector<std::string>& settings,
                                                     const std::vector<std::string>& presets = {});

}  // namespace ink::harness
