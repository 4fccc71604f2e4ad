// The outline round a selected object: its mask, blurred, less itself.

#include "methods/blurred_silhouette/blurred_silhouette.h"

#include <algorithm>
#include <utility>

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

/// Writes 255 where an object is into the inside of a mask that holds 0.
class MaskSink : public raster::TileSink {
  public:
    explicit MaskSink(Mask& mask) : mask_(mask) {}

    void finish(const raster::Tile& tile) override {
        if (tile.is_empty) return;
        for (int y = 0; y < tile.height_px; ++y) {
            const auto* id = tile.row<std::uint32_t>(0, y);
            std::uint8_t* to = mask_.row(tile.y0_px + y + 1) + tile.x0_px + 1;
            for (int x = 0; x < tile.width_px; ++x)
                to[x] = id[x] != buffers::kNoId ? 255 : 0;
        }
    }

  private:
    Mask& mask_;
};

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        {{"threshold", "120"}},
        {},
        {{"threshold", "32"}},
        {{"side", "both"}},
        {{"side", "both"}, {"threshold", "120"}},
        // Wider, as a selected object is shown.
        {{"rounds", "2"}},
        {{"rounds", "4"}},
        {{"rounds", "8"}},
        {{"rounds", "8"}, {"threshold", "20"}},
    };
}

buffers::IdParams mask_params() {
    buffers::IdParams params;
    params.of = buffers::IdSource::object;
    params.depth_format = raster::DepthFormat::z16;  // who is nearer does not matter here
    return params;
}

}  // namespace

core::ParamTable<BlurredSilhouette::Params> BlurredSilhouette::table() {
    core::ParamTable<Params> table;
    return table
        .choice(&Params::side,
                "side",
                {"outside", "both"},
                "Where the line lies: outside the mask alone, or on both sides of its border.")
        .number(&Params::rounds,
                "rounds",
                {1, 64},
                "",
                "How often the 3 x 3 blur is repeated: the line reaches that many pixels at most.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Least edge response of a line pixel: twice the blurred mask.");
}

BlurredSilhouette::BlurredSilhouette(const Params& params)
    : buffers::IdMethod(mask_params(), 0), params_(params) {}

raster::SkipCounts BlurredSilhouette::draw_mask(const method::Frame& frame,
                                                int width_px,
                                                int height_px) {
    if (mask_.width_px() != width_px + 2 || mask_.height_px() != height_px + 2) {
        mask_ = Mask(width_px + 2, height_px + 2);
        blurred_ = mask_;
        scratch_ = mask_;
    }
    mask_.fill(0);
    MaskSink sink(mask_);
    // A line reaches into tiles where nothing moved: all are drawn.
    const raster::SkipCounts skips = pass().draw(frame, false, sink).skips;
    repeat_outermost(mask_);
    return skips;
}

raster::SkipCounts BlurredSilhouette::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
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

std::vector<method::Layer> BlurredSilhouette::layers(const method::Frame& frame) {
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

int BlurredSilhouette::bytes_per_px() const {
    return pass().format().bytes_per_px() + 3;
}

method::Cost BlurredSilhouette::cost() const {
    method::Cost cost = pass().cost();
    cost.buffer_bytes_per_px = bytes_per_px();
    // Whether there is an object.
    const method::PixelWork mask{sizeof(std::uint32_t), 1, 2};
    // Three sums of three with two doublings each way, rounded, scaled, to a byte.
    const method::PixelWork blur{1, 1, 2 * 3 + 3};
    // A choice, doubled, cut, to a byte.
    const method::PixelWork line{2, 1, 4};
    cost.filter = mask + params_.rounds * blur + line;
    return cost;
}

method::MethodInfo blurred_silhouette() {
    method::MethodInfo info = method::method_info<BlurredSilhouette>(
        "blurred_silhouette",
        "selection outlines of engines and editors: the object's mask, blurred, less itself",
        "the mask of all objects, widened by a blur");
    info.family = method::Family::ids;
    info.marker = method::Marker::plus;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
