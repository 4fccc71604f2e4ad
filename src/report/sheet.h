#pragma once

#include <string>
#include <vector>

#include "draw/error_image.h"
#include "draw/palette.h"
#include "report/svg.h"

namespace ink::report {

/// A line over a picture.
struct SheetLine {
    std::vector<double> xy;  ///< x, y, x, y, ... in the sheet's pixels, y down
    draw::Colour colour;
    double width_px = 1;
};

/// A text on a sheet; `y` is its base line.
struct SheetText {
    double x = 0;
    double y = 0;
    std::string words;
    TextStyle style;
};

/// Pictures with words round them: one layout that comes out as a PNG (letters as pixels) and as an
/// SVG (letters as letters, pictures inside). Coordinates are pixels, y down.
class Sheet {
  public:
    Sheet(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}

    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return height_px_; }

    /// A picture with a thin frame round it. It must lie on the sheet.
    void image(int left, int top, draw::RgbImage image);
    void line(SheetLine line) { lines_.push_back(std::move(line)); }
    /// A filled box.
    void box(const Box& box, const draw::Colour& colour);
    /// Words; letters outside ASCII become `?` in the PNG.
    void text(SheetText text);

    /// Where the words stand, as wide as in the wider of both files.
    [[nodiscard]] std::vector<Box> text_boxes() const;

    [[nodiscard]] draw::RgbImage raster() const;
    [[nodiscard]] std::string svg(std::string_view title) const;

  private:
    struct Placed {
        int left;
        int top;
        draw::RgbImage image;
    };
    struct Filled {
        Box box;
        draw::Colour colour;
    };

    int width_px_;
    int height_px_;
    std::vector<Placed> images_;
    std::vector<Filled> boxes_;
    std::vector<SheetLine> lines_;
    std::vector<SheetText> texts_;
};

/// How wide `words` come out at most, in pixels, on a sheet of either kind.
[[nodiscard]] double sheet_text_width(const std::string& words, const TextStyle& style);

/// `words` cut so that they are at most `width_px` wide; what was cut is a `~`.
[[nodiscard]] std::string fitting(std::string words, const TextStyle& style, double width_px);

}  // namespace ink::report
