#include "raster/depth/coarse_depth.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/depth/coarse_depth.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ink::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The least of 16 columns over `rows` rows.
template <class T>
T LeastIn(const T* depth, int rows) {
    const hn::CappedTag<T, CoarseDepth::kSquare_px> d;
    auto least = hn::Set(d, std::numeric_limits<T>::max());
    for (int y = 0; y < rows; ++y, depth += kTileStride) {
        for (int x = 0; x < CoarseDepth::kSquare_px; x += static_cast<int>(hn::Lanes(d)))
            least = hn::Min(least, hn::LoadU(d, depth + x));
    }
    return hn::GetLane(hn::MinOfLanes(d, least));
}

float LeastNumber(const float* depth, int rows) {
    return LeastIn(depth, rows);
}

float LeastStep(const std::uint32_t* depth, int rows) {
    return static_cast<float>(LeastIn(depth, rows));  // at most 2^24 - 1: exact
}

/// The least number in each block of some rows, which stand one behind the other.
void LeastOfBlocks(const std::uint32_t* from, int width_px, int rows, std::uint32_t* least) {
    const hn::CappedTag<std::uint32_t, DepthBlocks::kBlock_px> d;
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
    for (int x0 = 0; x0 < width_px; x0 += DepthBlocks::kBlock_px, ++least) {
        const int count = std::min(DepthBlocks::kBlock_px, width_px - x0);
        std::uint32_t found = kMost;
        auto found_lanes = hn::Set(d, kMost);
        const std::uint32_t* block = from + x0;
        for (int y = 0; y < rows; ++y, block += width_px) {
            if (count < DepthBlocks::kBlock_px) {
                found = std::min(found, *std::min_element(block, block + count));
                continue;
            }
            for (int x = 0; x < count; x += static_cast<int>(hn::Lanes(d)))
                found_lanes = hn::Min(found_lanes, hn::LoadU(d, block + x));
        }
        *least = std::min(found, hn::GetLane(hn::MinOfLanes(d, found_lanes)));
    }
}

}  // namespace ink::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::raster {

HWY_EXPORT(LeastNumber);
HWY_EXPORT(LeastStep);

namespace {

constexpr std::size_t kFirstPause = 96;

/// Squares that pixels begin .. end - 1 touch, counted from the tile's own first.
std::pair<int, int> squares(int begin, int end, int origin) {
    constexpr int kLast = CoarseDepth::kSquares - 1;
    return {std::clamp((begin - origin) / CoarseDepth::kSquare_px, 0, kLast),
            std::clamp((end - 1 - origin) / CoarseDepth::kSquare_px, 0, kLast)};
}

float least_of(const float* depth, int rows) {
    return HWY_DYNAMIC_DISPATCH(LeastNumber)(depth, rows);
}

float least_of(const std::uint32_t* depth, int rows) {
    return HWY_DYNAMIC_DISPATCH(LeastStep)(depth, rows);
}

}  // namespace

void CoarseDepth::start(TileBuffer& buffer) {
    buffer_ = &buffer;
    drawn_ = 0;
    pause_ = kFirstPause;
    is_known_ = false;
}

void CoarseDepth::refresh() {
    is_in_steps_ ? refresh_as<std::uint32_t>() : refresh_as<float>();
}

template <class T>
void CoarseDepth::refresh_as() {
    // Each look costs as much as ten triangles: the seldomer, the more there are.
    pause_ += pause_ / 4;
    drawn_ = 0;
    is_known_ = true;
    const PixelRect& own = buffer_->own();
    const PixelRect& drawn = buffer_->drawn();
    for (int row = 0; row < kSquares; ++row) {
        const int y0 = row == 0 ? drawn.y0 : own.y0 + row * kSquare_px;
        const int y1 =
            row == kSquares - 1 ? drawn.y1 : std::min(own.y0 + (row + 1) * kSquare_px, drawn.y1);
        for (int column = 0; column < kSquares; ++column) {
            auto& least = least_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            const int x0 = own.x0 + column * kSquare_px;
            const bool is_whole = y0 < y1 && x0 + kSquare_px <= own.x1;
            least = is_whole ? least_of(buffer_->depth_row<T>(y0) + x0, y1 - y0) : 0;
        }
        auto& line = least_[static_cast<std::size_t>(row)];
        for (int y = y0; y < y1; ++y) {
            const T* depth = buffer_->depth_row<T>(y);
            for (int x = drawn.x0; x < own.x0; ++x)
                line.front() = std::min(line.front(), static_cast<float>(depth[x]));
            for (int x = own.x1; x < drawn.x1; ++x)
                line.back() = std::min(line.back(), static_cast<float>(depth[x]));
        }
    }
}

bool CoarseDepth::hides(const PixelRect& bounds, float q_most) const {
    if (!is_known_) return false;
    const auto [column0, column1] = squares(bounds.x0, bounds.x1, buffer_->own().x0);
    const auto [row0, row1] = squares(bounds.y0, bounds.y1, buffer_->own().y0);
    for (int row = row0; row <= row1; ++row) {
        for (int column = column0; column <= column1; ++column) {
            if (least_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] < q_most)
                return false;
        }
    }
    return true;
}

HWY_EXPORT(LeastOfBlocks);

void DepthBlocks::find(const core::Image<std::uint32_t>& bits, int threads) {
    const int columns = (bits.width_px() + kBlock_px - 1) / kBlock_px;
    const int rows = (bits.height_px() + kBlock_px - 1) / kBlock_px;
    if (least_.width_px() != columns || least_.height_px() != rows)
        least_ = core::Image<std::uint32_t>(columns, rows);
    core::parallel_for(static_cast<std::size_t>(rows), threads, [&](std::size_t i) {
        const int row = static_cast<int>(i);
        const int y0 = row * kBlock_px;
        HWY_DYNAMIC_DISPATCH(LeastOfBlocks)
        (bits.row(y0),
         bits.width_px(),
         std::min(kBlock_px, bits.height_px() - y0),
         least_.row(row));
    });
}

bool DepthBlocks::hides(const PixelRect& rect, std::uint32_t most) const {
    constexpr int kFew = 9;
    const int x0 = rect.x0 / kBlock_px;
    const int y0 = rect.y0 / kBlock_px;
    const int x1 = (rect.x1 - 1) / kBlock_px;
    const int y1 = (rect.y1 - 1) / kBlock_px;
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > kFew) return false;
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            if (least_.at(x, y) <= most) return false;
        }
    }
    return true;
}

}  // namespace ink::raster
#endif  // HWY_ONCE
