#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "report/figure_grids.h"
#include "report/figure_legend.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

constexpr int kWindow_px = 64;

/// Sums over rectangles of an image of counts in constant time.
class AreaSums {
  public:
    explicit AreaSums(const draw::Marks& marks)
        : stride_(static_cast<std::size_t>(marks.width_px()) + 1),
          sums_(stride_ * (static_cast<std::size_t>(marks.height_px()) + 1)) {
        for (int y = 0; y < marks.height_px(); ++y) {
            int line = 0;
            for (int x = 0; x < marks.width_px(); ++x) {
                line += draw::is_wrong(marks.at(x, y)) ? 1 : 0;
                at(x + 1, y + 1) = at(x + 1, y) + line;
            }
        }
    }

    [[nodiscard]] int in(const Window& w) const {
        return at(w.left + w.width, w.top + w.height) - at(w.left, w.top + w.height) -
               at(w.left + w.width, w.top) + at(w.left, w.top);
    }

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x);
    }
    [[nodiscard]] int& at(int x, int y) { return sums_[index(x, y)]; }
    [[nodiscard]] int at(int x, int y) const { return sums_[index(x, y)]; }

    std::size_t stride_;
    std::vector<int> sums_;
};

/// The part of `image` in the window, each pixel kZoom x kZoom large.
draw::RgbImage enlarged(const draw::RgbImage& image, const Window& w) {
    draw::RgbImage large(w.width * kZoom, w.height * kZoom);
    for (int y = 0; y < large.height_px(); ++y) {
        for (int x = 0; x < large.width_px(); ++x)
            large.at(x, y) = image.at(w.left + x / kZoom, w.top + y / kZoom);
    }
    return large;
}

/// The part of a segment inside 0..width x 0..height (Liang and Barsky, 1984), if there is one.
std::optional<std::vector<double>> clipped(std::pair<double, double> a,
                                           std::pair<double, double> b,
                                           double width,
                                           double height) {
    const double dx = b.first - a.first;
    const double dy = b.second - a.second;
    double enter = 0;
    double leave = 1;
    const auto cut = [&](double along, double room) {  // inside where along * t <= room
        if (along == 0) return room >= 0;
        const double t = room / along;
        (along < 0 ? enter : leave) = along < 0 ? std::max(enter, t) : std::min(leave, t);
        return true;
    };
    const bool is_there = cut(-dx, a.first) && cut(dx, width - a.first) && cut(-dy, a.second) &&
                          cut(dy, height - a.second);
    if (!is_there || enter >= leave) return std::nullopt;
    return std::vector<double>{
        a.first + enter * dx, a.second + enter * dy, a.first + leave * dx, a.second + leave * dy};
}

/// The truth's lines in the window: dark on a white rim, so that they are seen on any colour.
std::vector<SheetLine> truth_lines(const truth::Truth& truth, const Window& w) {
    std::vector<SheetLine> rims;
    std::vector<SheetLine> cores;
    const auto place = [&](const truth::CurvePoint& p) {
        return std::pair((p.x_px - w.left) * kZoom, (p.y_px - w.top) * kZoom);
    };
    for (const truth::Curve& curve : truth.curves) {
        const auto xy =
            clipped(place(curve.begin), place(curve.end), w.width * kZoom, w.height * kZoom);
        if (!xy) continue;
        rims.push_back({*xy, draw::kPaper, 3});
        cores.push_back({*xy, draw::kInk, 1});
    }
    rims.insert(rims.end(), cores.begin(), cores.end());
    return rims;
}

/// The whole view, small, with the window on it; `width` is that of the other pictures.
GridCell where_cell(const FigureView& view, const Window& w, int width) {
    const auto& labels = view.truth.traced.labels;
    const int factor = std::max(1, (labels.width_px() + width - 1) / width);
    const double s = 1.0 / factor;
    const double left = w.left * s;
    const double right = (w.left + w.width) * s;
    const double top = w.top * s;
    const double bottom = (w.top + w.height) * s;
    GridCell cell{draw::truth_image(draw::shrink(labels, factor)),
                  fmt::format("{}: x {}..{}, y {}..{}",
                              view.scene,
                              w.left,
                              w.left + w.width - 1,
                              w.top,
                              w.top + w.height - 1)};
    cell.lines.push_back(
        {{left, top, right, top, right, bottom, left, bottom, left, top}, draw::kVermilion, 2});
    return cell;
}

