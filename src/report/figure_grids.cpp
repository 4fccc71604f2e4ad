#include "report/figure_grids.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/text_table.h"
#include "report/figure_legend.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

constexpr std::size_t kMethodsInBand = 6;
constexpr std::size_t kBuffersInBand = 7;
constexpr int kCell_px = 320;  // wider pictures are shrunk by a whole factor

int shrink_factor(int width_px) {
    return std::max(1, (width_px + kCell_px / 2) / kCell_px);
}

/// `image` at 1/factor of its size: each pixel the mean of its block.
draw::RgbImage averaged(const draw::RgbImage& image, int factor) {
    if (factor == 1) return image;
    const auto shrunk = [factor](int size) { return (size + factor - 1) / factor; };
    draw::RgbImage small(shrunk(image.width_px()), shrunk(image.height_px()));
    for (int y = 0; y < small.height_px(); ++y) {
        for (int x = 0; x < small.width_px(); ++x) {
            glm::ivec3 sum{0};
            int count = 0;
            for (int v = y * factor; v < std::min((y + 1) * factor, image.height_px()); ++v) {
                for (int u = x * factor; u < std::min((x + 1) * factor, image.width_px()); ++u) {
                    sum += glm::ivec3(image.at(u, v));
                    ++count;
                }
            }
            small.at(x, y) = glm::u8vec3((sum + count / 2) / count);
        }
    }
    return small;
}

GridCell errors_cell(const FigureEvaluation& evaluation) {
    const int factor = shrink_factor(evaluation.marks.width_px());
    return {draw::error_image(draw::shrink(evaluation.marks, factor)),
            "F " + core::format_share(evaluation.row.f_2px)};
}

GridCell truth_cell(const FigureView& view) {
    const auto& labels = view.truth.traced.labels;
    return {draw::truth_image(draw::shrink(labels, shrink_factor(labels.width_px())))};
}

GridCell layer_cell(const FigureEvaluation& evaluation, std::string_view name) {
    for (const method::Layer& layer : evaluation.layers) {
        if (layer.name == name) return {averaged(layer.rgb, shrink_factor(layer.rgb.width_px()))};
    }
    return {};
}

bool has_layer(const FigureEvaluation& evaluation, std::string_view name) {
    return std::any_of(evaluation.layers.begin(),
                       evaluation.layers.end(),
                       [&](const method::Layer& layer) { return layer.name == name; });
}

/// Methods that drew at least one of the views, in their order.
std::vector<std::string> methods_of(const std::vector<FigureView>& views) {
    std::vector<std::string> methods;
    for (const FigureView& view : views) {
        for (const FigureEvaluation& evaluation : view.evaluations) {
            if (std::find(methods.begin(), methods.end(), evaluation.row.method) == methods.end())
                methods.push_back(evaluation.row.method);
        }
    }
    return methods;
}

const FigureEvaluation* find_evaluation(const FigureView& view, const std::string& method) {
    for (const FigureEvaluation& evaluation : view.evaluations) {
        if (evaluation.row.method == method) return &evaluation;
    }
    return nullptr;
}

GridRow strip_row(const FigureView& view, const std::vector<std::string>& methods) {
    double best = 0;
    for (const FigureEvaluation& evaluation : view.evaluations)
        best = std::max(best, evaluation.row.f_2px.value_or(0));
    GridRow row{view.scene, view.view, {truth_cell(view)}};
    for (const std::string& method : methods) {
        const FigureEvaluation* evaluation = find_evaluation(view, method);
        row.cells.push_back(evaluation == nullptr ? GridCell{{}, "failed"}
                                                  : errors_cell(*evaluation));
        row.cells.back().is_strong = evaluation != nullptr && evaluation->row.f_2px == best;
    }
    return row;
}

