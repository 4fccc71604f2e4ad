#include "report/picture_grid.h"

#include <algorithm>
#include <cmath>

namespace ink::report {
namespace {

constexpr int kMargin_px = 12;
constexpr int kLeastWidth_px = 640;
constexpr std::string_view kSoft = "#4b535e";

/// Sizes of everything, from the number and the size of the pictures.
struct Measures {
    int cell_width_px = 1;
    int cell_height_px = 1;
    int columns = 1;
    double letter_px = 14;
    int gutter_px = 0;  ///< labels of rows
    int gap_px = 8;

    explicit Measures(const std::vector<GridBand>& bands) {
        for (const GridBand& band : bands) {
            columns = std::max(columns, static_cast<int>(band.columns.size()));
            for (const GridRow& row : band.rows)
                measure(row);
        }
        // On a page 7 inches wide a 76th of the width is 6.6 points.
        const int images_px = columns * (cell_width_px + gap_px);
        letter_px = std::clamp(images_px / 76.0, 13.0, 30.0);
        for (const GridBand& band : bands) {
            for (const GridRow& row : band.rows) {
                const double label = sheet_text_width(row.label, label_style());
                const double note = sheet_text_width(row.note, note_style());
                gutter_px = std::max(gutter_px, static_cast<int>(std::max(label, note)));
            }
        }
        gutter_px = std::min(gutter_px, std::max(200, images_px / 5));
        if (gutter_px > 0) gutter_px += static_cast<int>(letter_px);
    }

    [[nodiscard]] TextStyle label_style() const { return {"start", "#20242a", letter_px, true}; }
    [[nodiscard]] TextStyle note_style() const { return {"start", kSoft, 0.86 * letter_px}; }
    [[nodiscard]] TextStyle heading_style() const { return {"middle", "#20242a", letter_px, true}; }
    [[nodiscard]] TextStyle caption_style(bool is_strong) const {
        return {"middle", "#20242a", 0.94 * letter_px, is_strong};
    }
    [[nodiscard]] TextStyle title_style() const {
        return {"start", "#20242a", 1.1 * letter_px, true};
    }

    [[nodiscard]] int line_px() const { return static_cast<int>(std::lround(1.45 * letter_px)); }
    [[nodiscard]] int width_px() const {
        return std::max(kLeastWidth_px,
                        2 * kMargin_px + gutter_px + columns * (cell_width_px + gap_px) - gap_px);
    }
    [[nodiscard]] int column_left(std::size_t column) const {
        return kMargin_px + gutter_px + static_cast<int>(column) * (cell_width_px + gap_px);
    }
    [[nodiscard]] int row_px(const GridRow& row) const {
        const bool has_captions = std::any_of(
            row.cells.begin(), row.cells.end(), [](const auto& c) { return !c.caption.empty(); });
        return cell_height_px + (has_captions ? line_px() : 0) + gap_px;
    }
    [[nodiscard]] int band_px(const GridBand& band) const {
        int height =
            (band.columns.empty() ? 0 : line_px()) + (band.title.empty() ? 0 : line_px() + gap_px);
        for (const GridRow& row : band.rows)
            height += row_px(row);
        return height + 2 * gap_px;
    }

