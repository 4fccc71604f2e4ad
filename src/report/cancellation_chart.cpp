#include "report/cancellation_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/escape.h"
#include "draw/palette.h"
#include "linear_code/cancellation_law.h"

namespace ink::report {
namespace {

constexpr double kWidth = 1000;
constexpr double kTop = 40;  // the legend
constexpr double kHeading = 26;
constexpr double kPanel = 230;  // a square to the left, as high to the right
constexpr double kStep = kHeading + kPanel + 52;
constexpr double kScatterLeft = 62;
constexpr double kCurvesLeft = 372;
constexpr double kCurvesWidth = kWidth - kCurvesLeft - 16;
constexpr double kAllowed = 0.02;  // the two points beside the diagonal
constexpr std::string_view kFaint = "#5b6470";
constexpr std::string_view kGrid = R"(stroke="#e6e8eb" stroke-width="1")";
constexpr std::string_view kLaw = R"(stroke="#5b6470" stroke-width="1.2" stroke-dasharray="1.5 3")";

/// A panel with shares of 0..1 upwards and whatever it is across.
struct Panel {
    Box box;

    [[nodiscard]] double x_at(double share) const { return box.x + box.width * share; }
    [[nodiscard]] double y_at(double share) const { return box.y + box.height * (1 - share); }
};

struct MethodKinds {
    std::string method;
    std::vector<linear_code::CancellationTotal> kinds;  ///< those with enough pixels
    std::optional<double> silent_deg = {};              ///< of all its rows, if that is one value
};

std::vector<MethodKinds> by_method(const std::vector<linear_code::CancellationRow>& rows) {
    std::vector<MethodKinds> methods;
    for (linear_code::CancellationTotal& total : linear_code::cancellation_by_kind(rows)) {
        if (methods.empty() || methods.back().method != total.method)
            methods.push_back({total.method, {}});
        if (total.count.n_truth >= kFewPixels) methods.back().kinds.push_back(std::move(total));
    }
    for (MethodKinds& m : methods) {
        bool is_one = true;
        for (const linear_code::CancellationRow& row : rows) {
            if (row.method != m.method) continue;
            is_one = is_one && (!m.silent_deg || *m.silent_deg == row.silent_deg);
            m.silent_deg = row.silent_deg;
        }
        if (!is_one) m.silent_deg.reset();
    }
    return methods;
}

std::string title_of(const linear_code::CancellationTotal& total) {
    const linear_code::LineKind& kind = total.kind;
    const std::string bin =
        kind.dihedral_low_deg ? fmt::format(", {}-{}°",
                                            *kind.dihedral_low_deg,
                                            *kind.dihedral_low_deg + linear_code::kDihedralBin_deg)
                              : "";
    return fmt::format("{}, {}{}: predicted {:.1f} %, measured {:.1f} % of {} px",
                       total.method,
                       truth::name(kind.line_class),
                       bin,
                       100 * total.count.predicted_rate(),
                       100 * total.count.measured_rate(),
                       total.count.n_truth);
}

void draw_share_axis(Svg& svg, const Panel& panel) {
    for (int tick = 0; tick <= 4; ++tick) {
        const double y = panel.y_at(tick / 4.0);
        svg.line(panel.x_at(0), y, panel.x_at(1), y, kGrid);
        svg.text(panel.x_at(0) - 6, y + 4, fmt::format("{} %", 25 * tick), {"end", kFaint, 11});
    }
}

void draw_scatter(Svg& svg, const Panel& panel, const MethodKinds& m) {
    draw_share_axis(svg, panel);
    const double bottom = panel.y_at(0);
    for (int tick = 0; tick <= 4; ++tick) {
        const double x = panel.x_at(tick / 4.0);
        svg.line(x, panel.y_at(1), x, bottom, kGrid);
        svg.text(x, bottom + 16, fmt::format("{} %", 25 * tick), {"middle", kFaint, 11});
    }
    svg.polygon({panel.x_at(0),
                 panel.y_at(0),
                 panel.x_at(kAllowed),
                 panel.y_at(0),
                 panel.x_at(1),
                 panel.y_at(1 - kAllowed),
                 panel.x_at(1),
                 panel.y_at(1),
                 panel.x_at(1 - kAllowed),
                 panel.y_at(1),
                 panel.x_at(0),
                 panel.y_at(kAllowed)},
                R"(fill="#e6e8eb")");
    svg.line(panel.x_at(0), panel.y_at(0), panel.x_at(1), panel.y_at(1), R"(stroke="#9aa1ab")");
    std::vector<const linear_code::CancellationTotal*> order;
    for (const linear_code::CancellationTotal& total : m.kinds)
        order.push_back(&total);
    // Small points over large ones.
    std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
        return a->count.n_truth > b->count.n_truth;
    });
    for (const linear_code::CancellationTotal* total : order) {
        const double decades =
            std::log10(static_cast<double>(total->count.n_truth) / double{kFewPixels});
        svg.raw(fmt::format("<g><title>{}</title>", core::escape(title_of(*total))));
        svg.circle(panel.x_at(total->count.predicted_rate()),
                   panel.y_at(total->count.measured_rate()),
                   2.5 + 1.5 * decades,
                   fmt::format(R"(fill="{}" fill-opacity="0.75" stroke="#fff" stroke-width="0.8")",
                               draw::colour_of(total->kind.line_class).hex));
        svg.raw("</g>");
    }
    svg.text(panel.x_at(0.5), bottom + 34, "missed, predicted", {"middle", kFaint, 12});
    svg.vertical_text(panel.x_at(0) - 44, panel.y_at(0.5), "missed, measured", {"", kFaint, 12});
}

/// Neighbouring bins of one class, as the points of two lines.
struct Stretch {
    int last_low_deg = 0;
    std::vector<double> predicted;
    std::vector<double> measured;
};

void draw_stretch(Svg& svg, const Stretch& stretch, truth::LineClass line_class) {
    const std::string_view hex = draw::colour_of(line_class).hex;
    for (std::size_t i = 0; i + 1 < stretch.measured.size(); i += 2) {
        svg.circle(stretch.measured[i],
                   stretch.measured[i + 1],
                   3,
                   fmt::format(R"(fill="{}" fill-opacity="0.45")", hex));
        svg.circle(stretch.predicted[i],
                   stretch.predicted[i + 1],
                   3,
                   fmt::format(R"(fill="none" stroke="{}")", hex));
    }
    svg.polyline(stretch.measured,
                 fmt::format(R"(stroke="{}" stroke-width="4" stroke-opacity="0.35")", hex));
    svg.polyline(stretch.predicted,
                 fmt::format(R"(stroke="{}" stroke-width="1.5" stroke-dasharray="5 3")", hex));
}

void draw_curves(Svg& svg, const Panel& panel, const MethodKinds& m) {
    draw_share_axis(svg, panel);
    const double bottom = panel.y_at(0);
    for (int deviation_deg = 0; deviation_deg <= 180; deviation_deg += 30) {
        const double x = panel.x_at(deviation_deg / 180.0);
        svg.line(x, panel.y_at(1), x, bottom, kGrid);
        svg.text(x, bottom + 16, fmt::format("{}°", deviation_deg), {"middle", kFaint, 11});
    }
    if (m.silent_deg) {
        std::vector<double> xy;
        for (int deviation_deg = 0; deviation_deg <= 180; deviation_deg += 2) {
            constexpr double kRadians = std::numbers::pi / 180;
            xy.push_back(panel.x_at(deviation_deg / 180.0));
            xy.push_back(panel.y_at(
                linear_code::law_of_misses(deviation_deg * kRadians, *m.silent_deg * kRadians)));
        }
        svg.polyline(xy, kLaw);
    }
    std::map<truth::LineClass, std::vector<Stretch>> lines;
    for (const linear_code::CancellationTotal& total : m.kinds) {
        if (!total.kind.dihedral_low_deg) continue;
        const int low_deg = *total.kind.dihedral_low_deg;
        std::vector<Stretch>& stretches = lines[total.kind.line_class];
        if (stretches.empty() ||
            stretches.back().last_low_deg + linear_code::kDihedralBin_deg != low_deg)
            stretches.emplace_back();
        Stretch& stretch = stretches.back();
        stretch.last_low_deg = low_deg;
        const double x = panel.x_at((low_deg + linear_code::kDihedralBin_deg / 2.0) / 180);
        stretch.predicted.insert(stretch.predicted.end(),
                                 {x, panel.y_at(total.count.predicted_rate())});
        stretch.measured.insert(stretch.measured.end(),
                                {x, panel.y_at(total.count.measured_rate())});
    }
    for (const auto& [line_class, stretches] : lines) {
        for (const Stretch& stretch : stretches)
            draw_stretch(svg, stretch, line_class);
    }
    svg.text(panel.x_at(0.5),
             bottom + 34,
             "dihedral: how far the two faces deviate from flat",
             {"middle", kFaint, 12});
}

double legend_entry(Svg& svg, double x, std::string_view words) {
    svg.text(x, 18, words, {.size = 12});
    return x + 7 * static_cast<double>(words.size()) + 20;
}

void draw_legend(Svg& svg) {
    double x = 12;
    for (const truth::LineClass line_class : truth::kLineClasses) {
        svg.circle(x + 5, 14, 5, fmt::format(R"(fill="{}")", draw::colour_of(line_class).hex));
        x = legend_entry(svg, x + 15, truth::name(line_class));
    }
    x += 14;
    svg.line(x, 14, x + 26, 14, R"(stroke="#20242a" stroke-width="4" stroke-opacity="0.35")");
    x = legend_entry(svg, x + 32, "measured");
    svg.line(x, 14, x + 26, 14, R"(stroke="#20242a" stroke-width="1.5" stroke-dasharray="5 3")");
    x = legend_entry(svg, x + 32, "predicted");
    svg.line(x, 14, x + 26, 14, kLaw);
    legend_entry(svg, x + 32, "law of one linear sum");
}

}  // namespace

Svg cancellation_chart(const std::vector<linear_code::CancellationRow>& rows) {
    const std::vector<MethodKinds> methods = by_method(rows);
    if (methods.empty()) {
        Svg svg(kWidth, 80);
        svg.text(kWidth / 2, 44, "No method here declares a code.", {"middle", kFaint, 14});
        return svg;
    }
    Svg svg(kWidth, kTop + kStep * static_cast<double>(methods.size()));
    draw_legend(svg);
    double top = kTop;
    for (const MethodKinds& m : methods) {
        svg.text(12, top + 14, m.method, {.is_bold = true});
        if (m.silent_deg) {
            svg.text(kWidth - 16,
                     top + 14,
                     fmt::format("keeps dihedral deviations up to {:.1f}° silent", *m.silent_deg),
                     {"end", kFaint, 12});
        }
        draw_scatter(svg, {{kScatterLeft, top + kHeading, kPanel, kPanel}}, m);
        draw_curves(svg, {{kCurvesLeft, top + kHeading, kCurvesWidth, kPanel}}, m);
        top += kStep;
    }
    return svg;
}

}  // namespace ink::report
