#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "method/method.h"

namespace ink::harness {

/// What a made-up method is to do, and what it was asked.
struct SkipScript {
    raster::SkipCounts counts = {};  ///< reported for skips that are allowed
    std::string failure = {};        ///< thrown by draw unless empty
    std::vector<method::Frame> frames = {};
};

/// A method made for a test: one pixel, and counts as they stand in its script.
class SkippingMethod final : public method::Method {
  public:
    explicit SkippingMethod(SkipScript& script) : script_(script) {}
    void prepare(const scene::PreparedScene&) override {}
    void pose(const scene::PreparedScene&) override {}
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        if (!script_.failure.empty()) throw std::runtime_error(script_.failure);
        script_.frames.push_back(frame);
        out.fill(0);
        out.at(1, 1) = 200;
        last_ = frame.skips;
    }
    int bytes_per_px() const override { return 1; }
    raster::SkipCounts skip_counts() const override {
        raster::SkipCounts counts = script_.counts;
        for (const raster::SkipInfo& info : raster::skip_infos()) {
            if (!last_.has(info.skip)) counts[static_cast<std::size_t>(info.skip)].skipped = 0;
        }
        return counts;
    }

  private:
    SkipScript& script_;
    raster::SkipSet last_ = raster::SkipSet::none();
};

inline method::MethodInfo skipping_info(SkipScript& script) {
    method::MethodInfo info;
    info.name = "puppet";
    info.params.emplace_back().name = "range_nx";
    info.make = [&script](const core::ParamValues&) {
        return std::make_unique<SkippingMethod>(script);
    };
    info.complete = [](const core::ParamValues& values) {
        core::ParamValues all = {{"range_nx", "85"}, {"threshold", "100"}};
        for (const auto& [key, value] : values)
            all[key] = value;
        return all;
    };
    return info;
}

/// Counts: 10 times (i + 1) skipped of 100 for skip i.
inline raster::SkipCounts made_up_counts() {
    raster::SkipCounts counts;
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] = {10 * (i + 1), 100};
    return counts;
}

}  // namespace ink::harness
