#include "inspect/optimisations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace ink::inspect {
namespace {

using method::LinearCode;

constexpr std::array<const char*, 4> kChannels = {"depth", "nx", "ny", "nz"};

/// A loose triangle's normal is its own: what it tells is where triangles end, not where lines are.
constexpr double kMostlyLoose = 0.5;

bool has_weight(const LinearCode& code, std::size_t channel) {
    return (channel == 0 ? code.depth_weight : code.normal_weight[channel - 1]) != 0;
}

Optimisation omit_channel(const LinearCode& code,
                          const scene::SceneStatistics& statistics,
                          std::size_t channel) {
    const std::string name = kChannels[channel];
    if (!has_weight(code, channel)) return {name, true, "the code gives it no weight"};
    if (channel == 0) return {name, false, "steps of depth are the outlines"};
    if (statistics.loose_share() > kMostlyLoose) {
        return {name, true, "most triangles are loose: their normals show facets, not lines"};
    }
    if (statistics.has_creases()) {
        return {name,
                false,
                fmt::format("{} edges are creases",
                            statistics.creases.count + statistics.nonmanifold.count)};
    }
    if (statistics.may_cross()) {
        return {name,
                false,
                fmt::format("{} pairs of components may cross each other",
                            statistics.overlapping_components)};
    }
    return {
        name, true, "there are neither creases nor crossings, so normals add no line of their own"};
}

/// Why a plane can have a response, or "" if its |L| <= 2 is sure to be clipped.
std::string against_flatness(const std::optional<LinearCode>& code) {
    if (!code) return "it declares no single linear code";
    const bool is_affine = code->inputs.interpolation == raster::Interpolation::affine;
    if (!is_affine) return "refused: its code is not linear on the screen";
    if (!code->inputs.at_vertices) return "refused: its code is summed at pixels";
    if (code->response.response == edge::Response::wrap) {
        return "refused: response = wrap turns a small negative L into a strong line";
    }
    if (code->response.clip_bits < 2) {
        return fmt::format("refused: clip_bits = {}, and a plane's code may respond with up to 2",
                           code->response.clip_bits);
    }
    return "";
}

Optimisation omit_attributes(const std::optional<LinearCode>& code) {
    const std::string name = "attributes";
    if (!code) return {name, false, "it declares no single linear code"};
    std::string unread;
    for (std::size_t i = 0; i < kChannels.size(); ++i) {
        if (!has_weight(*code, i))
            unread += (unread.empty() ? "" : ", ") + std::string(kChannels[i]);
    }
    if (unread.empty()) return {name, false, "its code reads all four channels"};
    return {name, true, "its code does not read " + unread};
}

Optimisation omit_flat(std::string name, const std::optional<LinearCode>& code) {
    const std::string objection = against_flatness(code);
    if (!objection.empty()) return {std::move(name), false, objection};
    return {std::move(name),
            true,
            fmt::format("clip_bits = {}: within a plane |L| <= 2 is cleared",
                        code->response.clip_bits)};
}

Optimisation cull_back_faces(const SceneFacts& facts) {
    const std::string name = "back_face_culling";
    if (facts.watertight_solids == 0) {
        return {name, false, "no solid is closed and turned outwards: back faces may be visible"};
    }
    return {name,
            true,
            fmt::format("{} of {} solids are watertight, but for holes perhaps: seen from "
                        "outside, their front faces hide their back faces",
                        facts.watertight_solids,
                        facts.solids)};
}

Optimisation cull_occluded(const scene::SceneStatistics& statistics) {
    if (statistics.may_hide())
        return {"occlusion_culling", true, "parts of the scene may hide others"};
    return {"occlusion_culling", true, "one convex component hides nothing but its own back"};
}

Optimisation omit_no_sample(const std::vector<scene::ViewStatistics>& views) {
    double least = std::numeric_limits<double>::infinity();
    for (const scene::ViewStatistics& view : views)
        least = std::min(least, view.px_per_triangle);
    return {"no_sample",
            true,
            views.empty() ? "a triangle between pixel centres draws nothing"
                          : fmt::format("triangles of down to {:.3g} pixels on average", least)};
}

Optimisation omit_frustum(const std::vector<scene::ViewStatistics>& views) {
    const auto inside =
        std::count_if(views.begin(), views.end(), [](const auto& view) { return view.is_inside; });
    return {"frustum_culling",
            true,
            fmt::format("what lies outside the image draws nothing; the eye is within the scene "
                        "in {} of {} views",
                        inside,
                        views.size())};
}

Optimisation omit_empty_tiles(const std::vector<scene::ViewStatistics>& views) {
    double least = 1;
    for (const scene::ViewStatistics& view : views)
        least = std::min(least, view.frame_share);
    return {"empty_tiles",
            true,
            fmt::format("the sky has no line; up to {:.0f} % of the image is outside the scene's "
                        "bounding sphere",
                        100 * (1 - least))};
}

Optimisation omit(const raster::SkipInfo& info,
                  const std::optional<LinearCode>& code,
                  const SceneFacts& facts) {
    using raster::Skip;
    switch (info.skip) {
        case Skip::attributes:
            return omit_attributes(code);
        case Skip::frustum_culling:
            return omit_frustum(facts.views);
        case Skip::back_face_culling:
            return cull_back_faces(facts);
        case Skip::no_sample:
            return omit_no_sample(facts.views);
        case Skip::occlusion_culling:
            return cull_occluded(facts.statistics);
        case Skip::empty_tiles:
            return omit_empty_tiles(facts.views);
        case Skip::flat_tiles:
            return omit_flat(std::string(info.name), code);
        case Skip::temporal_reuse:
            break;
    }
    return {std::string(info.name), true, "in a sequence, where neither camera nor scene moved"};
}

}  // namespace

std::vector<Optimisation> channel_optimisations(const std::optional<LinearCode>& code,
                                                const scene::SceneStatistics& statistics) {
    std::vector<Optimisation> channels;
    for (std::size_t i = 0; code && i < kChannels.size(); ++i)
        channels.push_back(omit_channel(*code, statistics, i));
    return channels;
}

std::vector<Optimisation> skip_optimisations(const std::optional<LinearCode>& code,
                                             const SceneFacts& facts) {
    std::vector<Optimisation> skips;
    for (const raster::SkipInfo& info : raster::skip_infos())
        skips.push_back(omit(info, code, facts));
    return skips;
}

}  // namespace ink::inspect
