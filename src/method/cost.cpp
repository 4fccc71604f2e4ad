// How operations are counted: one for each addition, subtraction, product, comparison, minimum,
// maximum, shift, mask, conversion or rounding that the formula of a pixel needs; kSlowOperations
// for a division, a root or a logarithm; none for loads, stores and loop counters. What is the same
// for a whole row or triangle is not counted.

#include "method/cost.h"

#include <fmt/format.h>

#include "method/depth_code.h"

namespace ink::method {
namespace {

double depth_bytes(raster::DepthFormat format) {
    raster::PassFormat depth_only;
    depth_only.depth = format;
    return depth_only.bytes_per_px();
}

/// Of the encoded depth, from the distance along the view direction: raster::encode_depth.
double encode_operations(raster::DepthEncoding encoding) {
    using raster::DepthEncoding;
    constexpr double kWindowDepth = kSlowOperations + 2;  // far / w, less 1, scaled
    switch (encoding) {
        case DepthEncoding::inverse:
            return kWindowDepth;
        case DepthEncoding::linear:
            return 2;
        case DepthEncoding::log:
            return 2 * kSlowOperations + 1;  // far / w, its logarithm, scaled
        case DepthEncoding::zbuffer24:
        case DepthEncoding::zbuffer16:
            return kWindowDepth + 3;  // to steps, rounded, back
        case DepthEncoding::reversed_float:
            return kSlowOperations + 1;  // near / w, to float
    }
    return 0;
}

}  // namespace

PixelWork operator+(const PixelWork& a, const PixelWork& b) {
    return {a.bytes_read + b.bytes_read,
            a.bytes_written + b.bytes_written,
            a.operations + b.operations};
}

PixelWork operator*(double times, const PixelWork& work) {
    return {times * work.bytes_read, times * work.bytes_written, times * work.operations};
}

PixelWork fill_work(const raster::PassFormat& format) {
    using raster::Interpolation;
    using raster::Overflow;
    using raster::Store;
    PixelWork work;
    work.operations = 3 + 3;   // three edge functions stepped; two ORs and a sign test
    work.operations += 1 + 1;  // the plane of depth stepped; the test
    if (format.depth != raster::DepthFormat::q32) work.operations += 2;  // to steps, rounded
    const bool is_perspective =
        format.interpolation == Interpolation::perspective && format.interpolants > 0;
    if (is_perspective) work.operations += kSlowOperations;  // w = 1 / q
    double per_plane = 1;                                    // the plane stepped
    if (is_perspective) per_plane += 1;                      // times w
    if (format.constant) per_plane += 1;
    if (format.store != Store::f32) {
        per_plane += 1;  // shifted, or rounded, to a whole code
        per_plane += format.overflow == Overflow::saturate ? 2 : 1;
    }
    if (format.interpolants > 0) work.operations += format.interpolants * per_plane;
    work.bytes_read = depth_bytes(format.depth);
    work.bytes_written = format.bytes_per_px();
    return work;
}

PixelWork encode_work(raster::DepthEncoding encoding, raster::Interpolation interpolation) {
    const raster::DepthRange any_range{1, 2};
    if (DepthCarrier(encoding, interpolation, any_range).is_encoded()) return {};
    const bool is_affine = interpolation == raster::Interpolation::affine;
    const double w = is_affine ? 2 + kSlowOperations : 2;  // 1 / (carried scaled + offset)
    return {0, 0, w + encode_operations(encoding)};
}

PixelWork renormalise_work() {
    // Three squares, two sums, a root, a division, three products.
    return {0, 0, 3 + 2 + 2 * kSlowOperations + 3};
}

std::string cost_sentence(const Cost& cost) {
    if (!cost.is_declared()) return "not declared";
    return fmt::format(
        "{} pass{}, {} interpolant{}; a covered pixel {:g} bytes and {:g} operations, a pixel {:g} "
        "bytes and {:g} operations",
        cost.passes,
        cost.passes == 1 ? "" : "es",
        cost.interpolants,
        cost.interpolants == 1 ? "" : "s",
        cost.fill.bytes_read + cost.fill.bytes_written,
        cost.fill.operations,
        cost.buffer_bytes_per_px + cost.filter.bytes_read + cost.filter.bytes_written,
        cost.filter.operations);
}

std::string cost_table(const Cost& cost) {
    std::string table = "| per | what | count |\n|---|---|---|\n";
    const auto line = [&table](const char* per, const char* what, double count) {
        table += fmt::format("| {} | {} | {:g} |\n", per, what, count);
    };
    line("frame", "passes over the triangles", cost.passes);
    line("vertex", "values computed", cost.values_per_vertex);
    line("triangle", "interpolants set up, beside depth", cost.interpolants);
    line("covered pixel", "bytes read", cost.fill.bytes_read);
    line("covered pixel", "bytes written", cost.fill.bytes_written);
    line("covered pixel", "operations of the fill", cost.fill.operations);
    line("pixel", "bytes cleared", cost.buffer_bytes_per_px);
    line("pixel", "bytes read by the filter", cost.filter.bytes_read);
    line("pixel", "bytes written by the filter", cost.filter.bytes_written);
    line("pixel", "operations of the filter", cost.filter.operations);
    return table;
}

}  // namespace ink::method
