#include "shade/widen.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace ink::shade {
namespace {

/// A row of the disc: pixels [x0, x1) beside the one that is widened.
struct DiscRow {
    int y = 0;
    int x0 = 0;
    int x1 = 0;
};

std::vector<DiscRow> disc_rows(int diameter_px) {
    // In half pixels, from the disc's centre to pixel centres: whole numbers.
    const int first = -(diameter_px / 2);
    const auto is_inside = [&](int x, int y) {
        const int shift = diameter_px % 2 == 0 ? 1 : 0;
        const int dx = 2 * x + shift;
        const int dy = 2 * y + shift;
        return dx * dx + dy * dy <= diameter_px * diameter_px;
    };
    std::vector<DiscRow> rows;
    for (int y = first; y < first + diameter_px; ++y) {
        DiscRow row{y, first, first + diameter_px};
        while (row.x0 < row.x1 && !is_inside(row.x0, y))
            ++row.x0;
        while (row.x1 > row.x0 && !is_inside(row.x1 - 1, y))
            --row.x1;
        if (row.x0 < row.x1) rows.push_back(row);
    }
    return rows;
}

}  // namespace

core::Image<std::uint8_t> widen(const core::Image<std::uint8_t>& edge_responses, int diameter_px) {
    assert(diameter_px >= 1);
    if (diameter_px == 1) return edge_responses;
    const int width = edge_responses.width_px();
    const int height = edge_responses.height_px();
    core::Image<std::uint8_t> result(width, height);
    const std::vector<DiscRow> rows = disc_rows(diameter_px);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint8_t edge_response = edge_responses.row(y)[x];
            if (edge_response == 0) continue;
            for (const DiscRow& row : rows) {
                if (y + row.y < 0 || y + row.y >= height) continue;
                std::uint8_t* to = result.row(y + row.y);
                for (int i = std::max(x + row.x0, 0); i < std::min(x + row.x1, width); ++i)
                    to[i] = std::max(to[i], edge_response);
            }
        }
    }
    return result;
}

}  // namespace ink::shade
