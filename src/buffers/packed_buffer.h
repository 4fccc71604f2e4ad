#pragma once

#include <memory>

#include "buffers/packed_sink.h"
#include "buffers/surface_method.h"
#include "buffers/surface_pass.h"

namespace ink::buffers {

/// The parameters that all packed buffers share.
struct PackParams : InputParams {
    Packing packing = Packing::vertex;
    Quantise quantise = Quantise::sum;
    raster::Overflow overflow = raster::Overflow::saturate;
    edge::Response response = edge::Response::absolute;
    int clip_bits = 2;
    int scale_bits = 0;
    bool fatten = false;
    int sky = 0;
    int threshold = 13;  ///< each method ships its own, found by ODS over the training scenes
};

/// Appends the rows of PackParams, those of InputParams first; `max_code` is the largest the store
/// holds.
template <class P>
core::ParamTable<P>& add_pack_params(core::ParamTable<P>& table, int max_code) {
    add_input_params(table)
        .choice(
            &P::packing,
            "packing",
            {"vertex", "pixel"},
            "Pack at vertices and interpolate one number, or interpolate four and pack at pixels.")
        .choice(&P::quantise,
                "quantise",
                {"sum", "each"},
                "Round the sum once, or every channel before it is summed.")
        .choice(
            &P::overflow,
            "overflow",
            {"saturate", "wrap"},
            "What happens to a code beyond its bits; a wrapped one is filtered modulo its range.")
        .choice(&P::response,
                "response",
                {"absolute", "positive", "wrap"},
                "|L|, its positive half (one pixel wide), or L as a wrapped unsigned number.")
        .number(&P::clip_bits, "clip_bits", {0, 7}, "bits", "Low bits of the response cleared.")
        .number(&P::scale_bits,
                "scale_bits",
                {-8, 7},
                "bits",
                "Shift left of the response after clipping; right if negative.")
        .flag(&P::fatten, "fatten", "Blur the codes slightly before the filter: fatter lines.")
        .number(
            &P::sky, "sky", {0, static_cast<double>(max_code)}, "code", "What empty pixels hold.");
    return method::add_threshold(table);
}

/// Depth and normal packed into one or two small integers a pixel, and MOTE's filter over them.
///
/// The engine of mote2, mote4, mote16 and two_sums, which differ in their CodeLayout alone.
class PackedBuffer : public SurfaceMethod<SurfacePass> {
  public:
    PackedBuffer(const PackParams& params, CodeLayout layout);

    /// `packed`: the codes, black to white over their bits; two or more fields as red, green, blue.
    /// `filtered`: the response, brightened so that the threshold is middle grey.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    /// Declared where the code is one sum, rounded once, and filtered as it stands.
    [[nodiscard]] std::optional<method::LinearCode> code() const override;

  private:
    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override {
        return draw_buffer(frame, out, nullptr);
    }
    [[nodiscard]] method::PixelBytes filter_bytes() const override;
    /// Draws the scene that is there; with `codes` all of it, and keeps them.
    [[nodiscard]] raster::SkipCounts draw_buffer(const method::Frame& frame,
                                                 edge::EdgeImage& out,
                                                 FrameCodes* codes);
    [[nodiscard]] bool has_linear_codes() const;
    [[nodiscard]] bool flat_gives_zero() const;
    [[nodiscard]] std::unique_ptr<raster::CornerValues> corner_values(bool reads_all,
                                                                      std::uint64_t& unread) const;

    PackParams params_;
    Packer packer_;
};

}  // namespace ink::buffers