  private:
    void measure(const GridRow& row) {
        columns = std::max(columns, static_cast<int>(row.cells.size()));
        for (const GridCell& cell : row.cells) {
            cell_width_px = std::max(cell_width_px, cell.image.width_px());
            cell_height_px = std::max(cell_height_px, cell.image.height_px());
        }
    }
};

/// Words in letters small enough for their room; what is too long even so is cut.
SheetText fitted(SheetText text, double room_px) {
    constexpr double kSmallest = 0.7;
    const double width = sheet_text_width(text.words, text.style);
    if (width > room_px) text.style.size *= std::max(kSmallest, 0.99 * room_px / width);
    text.words = fitting(std::move(text.words), text.style, room_px);
    return text;
}

/// Legend entries broken into lines that fit.
std::vector<std::vector<LegendEntry>> legend_lines(
    const std::vector<std::vector<LegendEntry>>& groups, const Measures& m) {
    std::vector<std::vector<LegendEntry>> lines;
    const double room = m.width_px() - 2 * kMargin_px;
    for (const std::vector<LegendEntry>& group : groups) {
        double used = room + 1;  // the first entry begins a line
        for (const LegendEntry& entry : group) {
            const double width = sheet_text_width(entry.words, m.note_style()) + 3.2 * m.letter_px;
            if (used + width > room) {
                lines.emplace_back();
                used = 0;
            }
            lines.back().push_back(entry);
            used += width;
        }
    }
    return lines;
}

void put_legend_line(Sheet& sheet,
                     int top,
                     const std::vector<LegendEntry>& entries,
                     const Measures& m) {
    double x = kMargin_px;
    const double side = std::round(0.86 * m.letter_px);
    for (const LegendEntry& entry : entries) {
        sheet.box({x, top + 0.3 * m.letter_px, side, side}, entry.colour);
        x += side + 0.5 * m.letter_px;
        sheet.text({x, top + 1.08 * m.letter_px, entry.words, m.note_style()});
        x = std::round(x + sheet_text_width(entry.words, m.note_style()) + 1.6 * m.letter_px);
    }
}

void put_image(Sheet& sheet, int left, int top, const GridCell& cell) {
    if (!cell.image.is_empty()) sheet.image(left, top, cell.image);
    for (SheetLine line : cell.lines) {
        for (std::size_t k = 0; k + 1 < line.xy.size(); k += 2) {
            line.xy[k] += left;
            line.xy[k + 1] += top;
        }
        sheet.line(std::move(line));
    }
}

void put_row(Sheet& sheet, int top, const GridRow& row, const Measures& m) {
    const double middle = top + m.cell_height_px / 2.0;
    const double room = m.gutter_px - 0.7 * m.letter_px;
    sheet.text(fitted({kMargin_px,
                       row.note.empty() ? middle + 0.35 * m.letter_px : middle,
                       row.label,
                       m.label_style()},
                      room));
    sheet.text(fitted({kMargin_px, middle + 1.25 * m.letter_px, row.note, m.note_style()}, room));
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const GridCell& cell = row.cells[i];
        const int left = m.column_left(i);
        put_image(sheet,
                  left + (m.cell_width_px - cell.image.width_px()) / 2,
                  top + (m.cell_height_px - cell.image.height_px()) / 2,
                  cell);
        const TextStyle style = m.caption_style(cell.is_strong);
        sheet.text(fitted({left + m.cell_width_px / 2.0,
                           top + m.cell_height_px + 1.12 * m.letter_px,
                           cell.caption,
                           style},
                          m.cell_width_px));
    }
}

void put_band(Sheet& sheet, int top, const GridBand& band, const Measures& m) {
    if (!band.title.empty()) {
        const double room = m.width_px() - 2 * kMargin_px;
        sheet.text(
            fitted({kMargin_px, top + 1.1 * m.letter_px, band.title, m.title_style()}, room));
        top += m.line_px() + m.gap_px;
    }
    for (std::size_t i = 0; i < band.columns.size(); ++i) {
        sheet.text(fitted({m.column_left(i) + m.cell_width_px / 2.0,
                           top + 0.95 * m.letter_px,
                           band.columns[i],
                           m.heading_style()},
                          m.cell_width_px));
    }
    if (!band.columns.empty()) top += m.line_px();
    for (const GridRow& row : band.rows) {
        put_row(sheet, top, row, m);
        top += m.row_px(row);
    }
}

}  // namespace

Sheet lay_out(const std::vector<GridBand>& bands,
              const std::vector<std::vector<LegendEntry>>& legend) {
    const Measures m(bands);
    const auto lines = legend_lines(legend, m);
    int height = 2 * kMargin_px + static_cast<int>(lines.size()) * m.line_px();
    for (const GridBand& band : bands)
        height += m.band_px(band);
    Sheet sheet(m.width_px(), height);
    int top = kMargin_px;
    for (const GridBand& band : bands) {
        put_band(sheet, top, band, m);
        top += m.band_px(band);
    }
    for (const auto& line : lines) {
        put_legend_line(sheet, top, line, m);
        top += m.line_px();
    }
    return sheet;
}

}  // namespace ink::report
