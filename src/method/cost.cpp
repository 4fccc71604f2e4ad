#include "method/cost.h"

#include <fmt/format.h>

namespace ink::method {

PixelBytes operator+(const PixelBytes& a, const PixelBytes& b) {
    return {a.read + b.read, a.written + b.written};
}

PixelBytes operator*(double times, const PixelBytes& bytes) {
    return {times * bytes.read, times * bytes.written};
}

Cost pass_cost(const raster::PassFormat& format) {
    raster::PassFormat depth;
    depth.depth = format.depth;
    Cost cost;
    cost.passes = 1;
    cost.interpolants = format.interpolants;
    cost.values_per_vertex = format.interpolants;
    cost.buffer_bytes_per_px = format.bytes_per_px();
    cost.fill.read = depth.bytes_per_px();
    cost.fill.written = format.bytes_per_px();
    return cost;
}

std::string cost_sentence(const Cost& cost) {
    if (!cost.is_declared()) return "not declared";
    return fmt::format("{} pass{}, {} interpolant{}; a covered pixel {:g} bytes, a pixel {:g}",
                       cost.passes,
                       cost.passes == 1 ? "" : "es",
                       cost.interpolants,
                       cost.interpolants == 1 ? "" : "s",
                       cost.fill.read + cost.fill.written,
                       cost.buffer_bytes_per_px + cost.filter.read + cost.filter.written);
}

}  // namespace ink::method
