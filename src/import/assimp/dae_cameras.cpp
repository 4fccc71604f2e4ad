#include "import/assimp/dae_cameras.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <system_error>
#include <utility>

namespace ink::import {
namespace {

/// Tags of an XML text, one after the other; comments and the like are passed over.
class XmlTags {
  public:
    explicit XmlTags(std::string_view text) : text_(text) {}

    /// Goes to the next tag; false where there is none.
    bool next() {
        while (true) {
            const std::size_t open = text_.find('<', at_);
            if (open == text_.npos) return false;
            before_ = text_.substr(at_, open - at_);
            const std::string_view from = text_.substr(open);
            const std::string_view mark = from.starts_with("<!--")        ? "-->"
                                          : from.starts_with("<![CDATA[") ? "]]>"
                                                                          : ">";
            const std::size_t close = text_.find(mark, open);
            if (close == text_.npos) return false;
            at_ = close + mark.size();
            if (from.starts_with("<?") || from.starts_with("<!")) continue;
            tag_ = text_.substr(open + 1, close - open - 1);
            return true;
        }
    }

    [[nodiscard]] bool is_end() const { return tag_.starts_with('/'); }
    [[nodiscard]] bool is_closed() const { return tag_.ends_with('/'); }
    [[nodiscard]] std::string_view name() const {
        const std::string_view tag = tag_.substr(is_end() ? 1 : 0);
        return tag.substr(0, std::min(tag.find_first_of(" \t\r\n/"), tag.size()));
    }
    /// The text between the tag before and this one.
    [[nodiscard]] std::string_view before() const { return before_; }

    [[nodiscard]] std::string attribute(std::string_view wanted) const {
        std::size_t at = name().size();
        while (true) {
            const std::size_t first = tag_.find_first_not_of(" \t\r\n", at);
            const std::size_t equals = tag_.find('=', at);
            const std::size_t open = tag_.find_first_of("\"'", at);
            if (first == tag_.npos || equals == tag_.npos || open == tag_.npos || open < equals)
                return {};
            const std::size_t close = tag_.find(tag_[open], open + 1);
            if (close == tag_.npos) return {};
            std::string_view found = tag_.substr(first, equals - first);
            found = found.substr(0, std::min(found.find_first_of(" \t\r\n"), found.size()));
            if (found == wanted) return std::string(tag_.substr(open + 1, close - open - 1));
            at = close + 1;
        }
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::string_view tag_;
    std::string_view before_;
};

std::optional<double> to_number(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n+"), text.size()));
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} ? std::optional(value) : std::nullopt;
}

/// What a camera is; the tags go on to its end.
DaeCamera read_optics(XmlTags& tags) {
    DaeCamera camera;
    while (tags.next() && !(tags.is_end() && tags.name() == "camera")) {
        const std::string_view name = tags.name();
        if (name == "orthographic") camera.is_parallel = true;
        if (!tags.is_end()) continue;
        if (name == "xmag") camera.xmag = to_number(tags.before());
        if (name == "ymag") camera.ymag = to_number(tags.before());
        if (name == "xfov") camera.xfov_deg = to_number(tags.before());
        if (name == "yfov") camera.yfov_deg = to_number(tags.before());
        if (name == "aspect_ratio") camera.aspect = to_number(tags.before());
    }
    return camera;
}

}  // namespace

std::vector<DaeCamera> read_dae_cameras(std::string_view file) {
    std::map<std::string, DaeCamera> by_id;
    std::vector<std::pair<std::string, std::string>> uses;  // nodes and their cameras' ids
    std::vector<std::string> nodes;                         // those that are open
    for (XmlTags tags(file); tags.next();) {
        const std::string_view name = tags.name();
        if (name == "node" && tags.is_end()) {
            if (!nodes.empty()) nodes.pop_back();
        } else if (name == "node" && !tags.is_closed()) {
            const std::string id = tags.attribute("id");
            nodes.push_back(id.empty() ? tags.attribute("sid") : id);
        } else if (name == "camera" && !tags.is_end() && !tags.is_closed()) {
            const std::string id = tags.attribute("id");
            by_id[id] = read_optics(tags);
        } else if (name == "instance_camera" && !tags.is_end() && !nodes.empty()) {
            const std::string url = tags.attribute("url");
            uses.emplace_back(nodes.back(), url.starts_with('#') ? url.substr(1) : url);
        }
    }
    std::vector<DaeCamera> cameras;
    for (const auto& [node, id] : uses) {
        const auto camera = by_id.find(id);
        if (camera == by_id.end()) continue;
        cameras.push_back(camera->second);
        cameras.back().node = node;
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
