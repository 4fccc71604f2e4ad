#pragma once

#include "buffers/id_pass.h"
#include "core/image.h"

namespace ink::methods {

/// The mask of all objects, widened by a blur: what engines draw round a selected object.
class BlurredSilhouette : public method::Method {
  public:
    enum class Side {
        outside,  ///< the blur's share beyond the mask alone
        both,     ///< both sides of the mask's border
    };
    struct Params {
        Side side = Side::outside;
        int rounds = 1;
        int threshold = 64;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit BlurredSilhouette(const Params& params);

    void prepare(const scene::Scene& scene) override { ids_.prepare(scene); }
    [[nodiscard]] bool prepare_like(const method::Method& other,
                                    const scene::Scene& scene) override {
        const auto* same = dynamic_cast<const BlurredSilhouette*>(&other);
        return same != nullptr && ids_.prepare_like(same->ids_, scene);
    }
    void pose(const scene::Scene& scene) override { ids_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `mask`: 255 where an object is, before the blur.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    [[nodiscard]] int bytes_per_px() const override;
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    /// Draws the mask, with its outermost pixels repeated round it.
    void draw_mask(const method::Frame& frame, int width_px, int height_px);

    Params params_;
    buffers::IdPass ids_;
    core::Image<std::uint8_t> mask_;     ///< one pixel larger than the frame on every side
    core::Image<std::uint8_t> blurred_;  ///< as large
    core::Image<std::uint8_t> scratch_;  ///< as large
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo blurred_silhouette();

}  // namespace ink::methods
