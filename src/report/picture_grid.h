#pragma once

#include <string>
#include <vector>

#include "report/sheet.h"

namespace ink::report {

/// A picture of a grid; an empty one leaves its place free.
struct GridCell {
    draw::RgbImage image;
    std::string caption = {};           ///< below it
    std::vector<SheetLine> lines = {};  ///< over it, in its own pixels
    bool is_strong = false;             ///< the caption in bold
};

struct GridRow {
    std::string label;      ///< to the left
    std::string note = {};  ///< smaller, below the label
    std::vector<GridCell> cells;
};

/// Rows under common headings.
struct GridBand {
    std::string title = {};            ///< over the headings; "" for none
    std::vector<std::string> columns;  ///< one a column; none for no headings
    std::vector<GridRow> rows;
};

/// A colour and what it means.
struct LegendEntry {
    draw::Colour colour;
    std::string words;
};

/// Lays bands out below each other: headings over columns, labels left of rows, captions under
/// pictures, and the legend at the foot, one line a group, as many as it takes. Pictures
/// smaller than the largest stand in the middle of their place. Letters are as large as is readable
/// when the sheet is as wide as a page of a paper. Words too long for their place are smaller, then
/// cut, with a `~`. No bands give a sheet of the legend alone.
[[nodiscard]] Sheet lay_out(const std::vector<GridBand>& bands,
                            const std::vector<std::vector<LegendEntry>>& legend);

}  // namespace ink::report
