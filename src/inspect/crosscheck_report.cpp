#include "inspect/crosscheck_report.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

#include "draw/palette.h"
#include "image_io/image_file.h"

namespace ink::inspect {
namespace {

constexpr int kScale = 2;
constexpr int kShift = 4;  ///< fractional bits of OpenCV's coordinates

std::string percent(double share) {
    return fmt::format("{:.3f} %", 100 * share);
}

std::string class_line(std::string_view name, const harness::ClassAgreement& c) {
    return fmt::format("{:<14} {:>12.1f} {:>12} {:>12.1f} {:>12}{}\n",
                       name,
                       c.truth_px,
                       percent(c.truth_share()),
                       c.crosscheck_px,
                       percent(c.crosscheck_share()),
                       c.is_agreed() ? "" : "   disagree");
}

cv::Scalar scalar_of(const draw::Colour& colour) {
    return {static_cast<double>(colour.rgb.r),
            static_cast<double>(colour.rgb.g),
            static_cast<double>(colour.rgb.b)};
}

cv::Point point_of(double x_px, double y_px) {
    const auto fixed = [](double v) {
        return static_cast<int>(std::lround((v * kScale - 0.5) * (1 << kShift)));
    };
    return {fixed(x_px), fixed(y_px)};
}

void add_legend(cv::Mat& mat) {
    const auto line = [&](int row, const std::string& text, const draw::Colour& colour) {
        cv::putText(mat,
                    text,
                    {12, 28 + 26 * row},
                    cv::FONT_HERSHEY_SIMPLEX,
                    0.7,
                    scalar_of(colour),
                    2,
                    cv::LINE_AA);
    };
    line(0, "both", draw::kIgnoredColour);
    line(1, "curves only", draw::kVermilion);
    line(2, "cross-check only", draw::kBlue);
    line(3, "cross-check abstains", draw::kOrange);
}

}  // namespace

std::string crosscheck_summary(const harness::Crosscheck& check,
                               std::span<const truth::Curve> curves) {
    std::string text = fmt::format("{:<14} {:>12} {:>12} {:>12} {:>12}\n",
                                   "crosscheck",
                                   "truth px",
                                   "seen",
                                   "cross-check px",
                                   "traced");
    for (std::size_t i = 0; i < truth::kLineClasses.size(); ++i) {
        text += class_line(truth::name(truth::kLineClasses[i]), check.agreement.by_class[i]);
    }
    text += class_line("all", check.agreement.total());
    text += fmt::format(
        "within {} px; disagreement {} of both lengths, where a third construction sides against "
        "the truth; the cross-check abstains on {}\n"
        "looked {} times in {:.3f} s, across edges at {} places, closely at {} px; unexplained "
        "{}\n",
        harness::kAgreement_px,
        percent(check.agreement.disagreement_rate()),
        percent(check.agreement.abstained_share()),
        check.counts.rays,
        check.look_s,
        check.counts.probes,
        check.counts.refined_px,
        check.counts.unexplained);
    const double strip_px = harness::strip_length_px(curves, check.agreement);
    if (strip_px > 0) {
        text += fmt::format(
            "{:.1f} px of the truth that the cross-check lacks run within 1/32 px of another line: "
            "strips thinner than the distance between its samples\n",
            strip_px);
    }
    return text;
}

void write_disagreement(const scene::View& view,
                        std::span<const truth::Curve> curves,
                        const harness::Agreement& agreement,
                        const std::filesystem::path& path) {
    core::Image<image_io::Rgb> image(
        kScale * view.width_px, kScale * view.height_px, draw::kPaper.rgb);
    cv::Mat mat(image.height_px(), image.width_px(), CV_8UC3, image.data());
    for (const truth::Curve& curve : curves) {
        cv::line(mat,
                 point_of(curve.begin.x_px, curve.begin.y_px),
                 point_of(curve.end.x_px, curve.end.y_px),
                 scalar_of(draw::kIgnoredColour),
                 2,
                 cv::LINE_AA,
                 kShift);
    }
    for (const harness::Disagreement& d : agreement.disagreements) {
        cv::circle(mat,
                   point_of(d.x_px, d.y_px),
                   3 << kShift,
                   scalar_of(!d.is_confirmed ? draw::kOrange
                             : d.is_truth    ? draw::kVermilion
                                             : draw::kBlue),
                   cv::FILLED,
                   cv::LINE_AA,
                   kShift);
    }
    add_legend(mat);
    image_io::write_png(image, path);
}

std::string crosscheck_sentence(const std::vector<harness::Row>& rows) {
    std::set<std::pair<std::string, std::string>> views;
    double length_px = 0, uncovered_px = 0, abstained_px = 0;
    const harness::Row* worst = nullptr;
    for (const harness::Row& row : rows) {
        if (!row.reference_disagreement || !views.insert({row.scene, row.view}).second) continue;
        length_px += row.crosscheck_px;
        uncovered_px += *row.reference_disagreement * row.crosscheck_px;
        abstained_px += row.crosscheck_abstained * row.crosscheck_px;
        if (worst == nullptr || *row.reference_disagreement > *worst->reference_disagreement)
            worst = &row;
    }
    if (worst == nullptr) return "";
    return fmt::format(
        "The truth and its cross-check disagree on {} of their lines over {} views, at worst on {} "
        "({} {}); the cross-check abstains on {}.",
        percent(length_px > 0 ? uncovered_px / length_px : 0),
        views.size(),
        percent(*worst->reference_disagreement),
        worst->scene,
        worst->view,
        percent(length_px > 0 ? abstained_px / length_px : 0));
}

}  // namespace ink::inspect
