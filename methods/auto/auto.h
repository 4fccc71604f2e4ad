#pragma once

#include <cstdint>
#include <memory>

#include "buffers/packed_buffer.h"
#include "methods/auto/auto_plan.h"

namespace ink::methods {

/// A packed buffer whose code is planned from the scene's statistics: which channels, how many
/// bytes, which step is a line. It leaves channels out, so its image is its own.
class Auto : public method::Method {
  public:
    struct Params : PlanWishes {
        double crease_deg = 40;
        raster::Interpolation interpolation = raster::Interpolation::affine;
        raster::DepthFormat depth_format = raster::DepthFormat::q32;
        edge::Response response = edge::Response::absolute;
        // found: experiments/thresholds.py, over the training scenes at 1280x720
        int threshold = kPlannedResponse;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Auto(const Params& params);

    void prepare(const scene::Scene& scene) override;
    /// Plans anew if anything moved: where components stand is part of the plan.
    void pose(const scene::Scene& scene) override;
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        buffer_->draw(frame, out);
    }
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return buffer_->layers(frame);
    }
    [[nodiscard]] int bytes_per_px() const override { return buffer_->bytes_per_px(); }
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return buffer_->skip_counts(); }
    [[nodiscard]] method::Cost cost() const override { return buffer_->cost(); }
    [[nodiscard]] std::optional<method::LinearCode> code() const override {
        return buffer_->code();
    }
    [[nodiscard]] std::vector<method::PlanLine> plan() const override { return plan_.lines; }

  private:
    void replan(const scene::Scene& scene);

    Params params_;
    CodePlan plan_;
    std::unique_ptr<buffers::PackedBuffer> buffer_;
    std::uint64_t planned_hash_ = 0;
};

/// `auto` is a word of the language.
[[nodiscard]] method::MethodInfo auto_method();

}  // namespace ink::methods
