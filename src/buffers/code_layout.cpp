#include "buffers/code_layout.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace ink::buffers {

Packer::Packer(CodeLayout layout, DepthSign sign, Quantise quantise, raster::Overflow overflow)
    : layout_(std::move(layout)), sign_(sign), quantise_(quantise), overflow_(overflow) {
    for (const Field& field : layout_.fields) {
        PackField& added = kernel_fields_.emplace_back();
        added.depth = static_cast<float>(field.ranges.depth);
        for (int i = 0; i < 3; ++i)
            added.normal[i] = static_cast<float>(field.ranges.normal[i]);
        added.offset = static_cast<float>(field.ranges.offset);
        added.bits = field.bits;
        added.shift = field.shift;
    }
}

/// The sum before it is rounded, or of its rounded channels.
double Packer::value(const Ranges& ranges, double depth, const glm::dvec3& n) const {
    const double d = sign_ == DepthSign::near_high ? depth : 1 - depth;
    double terms[4] = {ranges.depth * d};
    for (int i = 0; i < 3; ++i)
        terms[i + 1] = ranges.normal[i] * (n[i] + 1) * 0.5;
    if (quantise_ == Quantise::each) {
        for (double& term : terms)
            term = std::floor(term + 0.5);
    }
    return terms[0] + terms[1] + terms[2] + terms[3] + ranges.offset;
}

int Packer::limited(long value, int bits) const {
    const long max = (1L << bits) - 1;
    return static_cast<int>(overflow_ == raster::Overflow::wrap ? value & max
                                                                : std::clamp(value, 0L, max));
}

double Packer::at_vertex(int plane, double depth, const glm::dvec3& n_view) const {
    double code = 0;
    for (const Field& field : layout_.fields) {
        if (field.plane != plane) continue;
        double v = value(field.ranges, depth, n_view);
        if (layout_.has_bit_fields()) v = limited(std::lround(v), field.bits) << field.shift;
        code += v;
    }
    return code + 0.5;
}

template <class T>
void Packer::pack_row(int plane, const PixelRow& row, T* codes) const {
    const auto in_plane = [&](const Field& field) { return field.plane == plane; };
    const auto& fields = layout_.fields;
    const auto first = std::ranges::find_if(fields, in_plane);
    const auto last = std::find_if_not(first, fields.end(), in_plane);
    const std::span<const PackField> all(kernel_fields_);
    pack_pixels(all.subspan(static_cast<std::size_t>(first - fields.begin()),
                            static_cast<std::size_t>(last - first)),
                {.is_near_high = sign_ == DepthSign::near_high,
                 .rounds_each = quantise_ == Quantise::each,
                 .wraps = overflow_ == raster::Overflow::wrap},
                row,
                codes);
}

template void Packer::pack_row(int, const PixelRow&, std::uint8_t*) const;
template void Packer::pack_row(int, const PixelRow&, std::uint16_t*) const;

}  // namespace ink::buffers
