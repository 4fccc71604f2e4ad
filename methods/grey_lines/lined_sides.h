#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/pass/bin.h"

namespace ink::methods {

/// What is known of the samples of a frame, by tiles, which different threads may fill. A `Tile`
/// can be cleared.
template <class Tile>
class SampleTiles {
  public:
    static constexpr int kShift = std::countr_zero(unsigned{raster::kTileSize_px});
    static constexpr int kMask = raster::kTileSize_px - 1;
    /// Samples of a tile.
    static constexpr std::size_t kCount = std::size_t{1} << 2 * kShift;

    /// Clears all, for a frame of samples.
    void reset(const raster::TileGrid& grid) {
        grid_ = grid;
        columns_ = grid.columns();
        tiles_.resize(static_cast<std::size_t>(grid.count()));
        for (Tile& tile : tiles_)
            tile.clear();
    }
    [[nodiscard]] const raster::TileGrid& grid() const { return grid_; }
    [[nodiscard]] Tile& of(int x, int y) { return tiles_[tile_at(x, y)]; }
    [[nodiscard]] const Tile& of(int x, int y) const { return tiles_[tile_at(x, y)]; }
    /// Where a sample is among those of its tile.
    [[nodiscard]] static std::size_t place(int x, int y) {
        return static_cast<std::size_t>((y & kMask) << kShift | (x & kMask));
    }

  private:
    [[nodiscard]] std::size_t tile_at(int x, int y) const {
        return static_cast<std::size_t>((y >> kShift) * columns_ + (x >> kShift));
    }

    raster::TileGrid grid_;
    int columns_ = 0;
    std::vector<Tile> tiles_;
};

/// The lines between the samples of a frame.
///
/// Sides are named by their first sample, and whether the second is the next to the right, or
/// below. `Line` is what is known of a line.
template <class Line>
class LinedSides {
  public:
    /// Forgets all, for a frame of samples.
    void reset(const raster::TileGrid& grid) { tiles_.reset(grid); }

    [[nodiscard]] std::size_t tiles() const {
        return static_cast<std::size_t>(tiles_.grid().count());
    }

    /// Adds the lines of a side, which append(lines) puts behind others. The sides of a row of a
    /// tile are added from the left on, those to the right apart from those down.
    template <class Append>
    void add(int x, int y, bool is_down, const Append& append) {
        Tile& tile = tiles_.of(x, y);
        append(tile.lines);
        if (tile.lines.size() == tile.ends.back()) return;
        Sides& sides = is_down ? tile.down : tile.right;
        if (sides.rows[row(y)] == 0)
            sides.starts[row(y)] = static_cast<std::uint16_t>(tile.ends.size() - 1);
        sides.rows[row(y)] |= bit(x);
        tile.ends.push_back(static_cast<std::uint32_t>(tile.lines.size()));
    }

    /// The lines of a side; it may lie beyond the frame, where there is none.
    [[nodiscard]] std::span<const Line> at(int x, int y, bool is_down) const {
        if (x < 0 || y < 0 || x >= width_px() || y >= height_px()) return {};
        const Tile& tile = tiles_.of(x, y);
        const Sides& sides = is_down ? tile.down : tile.right;
        const std::uint64_t own = sides.rows[row(y)];
        if ((own & bit(x)) == 0) return {};
        const std::size_t i = sides.starts[row(y)] + std::popcount(own & (bit(x) - 1));
        return {tile.lines.data() + tile.ends[i], tile.ends[i + 1] - tile.ends[i]};
    }

    /// Calls visit(x, y) for each cell of a tile with a line on one of its sides. A cell lies
    /// between four samples, and is named by the upper left one.
    template <class Visit>
    void each_cell(std::size_t tile, const Visit& visit) const {
        each_set(tile, visit, [&](int x, int y) { return cells(x, y); });
    }

