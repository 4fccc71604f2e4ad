#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.h"
#include "harness/cells/cell.h"
#include "method/method.h"
#include "tests/scene/small_meshes.h"

namespace ink::harness {

/// What a made-up method is to do, and what it was asked.
struct Script {
    raster::SkipCounts counts = {};       ///< reported for skips that are allowed
    std::string failure_to_prepare{};     ///< thrown by prepare unless empty
    std::string failure{};                ///< thrown by draw unless empty
    std::function<void()> on_draw{};      ///< called before every drawing, where there is one
    std::uint8_t edge_response = 200;     ///< of its one pixel, at (1, 1)
    std::vector<method::Frame> frames{};  ///< those that it drew
};

/// A method made for a test, which does what its script says.
class MadeUpMethod final : public method::Method {
  public:
    explicit MadeUpMethod(Script& script) : script_(script) {}
    void prepare(const scene::PreparedScene&) override {
        if (!script_.failure_to_prepare.empty())
            throw core::Error("puppet", script_.failure_to_prepare);
    }
    void pose(const scene::PreparedScene&) override {}
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        if (!script_.failure.empty()) throw std::runtime_error(script_.failure);
        if (script_.on_draw) script_.on_draw();
        script_.frames.push_back(frame);
        out.fill(0);
        out.at(1, 1) = script_.edge_response;
    }
    int bytes_per_px() const override { return 1; }
    raster::SkipCounts skip_counts() const override {
        raster::SkipCounts counts = script_.counts;
        for (const raster::SkipInfo& info : raster::skip_infos()) {
            if (script_.frames.empty() || !script_.frames.back().skips.has(info.skip))
                counts[static_cast<std::size_t>(info.skip)].skipped = 0;
        }
        return counts;
    }

  private:
    Script& script_;
};

inline method::MethodInfo made_up_info(Script& script) {
    method::MethodInfo info;
    info.name = "puppet";
    info.params.emplace_back().name = "range_nx";
    info.make = [&script](const core::ParamValues&) {
        return std::make_unique<MadeUpMethod>(script);
    };
    info.complete = [](const core::ParamValues& values) {
        core::ParamValues all = {{"range_nx", "85"}, {"threshold", "100"}};
        for (const auto& [key, value] : values)
            all[key] = value;
        return all;
    };
    return info;
}

/// A cube in 8 by 8 pixels.
struct SmallCube {
    scene::Scene scene = scene::scene_of(scene::unit_cube());
    scene::View view{scene::orbit_cameras(scene::bounding_sphere(scene), 1, 1).front(), 8, 8};
};

/// The row of a method that draws the cube as `script` says, with its times and skips.
inline Row timed(Script& script, const MeasureOptions& options) {
    const method::MethodInfo info = made_up_info(script);
    const method::MethodConfig config{&info, {}};
    const SmallCube cube;
    const PreparedMethods methods = prepare_methods(std::span(&config, 1), cube.scene);
    std::vector<edge::EdgeImage> images;
    const DrawTimes times = draw_in_turns(methods, cube.view, options, images).front();
    Row row = methods[0]->row();
    fill_times(times, row);
    fill_skips(times, options.skips, row);
    return row;
}

/// Counts: 10 times (i + 1) skipped of 100 for skip i.
inline raster::SkipCounts made_up_counts() {
    raster::SkipCounts counts;
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] = {10 * (i + 1), 100};
    return counts;
}

}  // namespace ink::harness
