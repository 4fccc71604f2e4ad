#include "draw/line_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "draw/svg_lines.h"

namespace ink::draw {
namespace {

/// A file of groups, each a code and a value.
class Dxf {
  public:
    Dxf& add(int code, std::string_view value) {
        text_ += fmt::format("{}\n{}\n", code, value);
        return *this;
    }
    Dxf& add(int code, double value) {
        return add(code, fmt::format("{:.{}f}", value, kSheetDecimals));
    }
    Dxf& add(int code, int value) { return add(code, fmt::format("{}", value)); }
    /// A point, or of other codes than 10 the like.
    Dxf& add_point(int code, double x, double y) {
        return add(code, x).add(code + 10, y).add(code + 20, 0.0);
    }

    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// As a file of release 12 calls things: in ASCII capitals.
std::string layer_of(truth::LineClass c, bool is_hidden) {
    std::string name = fmt::format("{}{}", is_hidden ? "hidden-" : "", truth::name(c));
    for (char& letter : name)
        letter = letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
    return name;
}

/// Comments are ASCII, too, and one line.
std::string plain(std::string text) {
    std::ranges::replace_if(
        text, [](char letter) { return letter < ' ' || letter > '~'; }, '?');
    return text;
}

void add_line_types(Dxf& dxf) {
    constexpr std::array<double, 2> kDash_mm{1.5, -0.75};  // as in an SVG drawing
    dxf.add(0, "TABLE").add(2, "LTYPE").add(70, 2);
    dxf.add(0, "LTYPE").add(2, "CONTINUOUS").add(70, 0).add(3, "Solid line");
    dxf.add(72, 65).add(73, 0).add(40, 0.0);
    dxf.add(0, "LTYPE").add(2, "HIDDEN").add(70, 0).add(3, "__ __ __ __");
    dxf.add(72, 65).add(73, 2).add(40, kDash_mm[0] - kDash_mm[1]);
    dxf.add(49, kDash_mm[0]).add(49, kDash_mm[1]);
    dxf.add(0, "ENDTAB");
}

void add_layers(Dxf& dxf) {
    constexpr int kBlackOrWhite = 7, kGrey = 8;
    dxf.add(0, "TABLE").add(2, "LAYER").add(70, static_cast<int>(2 * std::size(kDrawnOrder)));
    for (const bool is_hidden : {true, false}) {
        for (const truth::LineClass c : kDrawnOrder) {
            dxf.add(0, "LAYER").add(2, layer_of(c, is_hidden)).add(70, 0);
            dxf.add(62, is_hidden ? kGrey : kBlackOrWhite);
            dxf.add(6, is_hidden ? "HIDDEN" : "CONTINUOUS");
        }
    }
    dxf.add(0, "ENDTAB");
}

/// Rounded as in an SVG drawing before y is turned, so that both hold the same places.
std::vector<glm::dvec2> points_of(const truth::Polyline& line, const Sheet& sheet) {
    const auto steps = [](double mm) { return std::round(mm * 10000); };
    const double height = steps(sheet.height_mm);
    std::vector<glm::dvec2> points;
    for (const truth::CurvePoint& p : line.points) {
        points.push_back({steps(sheet.left_mm + p.x_px * sheet.mm_per_px) / 10000,
                          (height - steps(sheet.top_mm + p.y_px * sheet.mm_per_px)) / 10000});
    }
    return points;
}

void add_line(Dxf& dxf, std::vector<glm::dvec2> points, const std::string& layer) {
    if (points.size() == 2) {
        dxf.add(0, "LINE").add(8, layer);
        dxf.add_point(10, points[0].x, points[0].y);
        dxf.add_point(11, points[1].x, points[1].y);
        return;
    }
    const bool is_closed = points.size() > 3 && points.front() == points.back();
    if (is_closed) points.pop_back();
    dxf.add(0, "POLYLINE").add(8, layer).add(66, 1).add_point(10, 0, 0).add(70, is_closed ? 1 : 0);
    for (const glm::dvec2& p : points)
        dxf.add(0, "VERTEX").add(8, layer).add_point(10, p.x, p.y);
    dxf.add(0, "SEQEND").add(8, layer);
}

void add_group(Dxf& dxf,
               std::span<const truth::Polyline> lines,
               bool is_hidden,
               const Sheet& sheet) {
    for (const truth::LineClass c : kDrawnOrder) {
        for (const truth::Polyline& line : lines)
            if (line.line_class == c) add_line(dxf, points_of(line, sheet), layer_of(c, is_hidden));
    }
}

}  // namespace

std::string dxf_drawing(const DrawnLines& lines,
                        const std::string& scene_name,
                        const scene::View& view,
                        const Sheet& sheet) {
    Dxf dxf;
    dxf.add(999, plain(fmt::format("{} {}, in mm", scene_name, view.camera.name)));
    dxf.add(0, "SECTION").add(2, "HEADER").add(9, "$ACADVER").add(1, "AC1009");
    dxf.add(9, "$EXTMIN").add_point(10, 0, 0);
    dxf.add(9, "$EXTMAX").add_point(10, sheet.width_mm, sheet.height_mm);
    dxf.add(9, "$LTSCALE").add(40, 1.0);
    dxf.add(0, "ENDSEC").add(0, "SECTION").add(2, "TABLES");
    add_line_types(dxf);
    add_layers(dxf);
    dxf.add(0, "ENDSEC").add(0, "SECTION").add(2, "ENTITIES");
    add_group(dxf, lines.hidden, true, sheet);
    add_group(dxf, lines.visible, false, sheet);
    dxf.add(0, "ENDSEC").add(0, "EOF");
    return dxf.text();
}

}  // namespace ink::draw