    /// The same of cells without a line between two that have one, on the left and on the right, or
    /// above and below.
    template <class Visit>
    void each_between(std::size_t tile, const Visit& visit) const {
        const raster::PixelRect all = tiles_.grid().own(static_cast<int>(tile));
        std::uint64_t above = cells(all.x0, all.y0 - 1), own = cells(all.x0, all.y0);
        each_set(tile, visit, [&](int x, int y) {
            const std::uint64_t below = cells(x, y + 1);
            std::uint64_t left = own << 1, right = own >> 1;
            // Of other tiles only what may matter.
            if ((right & 1) != 0) left |= cells(x - raster::kTileSize_px, y) >> Tiles::kMask;
            if (left >> Tiles::kMask != 0)
                right |= cells(x + raster::kTileSize_px, y) << Tiles::kMask;
            const std::uint64_t between = ~own & ((left & right) | (above & below));
            above = own;
            own = below;
            return between;
        });
    }

    [[nodiscard]] bool is_cell(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_px() - 1 && y < height_px() - 1;
    }

  private:
    struct Tile;
    using Tiles = SampleTiles<Tile>;
    struct Sides {
        std::array<std::uint64_t, raster::kTileSize_px> rows{};  ///< those with lines
        std::array<std::uint16_t, raster::kTileSize_px>
            starts;  ///< of the first of a row, into `ends`
    };
    struct Tile {
        Sides right, down;
        std::vector<std::uint32_t> ends{0};  ///< of the sides' lines: from one to the next
        std::vector<Line> lines;

        void clear() {
            if (lines.empty()) return;
            right.rows.fill(0);
            down.rows.fill(0);
            ends.resize(1);
            lines.clear();
        }
    };

    /// Calls visit(x, y) for each bit of rows(x, y) in the rows of a tile, from its first cell on.
    template <class Visit, class Rows>
    void each_set(std::size_t tile, const Visit& visit, const Rows& rows) const {
        const raster::PixelRect own = tiles_.grid().own(static_cast<int>(tile));
        const bool is_last_row = own.y1 >= height_px(), is_last_column = own.x1 >= width_px();
        const auto is_empty = [&](int x, int y) { return tiles_.of(x, y).lines.empty(); };
        if (is_empty(own.x0, own.y0) && (is_last_column || is_empty(own.x1, own.y0)) &&
            (is_last_row || is_empty(own.x0, own.y1)))
            return;
        for (int y = own.y0; y < std::min(own.y1, height_px() - 1); ++y)
            for (std::uint64_t bits = rows(own.x0, y); bits != 0; bits &= bits - 1)
                visit(own.x0 + std::countr_zero(bits), y);
    }
    /// The cells with lines of a row of a tile whose first is (x, y); there may be none.
    [[nodiscard]] std::uint64_t cells(int x, int y) const {
        if (!is_cell(x, y)) return 0;
        const int left = width_px() - 1 - x;
        const std::uint64_t is_there = left > Tiles::kMask ? ~std::uint64_t{0} : bit(left) - 1;
        return is_there & (right(x, y) | right(x, y + 1) | down(x, y) | down(x, y) >> 1 |
                           down(x + raster::kTileSize_px, y) << Tiles::kMask);
    }

    [[nodiscard]] int width_px() const { return tiles_.grid().width_px; }
    [[nodiscard]] int height_px() const { return tiles_.grid().height_px; }
    [[nodiscard]] static std::size_t row(int y) {
        return static_cast<std::size_t>(y & Tiles::kMask);
    }
    [[nodiscard]] static std::uint64_t bit(int x) { return std::uint64_t{1} << (x & Tiles::kMask); }
    [[nodiscard]] std::uint64_t right(int x, int y) const {
        return tiles_.of(x, y).right.rows[row(y)];
    }
    [[nodiscard]] std::uint64_t down(int x, int y) const {
        return x < width_px() ? tiles_.of(x, y).down.rows[row(y)] : 0;
    }

    Tiles tiles_;
};

}  // namespace ink::methods
