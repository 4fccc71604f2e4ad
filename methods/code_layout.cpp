#include "methods/code_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ink::methods {

Packer::Packer(CodeLayout layout, DepthSign sign, Quantise quantise, raster::Overflow overflow)
    : layout_(std::move(layout)), sign_(sign), quantise_(quantise), overflow_(overflow) {}

/// The sum before it is rounded, or of its rounded channels.
template <class Real>
Real Packer::value(const Ranges& ranges, Real depth, const Real* n) const {
    const Real d = sign_ == DepthSign::near_high ? depth : 1 - depth;
    const Real half = Real(0.5);
    Real terms[4] = {static_cast<Real>(ranges.depth) * d};
    for (int i = 0; i < 3; ++i)
        terms[i + 1] = static_cast<Real>(ranges.normal[i]) * (n[i] + 1) * half;
    if (quantise_ == Quantise::each) {
        for (Real& term : terms)
            term = std::floor(term + half);
    }
    return terms[0] + terms[1] + terms[2] + terms[3];
}

int Packer::limited(long value, int bits) const {
    const long max = (1L << bits) - 1;
    return static_cast<int>(overflow_ == raster::Overflow::wrap ? value & max
                                                                : std::clamp(value, 0L, max));
}

double Packer::at_vertex(int plane, double depth, const glm::dvec3& n_view) const {
    const double n[3] = {n_view.x, n_view.y, n_view.z};
    double code = 0;
    for (const Field& field : layout_.fields) {
        if (field.plane != plane) continue;
        double v = value(field.ranges, depth, n);
        if (layout_.has_bit_fields()) v = limited(std::lround(v), field.bits) << field.shift;
        code += v;
    }
    return code + 0.5;
}

template <class T>
void Packer::pack_row(int plane, const PixelRow& row, T* codes) const {
    for (int x = 0; x < row.count; ++x) {
        if (row.depth[x] == kNothingDrawn) {
            codes[x] = static_cast<T>(row.sky);
            continue;
        }
        float n[3] = {row.nx[x], row.ny[x], row.nz[x]};
        if (row.renormalise) {
            const float square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
            const float scale = square > 0 ? 1 / std::sqrt(square) : 1;
            for (float& component : n)
                component *= scale;
        }
        int code = 0;
        for (const Field& field : layout_.fields) {
            if (field.plane != plane) continue;
            const float v = value(field.ranges, row.depth[x], n);
            code |= limited(static_cast<long>(std::floor(v + 0.5F)), field.bits) << field.shift;
        }
        codes[x] = static_cast<T>(code);
    }
}

template void Packer::pack_row(int, const PixelRow&, std::uint8_t*) const;
template void Packer::pack_row(int, const PixelRow&, std::uint16_t*) const;

}  // namespace ink::methods