std::vector<GridCell> layer_cells(const FigureEvaluation& evaluation,
                                  const FigureView& view,
                                  const Window& w) {
    std::vector<GridCell> cells;
    for (const method::Layer& layer : evaluation.layers) {
        if (cells.size() == 2) break;
        cells.push_back({enlarged(layer.rgb, w),
                         fmt::format("{}: {}", evaluation.row.method, layer.name),
                         truth_lines(view.truth.traced, w)});
    }
    return cells;
}

GridCell method_cell(const FigureEvaluation& evaluation,
                     const FigureView& view,
                     const Window& w,
                     int wrong) {
    return {enlarged(draw::error_image(evaluation.marks), w),
            fmt::format("{}: {} wrong here", evaluation.row.method, wrong),
            truth_lines(view.truth.traced, w)};
}

GridBand zoom_band(const FigureView& view, const FigureEvaluation& a, const FigureEvaluation& b) {
    const int width = std::min(kWindow_px, a.marks.width_px());
    const int height =
        std::clamp(width * a.marks.height_px() / a.marks.width_px(), 1, a.marks.height_px());
    const Window w = most_different(a.marks, b.marks, width, height);
    GridBand band;
    GridRow above;
    above.cells.push_back(where_cell(view, w, width * kZoom));
    above.cells.push_back({enlarged(draw::truth_image(view.truth.traced.labels), w),
                           "truth",
                           truth_lines(view.truth.traced, w)});
    above.cells.push_back(method_cell(a, view, w, AreaSums(a.marks).in(w)));
    above.cells.push_back(method_cell(b, view, w, AreaSums(b.marks).in(w)));
    band.rows.push_back(std::move(above));
    GridRow below;
    below.cells = layer_cells(a, view, w);
    for (GridCell& cell : layer_cells(b, view, w))
        below.cells.push_back(std::move(cell));
    if (!below.cells.empty()) band.rows.push_back(std::move(below));
    return band;
}

const FigureEvaluation* find_evaluation(const FigureView& view, const std::string& method) {
    const auto found =
        std::find_if(view.evaluations.begin(), view.evaluations.end(), [&](const auto& evaluation) {
            return evaluation.row.method == method;
        });
    return found == view.evaluations.end() ? nullptr : &*found;
}

/// The window that lies nearest to the mean of all; the first of equal ones.
Window middle_one(const std::vector<Window>& windows) {
    const auto count = static_cast<std::int64_t>(windows.size());
    std::int64_t left = 0;
    std::int64_t top = 0;
    for (const Window& w : windows) {
        left += w.left;
        top += w.top;
    }
    const auto away = [&](const Window& w) {
        return std::abs(count * w.left - left) + std::abs(count * w.top - top);
    };
    return *std::min_element(windows.begin(), windows.end(), [&](const Window& a, const Window& b) {
        return away(a) < away(b);
    });
}

}  // namespace

Window most_different(const draw::Marks& a, const draw::Marks& b, int width, int height) {
    const AreaSums of_a(a);
    const AreaSums of_b(b);
    std::pair<int, int> most{0, 0};
    std::vector<Window> equals = {
        {(a.width_px() - width) / 2, (a.height_px() - height) / 2, width, height}};
    for (int top = 0; top + height <= a.height_px(); ++top) {
        for (int left = 0; left + width <= a.width_px(); ++left) {
            const Window w{left, top, width, height};
            const int wrong_a = of_a.in(w);
            const int wrong_b = of_b.in(w);
            const std::pair<int, int> found{std::abs(wrong_a - wrong_b), wrong_a + wrong_b};
            if (found < most || found == std::pair(0, 0)) continue;
            if (found > most) equals.clear();
            most = found;
            equals.push_back(w);
        }
    }
    return middle_one(equals);
}

GridFigure zoom_figure(const std::vector<FigureView>& views,
                       const std::pair<std::string, std::string>& methods) {
    GridFigure figure;
    std::vector<const FigureEvaluation*> shown;
    for (const FigureView& view : views) {
        const FigureEvaluation* a = find_evaluation(view, methods.first);
        const FigureEvaluation* b = find_evaluation(view, methods.second);
        if (a == nullptr || b == nullptr) continue;
        figure.bands.push_back(zoom_band(view, *a, *b));
        shown.insert(shown.end(), {a, b});
    }
    if (!shown.empty()) figure.legend = legend_of(views, shown);
    return figure;
}

}  // namespace ink::report
