#include "tune/tune_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>

#include "core/parallel.h"

namespace ink::tune {
namespace {

/// Of all sets that are kept, and of one.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;
constexpr std::size_t kBytesPerPixel = 4 * sizeof(float) + 1;

/// The code of these settings, if every scene has the same.
std::optional<method::LinearCode> code_of(const harness::MethodConfig& config) {
    if (config.info->is_planned) return std::nullopt;
    return config.info->make(config.settings)->code();
}

/// What planes depend on.
std::string inputs_key(const method::LinearCode& code) {
    const method::CodeInputs& in = code.inputs;
    return fmt::format("{} {} {} {} {} {} {}",
                       static_cast<int>(code.encoding),
                       static_cast<int>(in.normals),
                       in.crease_rad,
                       static_cast<int>(in.depth_range),
                       static_cast<int>(in.interpolation),
                       in.at_vertices,
                       in.renormalise);
}

/// The key at an end of a parameter's range; "" if there is no code there.
std::string key_at(harness::MethodConfig config, const TunedParameter& parameter, double value) {
    config.settings[parameter.param.name] = core::format_param(parameter.param, value);
    const auto code = code_of(config);
    return code ? inputs_key(*code) : "";
}

}  // namespace

void TunePlanes::add_view(std::size_t scene_index,
                          const scene::View& view,
                          core::Image<std::uint32_t> triangle) {
    views_.push_back({scene_index, view, std::move(triangle)});
}

std::size_t TunePlanes::set_bytes() const {
    std::size_t pixels = 0;
    for (const Seen& seen : views_)
        pixels += seen.triangle.size();
    return pixels * kBytesPerPixel;
}

bool TunePlanes::can_draw(const harness::MethodConfig& config) const {
    return set_bytes() <= kMostBytes && code_of(config).has_value();
}

bool TunePlanes::can_search(const harness::MethodConfig& config, const TuneSpace& space) const {
    return can_draw(config) && std::all_of(space.parameters().begin(),
                                           space.parameters().end(),
                                           [&](const TunedParameter& parameter) {
                                               return !parameter.param.is_number() ||
                                                      key_at(config, parameter, parameter.low) ==
                                                          key_at(config, parameter, parameter.high);
                                           });
}

const TunePlanes::PlaneSet& TunePlanes::planes_of(const method::LinearCode& code, int threads) {
    const std::string key = inputs_key(code);
    const auto found = std::find_if(
        kept_.begin(), kept_.end(), [&](const PlaneSet& set) { return set.key == key; });
    if (found != kept_.end()) {
        std::rotate(found, found + 1, kept_.end());
        return kept_.back();
    }
    while (!kept_.empty() && (kept_.size() + 1) * set_bytes() > kMostBytes)
        kept_.erase(kept_.begin());
    PlaneSet set{key, std::vector<linear_code::ChannelPlanes>(views_.size())};
    core::parallel_for(scenes_.size(), threads, [&](std::size_t s) {
        const linear_code::ChannelSource source(scenes_[s].scene, code);
        for (std::size_t i = 0; i < views_.size(); ++i) {
            if (views_[i].scene_index != s) continue;
            set.views[i] = source.planes(views_[i].view, views_[i].triangle, 1);
        }
    });
    kept_.push_back(std::move(set));
    return kept_.back();
}

std::vector<edge::EdgeImage> TunePlanes::images(const harness::MethodConfig& config, int threads) {
    const auto code = code_of(config);
    assert(code);
    const PlaneSet& set = planes_of(*code, threads);
    std::vector<edge::EdgeImage> images(views_.size());
    core::parallel_for(views_.size(), threads, [&](std::size_t i) {
        images[i] = linear_code::responses_of(set.views[i], *code, 1);
    });
    return images;
}

}  // namespace ink::tune