/// `names` in runs of nearly even length, at most `most` in each.
std::vector<std::vector<std::string>> even_runs(const std::vector<std::string>& names,
                                                std::size_t most) {
    const std::size_t runs = std::max<std::size_t>(1, (names.size() + most - 1) / most);
    std::vector<std::vector<std::string>> parts(runs);
    for (std::size_t i = 0; i < names.size(); ++i)
        parts[i * runs / names.size()].push_back(names[i]);
    return parts;
}

/// One scene's buffers of some methods.
GridBand buffers_band(const FigureView& view, const std::vector<std::string>& methods) {
    GridBand band{fmt::format("{}, {}", view.scene, view.view), {}, {}};
    band.rows = {{"packed", "what is stored", {}},
                 {"filtered", "edge response", {}},
                 {"errors", "at its threshold", {}}};
    const auto full = std::find_if(
        view.evaluations.begin(), view.evaluations.end(), [](const FigureEvaluation& s) {
            return has_layer(s, "depth") && has_layer(s, "normal");
        });
    if (full != view.evaluations.end()) {
        band.columns.push_back("full buffers");
        band.rows[0].cells.push_back(layer_cell(*full, "depth"));
        band.rows[1].cells.push_back(layer_cell(*full, "normal"));
        band.rows[0].cells[0].caption = "depth";
        band.rows[1].cells[0].caption = "normal";
    } else {
        band.columns.push_back("");
        for (int i = 0; i < 2; ++i)
            band.rows[static_cast<std::size_t>(i)].cells.emplace_back();
    }
    band.rows[2].cells.push_back(truth_cell(view));
    band.rows[2].cells[0].caption = "truth";
    for (const std::string& method : methods) {
        const FigureEvaluation* evaluation = find_evaluation(view, method);
        band.columns.push_back(method);
        band.rows[0].cells.push_back(evaluation == nullptr ? GridCell{}
                                                           : layer_cell(*evaluation, "packed"));
        band.rows[1].cells.push_back(evaluation == nullptr ? GridCell{}
                                                           : layer_cell(*evaluation, "filtered"));
        band.rows[2].cells.push_back(evaluation == nullptr ? GridCell{} : errors_cell(*evaluation));
    }
    return band;
}

}  // namespace

GridFigure strips_figure(const std::vector<FigureView>& views) {
    GridFigure figure;
    std::vector<const FigureEvaluation*> evaluations;
    for (const FigureView& view : views) {
        for (const FigureEvaluation& evaluation : view.evaluations)
            evaluations.push_back(&evaluation);
    }
    for (const std::vector<std::string>& methods : even_runs(methods_of(views), kMethodsInBand)) {
        GridBand band{"", {"truth"}, {}};
        band.columns.insert(band.columns.end(), methods.begin(), methods.end());
        for (const FigureView& view : views)
            band.rows.push_back(strip_row(view, methods));
        figure.bands.push_back(std::move(band));
    }
    figure.legend = legend_of(views, evaluations);
    return figure;
}

GridFigure buffers_figure(const std::vector<FigureView>& views) {
    GridFigure figure;
    std::vector<std::string> packed;
    bool has_full = false;
    std::vector<const FigureEvaluation*> shown;
    for (const FigureView& view : views) {
        for (const FigureEvaluation& evaluation : view.evaluations) {
            has_full =
                has_full || (has_layer(evaluation, "depth") && has_layer(evaluation, "normal"));
            if (!has_layer(evaluation, "packed")) continue;
            shown.push_back(&evaluation);
            if (std::find(packed.begin(), packed.end(), evaluation.row.method) == packed.end())
                packed.push_back(evaluation.row.method);
        }
    }
    if (packed.empty() && !has_full) return figure;
    for (const FigureView& view : views) {
        for (const std::vector<std::string>& methods : even_runs(packed, kBuffersInBand))
            figure.bands.push_back(buffers_band(view, methods));
    }
    figure.legend = legend_of(views, shown);
    return figure;
}

}  // namespace ink::report
