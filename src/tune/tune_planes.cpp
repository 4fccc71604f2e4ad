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
std::optional<method::LinearCode> code_of(const harness::Entrant& entrant) {
    if (entrant.info->is_planned) return std::nullopt;
    return entrant.info->make(entrant.settings)->code();
}

/// What planes hang on.
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

/// The key at an end of a knob's range; "" if there is no code there.
std::string key_at(harness::Entrant entrant, const TunedKnob& knob, double value) {
    entrant.settings[knob.param.name] = core::format_param(knob.param, value);
    const auto code = code_of(entrant);
    return code ? inputs_key(*code) : "";
}

}  // namespace

void TunePlanes::add_view(std::size_t subject,
                          const scene::View& view,
                          core::Image<std::uint32_t> triangle) {
    views_.push_back({subject, view, std::move(triangle)});
}

std::size_t TunePlanes::set_bytes() const {
    std::size_t pixels = 0;
    for (const Seen& seen : views_)
        pixels += seen.triangle.size();
    return pixels * kBytesPerPixel;
}

bool TunePlanes::can_draw(const harness::Entrant& entrant) const {
    return set_bytes() <= kMostBytes && code_of(entrant).has_value();
}

bool TunePlanes::can_search(const harness::Entrant& entrant, const TuneSpace& space) const {
    return can_draw(entrant) &&
           std::all_of(space.knobs().begin(), space.knobs().end(), [&](const TunedKnob& knob) {
               const bool is_number = knob.param.kind == core::ParamKind::real ||
                                      knob.param.kind == core::ParamKind::integer;
               return !is_number ||
                      key_at(entrant, knob, knob.low) == key_at(entrant, knob, knob.high);
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
    core::parallel_for(subjects_.size(), threads, [&](std::size_t s) {
        const linear_code::ChannelSource source(subjects_[s].scene, code);
        for (std::size_t i = 0; i < views_.size(); ++i) {
            if (views_[i].subject != s) continue;
            set.views[i] = source.planes(views_[i].view, views_[i].triangle, 1);
        }
    });
    kept_.push_back(std::move(set));
    return kept_.back();
}

std::vector<edge::EdgeImage> TunePlanes::pictures(const harness::Entrant& entrant, int threads) {
    const auto code = code_of(entrant);
    assert(code);
    const PlaneSet& set = planes_of(*code, threads);
    std::vector<edge::EdgeImage> pictures(views_.size());
    core::parallel_for(views_.size(), threads, [&](std::size_t i) {
        pictures[i] = linear_code::strengths_of(set.views[i], *code, 1);
    });
    return pictures;
}

}  // namespace ink::tune
