#include "import/assimp/dae_cameras.h"

#include <cmath>
#include <numbers>

#include "core/parse_number.h"
#include "import/xml.h"

namespace ink::import {
namespace {

using Element = pugi::xml_node;

std::optional<double> number_in(const Element& element) {
    const auto words = words_of(element.text().get());
    return words.empty() ? std::nullopt : core::parse_number<double>(words[0]);
}

/// The camera of a file whose id a node names; nothing for one of another file.
Element camera_of(const Element& root, std::string_view url) {
    for (const Element& camera : elements(root, "camera"))
        if (url.starts_with('#') && url.substr(1) == camera.attribute("id").value()) return camera;
    return {};
}

}  // namespace

std::vector<DaeCamera> dae_cameras(const Element& root) {
    std::vector<DaeCamera> cameras;
    for (const Element& use : elements(root, "instance_camera")) {
        const Element found = camera_of(root, use.attribute("url").value());
        const Element common = found.child("optics").child("technique_common");
        const Element parallel = common.child("orthographic");
        const Element optics = parallel ? parallel : common.child("perspective");
        if (!found) continue;
        const Element node = use.parent();
        const std::string id = node.attribute("id").value();
        cameras.push_back({.node = id.empty() ? node.attribute("sid").value() : id,
                           .is_parallel = static_cast<bool>(parallel),
                           .xmag = number_in(optics.child("xmag")),
                           .ymag = number_in(optics.child("ymag")),
                           .xfov_deg = number_in(optics.child("xfov")),
                           .yfov_deg = number_in(optics.child("yfov")),
                           .aspect = number_in(optics.child("aspect_ratio"))});
    }
    return cameras;
}

double DaeCamera::height() const {
    if (ymag) return 2 * *ymag;
    const double half_width = xmag.value_or(1);
    return 2 * (aspect && *aspect > 0 ? half_width / *aspect : half_width);
}

std::optional<double> DaeCamera::fov_y_rad() const {
    constexpr double kRadPerDeg = std::numbers::pi / 180;
    if (yfov_deg) return *yfov_deg * kRadPerDeg;
    if (!xfov_deg || !aspect || !(*aspect > 0)) return std::nullopt;
    return 2 * std::atan(std::tan(*xfov_deg / 2 * kRadPerDeg) / *aspect);
}

}  // namespace ink::import
