#pragma once

#include "buffers/id_pass.h"

namespace ink::methods {

/// Borders between surface ids, and steps of depth within one id: what outline passes of engines
/// and of three.js draw where they have an id buffer.
class IdsDepth : public method::Method {
  public:
    struct Params : buffers::IdParams {
        buffers::BorderSide side = buffers::BorderSide::nearer;
        double depth_step = 0.05;  // found: see the page
        int threshold = 128;       ///< it draws 0 and 255 alone
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit IdsDepth(const Params& params);

    void prepare(const scene::Scene& scene) override { ids_.prepare(scene); }
    [[nodiscard]] bool prepare_like(const method::Method& other,
                                    const scene::Scene& scene) override {
        const auto* same = dynamic_cast<const IdsDepth*>(&other);
        return same != nullptr && ids_.prepare_like(same->ids_, scene);
    }
    void pose(const scene::Scene& scene) override { ids_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `ids`, see IdPass.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return {ids_.layer(frame)};
    }
    [[nodiscard]] int bytes_per_px() const override { return ids_.format().bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    Params params_;
    buffers::IdPass ids_;
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo ids_depth();

}  // namespace ink::methods
