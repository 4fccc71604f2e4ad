#pragma once

#include "buffers/id_method.h"
#include "core/image.h"

namespace ink::methods {

/// The mask of all objects, widened by a blur: what engines draw round a selected object.
class BlurredSilhouette : public buffers::IdMethod {
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

    /// `mask`: 255 where an object is, before the blur.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    [[nodiscard]] int bytes_per_px() const override;
    [[nodiscard]] method::Cost cost() const override;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override;
    /// Draws the mask, with its outermost pixels repeated round it. Returns what was skipped.
    raster::SkipCounts draw_mask(const method::Frame& frame, int width_px, int height_px);

    Params params_;
    core::Image<std::uint8_t> mask_;     ///< one pixel larger than the frame on every side
    core::Image<std::uint8_t> blurred_;  ///< as large
    core::Image<std::uint8_t> scratch_;  ///< as large
};

[[nodiscard]] method::MethodInfo blurred_silhouette();

}  // namespace ink::methods
