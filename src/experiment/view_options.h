#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/suite/suite.h"

namespace ink::experiment {

inline constexpr double kFov_deg = 40;  ///< of a camera that is set by hand

/// The options by which every command, and Python, says which views it means, as text until
/// `view_request` reads them.
struct ViewOptions {
    std::string size = "1280x720";
    std::string views;  ///< a number, "file", or names of scene::drawing_views()
    std::vector<std::string> eyes;
    std::vector<std::string> targets;
    std::optional<std::string> up;  ///< of eyes, a point; of views by name, x, y or z
    std::optional<double> fov_deg;  ///< only with eyes
    std::string projection;  ///< of all views: "", "perspective", "parallel" or both, by commas
    std::optional<double> parallel_height;  ///< of parallel views, world units
    std::optional<double> time_s;
    std::optional<int> frame;
    std::string fit;  ///< "", "sphere" or "box"
    std::optional<double> margin;
    std::vector<std::string> objects;
    std::string animation;
    std::string seams = "objects";
};

/// What the options ask for. Throws core::Error (where = the option) for text that means nothing.
[[nodiscard]] harness::ViewRequest view_request(const ViewOptions& options);

}  // namespace ink::experiment
