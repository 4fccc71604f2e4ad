#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace ink::import {

/// A camera in a Collada file, once for each node that has it.
struct DaeCamera {
    std::string node;  ///< its node's id, or sid without one: as Assimp names nodes
    bool is_parallel = false;
    std::optional<double> xmag{};  ///< half of what is seen, in the file's unit
    std::optional<double> ymag{};
    std::optional<double> xfov_deg{};
    std::optional<double> yfov_deg{};
    std::optional<double> aspect{};

    /// The vertical angle, if the file tells: yfov as it is, xfov by the aspect.
    [[nodiscard]] std::optional<double> fov_y_rad() const;
    /// What a parallel one sees, in the same way; 2 if the file does not tell.
    [[nodiscard]] double height() const;
};

/// The cameras in a Collada document, in the order of its nodes.
///
/// Needed because Assimp takes an orthographic camera for one of perspective, and xfov for the
/// whole truth where yfov stands beside it.
[[nodiscard]] std::vector<DaeCamera> dae_cameras(const pugi::xml_node& root);

}  // namespace ink::import
