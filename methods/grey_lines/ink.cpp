#include "methods/grey_lines/ink.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>

#include "core/parallel.h"
#include "raster/pass/pass.h"

namespace ink::methods {
namespace {

using raster::kTileSize_px;

void see_from(const glm::ivec2& origin, const Piece& piece, InkPiece& ink) {
    const glm::dvec2 a = piece.a - glm::dvec2(origin), way = piece.b - piece.a;
    ink.x = static_cast<float>(a.x);
    ink.y = static_cast<float>(a.y);
    ink.dx = static_cast<float>(way.x);
    ink.dy = static_cast<float>(way.y);
    ink.half_px = piece.half_a_px;
    ink.half_more_px = piece.half_b_px - piece.half_a_px;
    const float length2 = ink.dx * ink.dx + ink.dy * ink.dy;
    ink.per_length2 = length2 > 1e-12F ? 1 / length2 : 0;
    const float reach = std::max(piece.half_a_px, piece.half_b_px) + kPenReach_px;
    ink.y_low = std::min(ink.y, ink.y + ink.dy) - reach;
    ink.y_high = std::max(ink.y, ink.y + ink.dy) + reach;
}

/// The pieces that other tiles than their own need.
class Guests {
  public:
    Guests(const std::vector<std::vector<Piece>>& of_tiles, int columns)
        : columns_(columns), of_(of_tiles.size()) {
        for (std::size_t i = 0; i < of_tiles.size(); ++i) {
            const int tile = static_cast<int>(i);
            const glm::dvec2 begin(kTileSize_px * glm::ivec2(tile % columns, tile / columns));
            for (const Piece& piece : of_tiles[i])
                send(piece, tile, begin);
        }
    }
    [[nodiscard]] const std::vector<const Piece*>& of(std::size_t tile) const { return of_[tile]; }

  private:
    /// Of a piece of tile `own`, which begins at `begin`.
    void send(const Piece& piece, int own, const glm::dvec2& begin) {
        const double reach = std::max(piece.half_a_px, piece.half_b_px) + kPenReach_px + 0.01;
        const glm::dvec2 low = glm::min(piece.a, piece.b) - reach;
        const glm::dvec2 high = glm::max(piece.a, piece.b) + reach;
        const bool is_at_home = low.x >= begin.x && low.y >= begin.y &&
                                high.x < begin.x + kTileSize_px && high.y < begin.y + kTileSize_px;
        if (is_at_home) return;
        const auto tile = [&](double at) {
            return static_cast<int>(std::floor(at)) >> std::countr_zero(unsigned{kTileSize_px});
        };
        const int rows = static_cast<int>(of_.size()) / columns_;
        const int x0 = std::max(tile(low.x), 0), x1 = std::min(tile(high.x), columns_ - 1);
        const int y0 = std::max(tile(low.y), 0), y1 = std::min(tile(high.y), rows - 1);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                if (y * columns_ + x != own)
                    of_[static_cast<std::size_t>(y * columns_ + x)].push_back(&piece);
    }

    int columns_;
    std::vector<std::vector<const Piece*>> of_;
};

/// The pixels of a tile of cells that the image has.
InkTile pixels_of(const glm::ivec2& cells, int margin_px, glm::ivec2& first, edge::EdgeImage& out) {
    const auto clip = [&](int at, int size) { return std::clamp(at - margin_px, 0, size); };
    first = {clip(cells.x, out.width_px()), clip(cells.y, out.height_px())};
    return {.first = out.data() + first.y * std::ptrdiff_t{out.width_px()} + first.x,
            .stride = out.width_px(),
            .width_px = clip(cells.x + kTileSize_px, out.width_px()) - first.x,
            .height_px = clip(cells.y + kTileSize_px, out.height_px()) - first.y};
}

}  // namespace

void draw_pieces(const std::vector<std::vector<Piece>>& of_tiles,
                 const InkFrame& frame,
                 edge::EdgeImage& out) {
    // At once: tile by tile, rows of 64 bytes take longer than all else of an empty one.
    out.fill(0);
    const Guests guests(of_tiles, frame.columns);
    core::parallel_for(of_tiles.size(), frame.threads, [&](std::size_t i) {
        const int tile = static_cast<int>(i);
        const glm::ivec2 cells =
            kTileSize_px * glm::ivec2(tile % frame.columns, tile / frame.columns);
        glm::ivec2 first;
        const InkTile pixels = pixels_of(cells, frame.margin_px, first, out);
        if (pixels.width_px == 0 || pixels.height_px == 0) return;
        static thread_local std::vector<InkPiece> pieces;
        pieces.clear();
        const glm::ivec2 origin = first + frame.margin_px;
        for (const Piece& piece : of_tiles[i])
            see_from(origin, piece, pieces.emplace_back());
        for (const Piece* piece : guests.of(i))
            see_from(origin, *piece, pieces.emplace_back());
        if (!pieces.empty()) draw_ink(pieces, pixels);
    });
}

}  // namespace ink::methods
