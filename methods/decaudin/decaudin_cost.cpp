// The declared cost of Decaudin's two operators, counted as edge/decaudin_filter.h writes them.

#include "methods/decaudin/decaudin.h"

namespace ink::methods {
namespace {

constexpr double kChannels = 4;  // depth, nx, ny, nz
constexpr double kFloat_bytes = sizeof(float);

/// g of one channel: eight differences and their sizes, corners and sides summed, sides doubled,
/// both added, over 8. p looks at g's neighbours, so g is an image of its own.
constexpr method::PixelWork kG{kFloat_bytes, kFloat_bytes, 8 + 8 + 3 + 3 + 1 + 1 + 1};

/// p of one channel: the extremes of a column serve three pixels (two comparisons each), those of
/// three columns are two more each; difference, over k, squared, at most 1.
constexpr method::PixelWork kP{kFloat_bytes, 0, 2 * (2 + 2) + 1 + 1 + 1 + 1};

double join_operations(Decaudin::Join join) {
    switch (join) {
        case Decaudin::Join::max:
            return 1;
        case Decaudin::Join::either:
            return 3;
        case Decaudin::Join::length:
            return 2;
    }
    return 0;
}

}  // namespace

method::PixelWork Decaudin::filter_work() const {
    const method::PixelWork join{0, 0, join_operations(params_.join)};
    method::PixelWork write{0, 1, 4};  // at most 1, times 255, plus a half, to a byte
    if (params_.join == Join::length) write.operations += method::kSlowOperations;
    return buffers::encoded_depth_work(params_) + buffers::view_normals_work(params_.renormalise) +
           kChannels * (kG + kP + join) + write;
}

}  // namespace ink::methods
