#include "report/figure_legend.h"

#include <fmt/format.h>

#include <array>

#include "experiment/summary/cause_totals.h"
#include "truth/line_class.h"

namespace ink::report {
namespace {

template <class T>
std::array<bool, 256> values_in(const core::Image<T>& image, std::array<bool, 256> seen) {
    for (std::size_t i = 0; i < image.size(); ++i)
        seen[static_cast<std::size_t>(image.data()[i])] = true;
    return seen;
}

}  // namespace

std::vector<std::vector<LegendEntry>> legend_of(
    const std::vector<FigureView>& views, const std::vector<const FigureEvaluation*>& evaluations) {
    std::array<bool, 256> marks{};
    std::array<bool, 256> labels{};
    for (const FigureEvaluation* evaluation : evaluations)
        marks = values_in(evaluation->marks, marks);
    for (const FigureView& view : views)
        labels = values_in(view.truth.traced.labels, labels);
    const auto has = [&marks](draw::Mark mark) { return marks[static_cast<std::size_t>(mark)]; };

    std::vector<LegendEntry> misses = {{draw::kHitColour, "right"}};
    for (const score::Cause cause : score::kFalseNegativeCauses) {
        if (has(draw::mark_of(cause)))
            misses.push_back(
                {draw::colour_of(cause), fmt::format("missing: {}", experiment::label_of(cause))});
    }
    std::vector<LegendEntry> extras;
    for (const score::Cause cause : score::kFalsePositiveCauses) {
        if (has(draw::mark_of(cause)))
            extras.push_back(
                {draw::colour_of(cause), fmt::format("false: {}", experiment::label_of(cause))});
    }
    if (has(draw::Mark::ignored)) extras.push_back({draw::kIgnoredColour, "not counted"});
    std::vector<LegendEntry> classes;
    for (const truth::LineClass c : truth::kLineClasses) {
        if (labels[static_cast<std::size_t>(c)])
            classes.push_back({draw::colour_of(c), fmt::format("truth: {}", truth::name(c))});
    }
    return {misses, extras, classes};
}

}  // namespace ink::report
