#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/pass/bin.h"

namespace ink::methods {

/// The lines between the samples of a frame, by tiles, which different threads may fill.
///
/// Sides are named by their first sample, and whether the second is the next to the right, or
/// below. `Line` is what is known of a line.
template <class Line>
class LinedSides {
  public:
    using RowBits = std::array<std::uint64_t, raster::kTileSize_px>;

    /// Forgets all, for a frame of so many samples.
    void reset(int width_px, int height_px) {
        columns_ = (width_px + raster::kTileSize_px - 1) / raster::kTileSize_px;
        rows_ = (height_px + raster::kTileSize_px - 1) / raster::kTileSize_px;
        width_px_ = width_px;
        height_px_ = height_px;
        tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        for (Tile& tile : tiles_)
            tile.clear();
    }
    [[nodiscard]] std::size_t count() const { return tiles_.size(); }
    [[nodiscard]] std::size_t tile_at(int x, int y) const {
        return static_cast<std::size_t>((y >> kShift) * columns_ + (x >> kShift));
    }
    [[nodiscard]] glm::ivec2 origin(std::size_t tile) const {
        const int i = static_cast<int>(tile);
        return {i % columns_ << kShift, i / columns_ << kShift};
    }

    /// Adds the lines of a side. Those of a tile come row by row, in a row all to the right before
    /// all down, each from left to right.
    void add(int x, int y, bool is_down, std::span<const Line> lines) {
        if (lines.empty()) return;
        Tile& tile = tiles_[tile_at(x, y)];
        const auto row = static_cast<std::size_t>(y & kMask);
        auto& bits = (is_down ? tile.down : tile.right)[row];
        if (bits == 0)
            (is_down ? tile.first_down : tile.first_right)[row] =
                static_cast<std::uint32_t>(tile.ends.size() - 1);
        bits |= std::uint64_t{1} << (x & kMask);
        tile.lines.insert(tile.lines.end(), lines.begin(), lines.end());
        tile.ends.push_back(static_cast<std::uint32_t>(tile.lines.size()));
    }

    /// The lines of a side; it may lie beyond the frame, where there is none.
    [[nodiscard]] std::span<const Line> at(int x, int y, bool is_down) const {
        if (x < 0 || y < 0 || x >= width_px_ || y >= height_px_) return {};
        const Tile& tile = tiles_[tile_at(x, y)];
        const auto row = static_cast<std::size_t>(y & kMask);
        const std::uint64_t bits = (is_down ? tile.down : tile.right)[row];
        const std::uint64_t own = std::uint64_t{1} << (x & kMask);
        if ((bits & own) == 0) return {};
        const std::size_t i = (is_down ? tile.first_down : tile.first_right)[row] +
                              static_cast<std::size_t>(std::popcount(bits & (own - 1)));
        return {tile.lines.data() + tile.ends[i], tile.ends[i + 1] - tile.ends[i]};
    }

    /// Calls visit(x, y) for each cell of a tile with a line on one of its sides. A cell lies
    /// between four samples, and is named by the upper left one.
    template <class Visit>
    void each_cell(std::size_t tile, const Visit& visit) const {
        const glm::ivec2 from = origin(tile);
        for (int y = from.y; y < std::min(from.y + raster::kTileSize_px, height_px_ - 1); ++y) {
            std::uint64_t cells = right(from.x, y) | right(from.x, y + 1) | down(from.x, y) |
                                  down(from.x, y) >> 1 |
                                  down(from.x + raster::kTileSize_px, y) << kMask;
            for (; cells != 0; cells &= cells - 1) {
                const int x = from.x + std::countr_zero(cells);
                if (x < width_px_ - 1) visit(x, y);
            }
        }
    }

    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return height_px_; }
    [[nodiscard]] bool is_cell(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_px_ - 1 && y < height_px_ - 1;
    }

  private:
    static constexpr int kShift = std::countr_zero(unsigned{raster::kTileSize_px});
    static constexpr int kMask = raster::kTileSize_px - 1;

    struct Tile {
        RowBits right{}, down{};  ///< sides with lines
        std::array<std::uint32_t, raster::kTileSize_px> first_right, first_down;  ///< into `ends`
        std::vector<std::uint32_t> ends{0};  ///< of the sides' lines: from one to the next
        std::vector<Line> lines;

        void clear() {
            right.fill(0);
            down.fill(0);
            ends.resize(1);
            lines.clear();
        }
    };

    [[nodiscard]] std::uint64_t right(int x, int y) const {
        return tiles_[tile_at(x, y)].right[static_cast<std::size_t>(y & kMask)];
    }
    [[nodiscard]] std::uint64_t down(int x, int y) const {
        if (x >= width_px_) return 0;
        return tiles_[tile_at(x, y)].down[static_cast<std::size_t>(y & kMask)];
    }

    int columns_ = 0, rows_ = 0;
    int width_px_ = 0, height_px_ = 0;
    std::vector<Tile> tiles_;
};

}  // namespace ink::methods
