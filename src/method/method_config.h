#pragma once

#include <memory>
#include <string>

#include "core/param.h"
#include "method/method.h"

namespace ink::method {

/// A method as it takes part: which, and with which settings.
struct MethodConfig {
    const MethodInfo* info = nullptr;
    core::ParamValues settings;  ///< what the user set; the rest is default
    /// Keeps `info` where it is a row of no registry, but a preset of the user's.
    std::shared_ptr<const MethodInfo> owned = nullptr;
    bool is_outside = false;  ///< its images and times come from elsewhere (OutsideMethod)
    bool is_grey = false;     ///< its edge responses are shares of pixels, not strengths
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

/// The edge response (1..255) from which a pixel of `config` counts as drawn.
[[nodiscard]] int threshold_of(const MethodConfig& config);

/// The configuration but for the threshold that only says which pixels are scored: where it is the
/// same, so are images and times.
[[nodiscard]] core::ParamValues drawn_settings(const MethodConfig& config);

}  // namespace ink::method
