// The declared cost of packed buffers, stage by stage as PackedSink has them.

#include "buffers/packed_buffer.h"

namespace ink::buffers {
namespace {

/// One code of one field from depth and normal in floats: a sum of four products and an offset.
method::PixelWork pack_field_work(const PackParams& params, bool has_bit_fields) {
    method::PixelWork work{0, 0, 4 + 4};
    work.operations += params.quantise == Quantise::sum ? 1 : 4;               // rounded
    work.operations += params.overflow == raster::Overflow::saturate ? 2 : 1;  // limited
    if (has_bit_fields) work.operations += 2;                                  // shifted, joined
    return work;
}

/// Four floats a pixel to the codes of all planes.
method::PixelWork pack_work(const PackParams& params, const CodeLayout& layout) {
    const double code_bytes = layout.bits() / 8.0;
    const auto fields = static_cast<double>(layout.fields.size());
    method::PixelWork work = method::encode_work(params.depth_encoding, params.interpolation);
    if (params.renormalise) work = work + method::renormalise_work();
    work = work + fields * pack_field_work(params, layout.has_bit_fields());
    work.bytes_read += 4 * sizeof(float);
    work.bytes_written += layout.planes * code_bytes;
    return work;
}

/// 1 2 1 / 2 4 2 / 1 2 1 over 16.
method::PixelWork blur_work(bool wraps, double code_bytes) {
    // Corners 3, sides 3, doubled 1, middle times four 1, three sums, shifted 1.
    constexpr double kPlain = 12;
    // Eight ways round: a difference and two shifts each. Corners 3, sides 3, doubled 1, three
    // sums, shifted 1, masked 1.
    constexpr double kWrapped = 8 * 3 + 12;
    return {code_bytes, code_bytes, wraps ? kWrapped : kPlain};
}

/// The Laplacian of one field and its response.
method::PixelWork laplacian_work(const PackParams& params,
                                 const Field& field,
                                 const CodeLayout& layout) {
    const bool is_top = field.shift + field.bits == layout.bits();
    const bool wraps =
        params.overflow == raster::Overflow::wrap || (params.packing == Packing::vertex && !is_top);
    const double code_bytes = layout.bits() / 8.0;
    const int scale_bits = params.scale_bits + layout.bits() - field.bits;
    const bool is_wide = params.response != edge::Response::wrap;
    method::PixelWork work{code_bytes, 1, 5};    // 4 m, four differences
    if (wraps && is_wide) work.operations += 2;  // L the short way round: shifts up and down
    work.operations += 1;                        // |L|, max(L, 0) or L's mask
    if (params.clip_bits > 0) work.operations += 1;
    if (scale_bits != 0) work.operations += 1;
    work.operations += 1;  // at most 255, or its low byte
    if (layout.has_bit_fields())
        work = work + method::PixelWork{code_bytes, code_bytes, 2};  // extracted
    if (params.fatten) work = work + blur_work(wraps, code_bytes);
    return work;
}

}  // namespace

method::Cost PackedBuffer::cost() const {
    const CodeLayout& layout = packer_.layout();
    method::Cost cost;
    cost.passes = 1;
    cost.interpolants = format_.interpolants;
    cost.values_per_vertex = format_.interpolants;
    cost.shares_vertices = params_.normals != scene::NormalSource::facet;
    cost.buffer_bytes_per_px = format_.bytes_per_px();
    cost.fill = method::fill_work(format_);
    if (params_.packing == Packing::pixel) cost.filter = pack_work(params_, layout);
    for (const Field& field : layout.fields)
        cost.filter = cost.filter + laplacian_work(params_, field, layout);
    // Every field but the first joins the edge responses that are there by their maximum.
    const auto joins = static_cast<double>(layout.fields.size() - 1);
    cost.filter = cost.filter + joins * method::PixelWork{1, 0, 1};
    return cost;
}

}  // namespace ink::buffers
