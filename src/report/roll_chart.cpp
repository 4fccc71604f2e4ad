#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "report/html.h"
#include "report/motion_chart.h"

namespace ink::report {
namespace {

constexpr double kWidth = 1000;
constexpr double kLeft = 128;  // method names and the scale's labels
constexpr double kRight = 14;
constexpr double kTop = 12;
constexpr double kPanelHeight = 76;
constexpr double kPanelStep = 100;
constexpr double kBottom = 40;
constexpr std::string_view kFaint = "#5b6470";
constexpr std::string_view kGrid = R"(stroke="#e6e8eb" stroke-width="1")";

double degrees(double angle_rad) {
    return angle_rad * 180 / std::numbers::pi;
}

double x_at(double roll_deg) {
    return kLeft + (kWidth - kLeft - kRight) * roll_deg / 360;
}

/// The place of one method's panel.
struct Panel {
    double top;

    [[nodiscard]] double y_at(double recall) const { return top + kPanelHeight * (1 - recall); }
};

void draw_frame(Svg& svg, const Panel& panel, const std::string& method) {
    for (int turn_deg = 0; turn_deg <= 360; turn_deg += 30) {
        svg.line(x_at(turn_deg), panel.top, x_at(turn_deg), panel.y_at(0), kGrid);
    }
    for (const double recall : {0.0, 0.5, 1.0}) {
        svg.line(x_at(0), panel.y_at(recall), x_at(360), panel.y_at(recall), kGrid);
        svg.text(
            kLeft - 8, panel.y_at(recall) + 4, fmt::format("{:g}", recall), {"end", kFaint, 11});
    }
    svg.text(kLeft - 36,
             panel.y_at(0.5) + 4,
             method.size() <= 13 ? method : method.substr(0, 12) + "~",
             {.anchor = "end", .is_bold = true});
}

/// Bands of angles at which the filter cannot show a crease.
void shade_blind(Svg& svg, const Panel& panel, const studies::RollCurve& curve) {
    if (curve.samples.size() < 2) return;
    const double step_deg = 360.0 / static_cast<double>(curve.samples.size());
    const std::string style =
        fmt::format(R"(fill="{}" opacity="0.16")", colour_of_crease(curve.crease).hex);
    for (std::size_t i = 0; i < curve.samples.size(); ++i) {
        if (!curve.samples[i].is_blind) continue;
        std::size_t last = i;
        while (last + 1 < curve.samples.size() && curve.samples[last + 1].is_blind)
            ++last;
        const double from = std::max(0.0, degrees(curve.samples[i].roll_rad) - step_deg / 2);
        const double to = std::min(360.0, degrees(curve.samples[last].roll_rad) + step_deg / 2);
        svg.rect({x_at(from), panel.top, x_at(to) - x_at(from), kPanelHeight}, style);
        i = last;
    }
}

void draw_curve(Svg& svg, const Panel& panel, const studies::RollCurve& curve) {
    const std::string_view colour = colour_of_crease(curve.crease).hex;
    for (const studies::Vanishing& at : curve.vanishing) {
        const double x = x_at(degrees(at.predicted_rad));
        svg.raw(fmt::format(
            "<g><title>crease {}: predicted {:.1f}°, measured {}</title>",
            curve.crease + 1,
            degrees(at.predicted_rad),
            at.measured_rad ? fmt::format("{:.1f}°", degrees(*at.measured_rad)) : "nowhere"));
        svg.line(x,
                 panel.top - 6,
                 x,
                 panel.y_at(0) + 4,
                 fmt::format(R"(stroke="{}" stroke-width="1.2" stroke-dasharray="4 3")", colour));
        if (at.recall_there) {
            svg.circle(x,
                       panel.y_at(*at.recall_there),
                       3.2,
                       fmt::format(R"(fill="{}" stroke="#fff")", colour));
        }
        svg.raw("</g>");
    }
    std::vector<double> xy;
    for (const studies::RollSample& sample : curve.samples) {
        xy.push_back(x_at(degrees(sample.roll_rad)));
        xy.push_back(panel.y_at(sample.recall()));
    }
    svg.polyline(xy, fmt::format(R"(stroke="{}" stroke-width="1.6")", colour));
}

}  // namespace

draw::Colour colour_of_crease(int crease) {
    constexpr std::array kColours = {draw::kBlue, draw::kVermilion, draw::kGreen};
    return kColours[static_cast<std::size_t>(crease) % kColours.size()];
}

Svg roll_chart(const std::vector<studies::RollCurve>& curves) {
    std::vector<std::string> methods;
    for (const studies::RollCurve& curve : curves) {
        if (curve.is_predicted && (methods.empty() || methods.back() != curve.method)) {
            methods.push_back(curve.method);
        }
    }
    if (methods.empty()) {
        Svg svg(kWidth, 80);
        svg.text(kWidth / 2, 44, "No method here declares a code.", {"middle", kFaint, 14});
        return svg;
    }
    const double bottom = kTop + kPanelStep * static_cast<double>(methods.size());
    Svg svg(kWidth, bottom + kBottom - (kPanelStep - kPanelHeight));
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const Panel panel{kTop + kPanelStep * static_cast<double>(i)};
        draw_frame(svg, panel, methods[i]);
        const auto is_here = [&](const studies::RollCurve& curve) {
            return curve.method == methods[i] && curve.is_predicted;
        };
        for (const studies::RollCurve& curve : curves) {
            if (is_here(curve)) shade_blind(svg, panel, curve);
        }
        for (const studies::RollCurve& curve : curves) {
            if (is_here(curve)) draw_curve(svg, panel, curve);
        }
    }
    const double axis = bottom - (kPanelStep - kPanelHeight);
    for (int turn_deg = 0; turn_deg <= 360; turn_deg += 30) {
        const std::string text = fmt::format("{}°", turn_deg);
        svg.text(x_at(turn_deg), axis + 18, text, {"middle", kFaint, 12});
    }
    svg.text(x_at(180), axis + 36, "roll of the camera", {"middle", kFaint});
    return svg;
}

}  // namespace ink::report
