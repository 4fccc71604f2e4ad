// Selection outlines of engines and editors: the mask of all objects, blurred, less itself,
//
//     edge response = min(255, 2 blurred) where the mask is 0

#include <algorithm>
#include <utility>

#include "buffers/each_tile.h"
#include "buffers/id_pass.h"
#include "core/image.h"
#include "edge/binomial_blur.h"

namespace ink::methods {
namespace {

using Mask = core::Image<std::uint8_t>;

/// The pixels of a mask without the ring round them.
core::ImageView<std::uint8_t> inside(Mask& mask) {
    return {mask.row(1) + 1, mask.width_px() - 2, mask.height_px() - 2, mask.width_px()};
}

/// Repeats the outermost pixels of the inside in the ring: a frame cuts objects off, it is no
/// border of theirs.
void repeat_outermost(Mask& mask) {
    const int right = mask.width_px() - 1;
    const int bottom = mask.height_px() - 1;
    for (int y = 1; y < bottom; ++y) {
        mask.at(0, y) = mask.at(1, y);
        mask.at(right, y) = mask.at(right - 1, y);
    }
    std::copy_n(mask.row(1), mask.width_px(), mask.row(0));
    std::copy_n(mask.row(bottom - 1), mask.width_px(), mask.row(bottom));
}

buffers::IdParams mask_params() {
    buffers::IdParams params;
    params.of = buffers::IdSource::object;
    params.depth_format = raster::DepthFormat::z16;  // who is nearer does not matter here
    return params;
}

enum class Side {
    outside,  ///< the blur's share beyond the mask alone
    both,     ///< both sides of the mask's border
};

class BlurredSilhouette : public buffers::IdMethod {
  public:
    struct Params {
        Side side = Side::outside;
        int rounds = 1;
        int threshold = 64;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table
            .choice(&Params::side,
                    "side",
                    {"outside", "both"},
                    "Where the line lies: outside the mask alone, or on both sides of its border.")
            .number(
                &Params::rounds,
                "rounds",
                {1, 64},
                "",
                "How often the 3 x 3 blur is repeated: the line reaches that many pixels at most.");
        return method::add_threshold(
            table, "Least edge response of a line pixel: twice the blurred mask.");
    }
    explicit BlurredSilhouette(const Params& params)
        : IdMethod(mask_params(), 0), params_(params) {}

    /// `mask`: 255 where an object is, before the blur.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        const int width_px = frame.view.width_px;
        const int height_px = frame.view.height_px;
        method::Layer layer{"mask", core::Image<glm::u8vec3>(width_px, height_px)};
        if (pass().is_empty() || layer.rgb.is_empty()) return {std::move(layer)};
        (void)draw_mask(frame, width_px, height_px);
        for (int y = 0; y < height_px; ++y) {
            for (int x = 0; x < width_px; ++x)
                layer.rgb.at(x, y) = glm::u8vec3(inside(mask_).row(y)[x]);
        }
        return {std::move(layer)};
    }
    [[nodiscard]] int bytes_per_px() const override { return IdMethod::bytes_per_px() + 3; }

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override {
        const raster::SkipCounts skips = draw_mask(frame, out.width_px(), out.height_px());
        edge::binomial_blur(inside(mask_), inside(blurred_), 0, frame.threads);
        for (int round = 1; round < params_.rounds; ++round) {
            repeat_outermost(blurred_);
            edge::binomial_blur(inside(blurred_), inside(scratch_), 0, frame.threads);
            std::swap(blurred_, scratch_);
        }
        const core::ImageView<std::uint8_t> mask = inside(mask_);
        const core::ImageView<std::uint8_t> blurred = inside(blurred_);
        for (int y = 0; y < out.height_px(); ++y) {
            std::uint8_t* to = out.row(y);
            for (int x = 0; x < out.width_px(); ++x) {
                const int outside = blurred.row(y)[x];
                const int share = mask.row(y)[x] == 0          ? outside
                                  : params_.side == Side::both ? 255 - outside
                                                               : 0;
                to[x] = static_cast<std::uint8_t>(std::min(2 * share, 255));
            }
        }
        return skips;
    }
    /// Draws the mask, with its outermost pixels repeated round it. Returns what was skipped.
    raster::SkipCounts draw_mask(const method::Frame& frame, int width_px, int height_px) {
        if (mask_.width_px() != width_px + 2 || mask_.height_px() != height_px + 2) {
            mask_ = Mask(width_px + 2, height_px + 2);
            blurred_ = mask_;
            scratch_ = mask_;
        }
        mask_.fill(0);
        buffers::EachTile sink([&](const raster::Tile& tile) {
            for (int y = 0; y < tile.height_px && !tile.is_empty; ++y) {
                const auto* id = tile.row<std::uint32_t>(0, y);
                std::uint8_t* to = mask_.row(tile.y0_px + y + 1) + tile.x0_px + 1;
                for (int x = 0; x < tile.width_px; ++x)
                    to[x] = id[x] != buffers::kNoId ? 255 : 0;
            }
        });
        // A line reaches into tiles where nothing moved: all are drawn.
        const raster::SkipCounts skips = pass().draw(frame, false, sink).skips;
        repeat_outermost(mask_);
        return skips;
    }
    /// The mask from ids, a copy for every blur, and the line from both.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        return method::PixelBytes{4 + 2, 1 + 1} + params_.rounds * method::PixelBytes{1, 1};
    }

    Params params_;
    core::Image<std::uint8_t> mask_;     ///< one pixel larger than the frame on every side
    core::Image<std::uint8_t> blurred_;  ///< as large
    core::Image<std::uint8_t> scratch_;  ///< as large
};

}  // namespace

method::MethodInfo blurred_silhouette_method() {
    return method::method_info<BlurredSilhouette>("blurred_silhouette");
}

}  // namespace ink::methods
