#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "buffers/pack_kernel.h"
#include "buffers/surface_inputs.h"
#include "method/depth_code.h"
#include "raster/pass/pass.h"

namespace ink::buffers {

/// When a packed code is rounded.
enum class Quantise {
    sum,   ///< once, the whole sum
    each,  ///< every channel by itself, then summed
};

/// The code range of each channel: a channel at 1 adds this much, at 0 nothing.
struct Ranges {
    double depth = 0;
    glm::dvec3 normal{0};  ///< of each view-space component's (n+1)/2
    double offset = 0;     ///< added to the sum, as ranges below 0 need
};

/// The parameters of a code that sums all four channels.
struct SumParams {
    double range_depth = 63;
    double range_nx = 63;
    double range_ny = 63;
    double range_nz = 63;

    [[nodiscard]] Ranges ranges() const { return {range_depth, {range_nx, range_ny, range_nz}}; }
};

/// Appends the rows of SumParams; `max_code` is the largest the store holds, `note` ends each
/// sentence.
template <class P>
core::ParamTable<P>& add_sum_params(core::ParamTable<P>& table,
                                    double max_code,
                                    const std::string& note = ".") {
    const std::pair<double, double> range{0, max_code};
    const auto add = [&](double SumParams::*field, const char* name, const char* channel) {
        const std::string doc = "Codes that " + std::string(channel) + note;
        table.number(field, name, range, "code", doc);
    };
    add(&SumParams::range_depth, "range_depth", "depth 0..1 spans");
    add(&SumParams::range_nx, "range_nx", "the normal's x spans");
    add(&SumParams::range_ny, "range_ny", "the normal's y spans");
    add(&SumParams::range_nz, "range_nz", "the normal's z spans");
    return table;
}

/// One number inside a packed code: bits `shift` .. `shift + bits - 1` of plane `plane`.
struct Field {
    Ranges ranges;
    int shift = 0;
    int bits = 8;
    int plane = 0;
};

/// How depth and normal are packed into integer planes of one pass.
struct CodeLayout {
    raster::Store store = raster::Store::u8;  ///< u8 or u16
    int planes = 1;                           ///< 1 or 2
    std::vector<Field> fields;                ///< grouped by plane

    [[nodiscard]] int bits() const { return store == raster::Store::u8 ? 8 : 16; }
    /// Whether a plane holds several fields, each in bits of its own.
    [[nodiscard]] bool has_bit_fields() const { return static_cast<int>(fields.size()) > planes; }
};

/// Turns depth and normal into codes.
class Packer {
  public:
    Packer(CodeLayout layout, DepthSign sign, Quantise quantise, raster::Overflow overflow);

    [[nodiscard]] const CodeLayout& layout() const { return layout_; }

    /// The code of plane `plane` at a vertex plus one half, so that a floor later rounds it.
    ///
    /// A real number with a single field and `Quantise::sum`; not limited to the store's range,
    /// that is the pass's business. Several fields are each rounded and limited to their bits.
    [[nodiscard]] double at_vertex(int plane, double depth, const glm::dvec3& n_view) const;

    /// The codes of a row of pixels in plane `plane`; T is the layout's store.
    template <class T>
    void pack_row(int plane, const PixelRow& row, T* codes) const;

  private:
    [[nodiscard]] double value(const Ranges& ranges, double depth, const glm::dvec3& n) const;
    [[nodiscard]] int limited(long value, int bits) const;

    CodeLayout layout_;
    DepthSign sign_;
    Quantise quantise_;
    raster::Overflow overflow_;
    std::vector<PackField> kernel_fields_;  ///< those of the layout, in its order
};

}  // namespace ink::buffers
