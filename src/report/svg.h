#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ink::report {

/// A rectangle on a drawing, in its units, y down.
struct Box {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;

    [[nodiscard]] bool overlaps(const Box& other) const {
        return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
               other.y < y + height;
    }
};

/// How a text stands on a drawing.
struct TextStyle {
    std::string_view anchor = "start";  ///< start | middle | end
    std::string_view fill = "#20242a";
    double size = 13;
    bool is_bold = false;
};

/// A drawing that is written piece by piece; coordinates are rounded to a tenth.
class Svg {
  public:
    Svg(double width, double height) : width_(width), height_(height) {}

    /// A straight line; `style` is SVG attributes, such as stroke="#000".
    void line(double x1, double y1, double x2, double y2, std::string_view style);
    void rect(const Box& box, std::string_view style);
    void circle(double x, double y, double radius, std::string_view style);
    /// A line through points x, y, x, y, ...
    void polyline(const std::vector<double>& xy, std::string_view style);
    /// A closed outline through points x, y, x, y, ...
    void polygon(const std::vector<double>& xy, std::string_view style);
    /// A text with its base line at `y`; escaped here.
    void text(double x, double y, std::string_view text, const TextStyle& style = {});
    /// A text turned a quarter to the left, centred on (x, y).
    void vertical_text(double x, double y, std::string_view text, const TextStyle& style);
    /// Ready-made SVG.
    void raw(std::string_view svg) { body_ += svg; }

    /// The drawing as an element of a page. `title` is read out by screen readers.
    [[nodiscard]] std::string inline_element(std::string_view title) const;
    /// The drawing as a file of its own, on white.
    [[nodiscard]] std::string file(std::string_view title) const;

  private:
    double width_;
    double height_;
    std::string body_;
};

/// Roughly how wide `text` is in a sans-serif face of `size`.
[[nodiscard]] double text_width(std::string_view text, double size);

}  // namespace ink::report
