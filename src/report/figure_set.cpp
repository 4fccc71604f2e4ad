#include "report/figure_set.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/whole_file.h"
#include "experiment/summary/summary_csv.h"
#include "harness/out_folder.h"
#include "harness/tables/row_table.h"
#include "image_io/image_file.h"
#include "report/charts.h"
#include "report/error_time_chart.h"
#include "report/figure_grids.h"

namespace ink::report {
namespace {

using Pair = std::pair<std::string, std::string>;

/// One figure for figures.md.
struct Entry {
    std::string name;
    std::vector<std::string> files;  ///< none: there is nothing to show
    std::string caption;             ///< or why there is nothing
};

std::string rows_csv(const std::vector<harness::Row>& rows) {
    std::string text = harness::heading(harness::rows_table());
    std::int64_t cell = 0;
    for (const harness::Row& row : rows)
        text += harness::row_line(++cell, harness::Study::compare, row);
    return text;
}

bool takes_part(const FigureOptions& options, const std::string& method) {
    const auto& configs = options.drawing.configs;
    return std::any_of(configs.begin(), configs.end(), [&](const harness::MethodConfig& config) {
        return config.info->name == method;
    });
}

/// The methods to enlarge; equal ones if only one takes part.
Pair pair_of(const FigureOptions& options) {
    std::vector<std::string> names;
    for (const harness::MethodConfig& config : options.drawing.configs)
        names.push_back(config.info->name);
    if (options.pair) {
        for (const std::string& name : {options.pair->first, options.pair->second}) {
            if (takes_part(options, name)) continue;
            throw core::Error("--pair",
                              fmt::format("'{}' does not take part", name),
                              core::known_names(names, name));
        }
        return *options.pair;
    }
    if (takes_part(options, "mote4") && takes_part(options, "decaudin"))
        return {"mote4", "decaudin"};
    return {names.front(), names[std::min<std::size_t>(1, names.size() - 1)]};
}

/// Writes figures into a folder and keeps what figures.md says of them.
class Writer {
  public:
    explicit Writer(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void grid(const std::string& name, const GridFigure& figure, std::string caption) {
        const std::string png = name + ".png";
        const std::string svg = name + ".svg";
        if (figure.bands.empty()) return nothing(name, {png, svg}, std::move(caption));
        const Sheet sheet = lay_out(figure.bands, figure.legend);
        image_io::write_png(sheet.raster(), folder_ / png);
        core::write_whole_file(folder_ / svg, sheet.svg(name));
        entries_.push_back({name, {svg, png}, std::move(caption)});
    }

    void chart(const std::string& name, const Svg& chart, std::string caption) {
        const std::string svg = name + ".svg";
        core::write_whole_file(folder_ / svg, chart.file(name));
        entries_.push_back({name, {svg}, std::move(caption)});
    }

    void table(const std::string& file, const std::string& text, std::string caption) {
        core::write_whole_file(folder_ / file, text);
        entries_.push_back({file, {file}, std::move(caption)});
    }

    FigureFiles finish(const std::string& command) {
        std::string text = fmt::format("# Figures\n\nMade by `{}`.\n", command);
        FigureFiles files;
        for (const Entry& entry : entries_) {
            text += fmt::format("\n## {}\n\n", entry.name);
            const bool is_image = !entry.files.empty() && entry.files[0].ends_with(".svg");
            if (is_image) text += fmt::format("![{}]({})\n\n", entry.name, entry.files[0]);
            text += entry.caption + "\n";
            if (!entry.files.empty())
                text += fmt::format("\nFiles: {}\n", fmt::join(entry.files, ", "));
            files.names.insert(files.names.end(), entry.files.begin(), entry.files.end());
        }
        core::write_whole_file(folder_ / "figures.md", text);
        files.names.emplace_back("figures.md");
        return files;
    }

  private:
    void nothing(const std::string& name,
                 const std::vector<std::string>& files,
                 std::string reason) {
        for (const std::string& file : files) {
            std::error_code ignored;
            std::filesystem::remove(folder_ / file, ignored);
        }
        entries_.push_back({name, {}, std::move(reason)});
    }

    std::filesystem::path folder_;
    std::vector<Entry> entries_;
};

/// "640 x 360 px, 4 scenes: torus, ..." of what is shown.
std::string shown_words(const std::vector<FigureView>& views) {
    if (views.empty()) return "No view was drawn.";
    std::vector<std::string> names;
    for (const FigureView& view : views)
        names.push_back(fmt::format("{} ({})", view.scene, view.view));
    const auto& labels = views.front().truth.traced.labels;
    return fmt::format(
        "Views of {} x {} px: {}.", labels.width_px(), labels.height_px(), fmt::join(names, ", "));
}

constexpr const char* kErrorsInColour =
    "Lines that are right are dark, missing ones in warm and false ones in cool colours, each "
    "cause in its own.";

void write_grids(const std::vector<FigureView>& views, const Pair& pair, Writer& writer) {
    const std::string where = shown_words(views);
    writer.grid("strips",
                strips_figure(views),
                fmt::format("Scenes by methods, beside the exact outline. {} Below each picture F "
                            "at 2 px, the best of a scene in bold. Larger pictures are shrunk so "
                            "that no error is lost. {}",
                            kErrorsInColour,
                            where));
    const GridFigure buffers = buffers_figure(views);
    writer.grid("buffers",
                buffers,
                buffers.bands.empty()
                    ? "No method that takes part shows a buffer."
                    : fmt::format("What methods look for lines in. Packed: depth and normal as one "
                                  "code a pixel (of more than one field, three of them as red, "
                                  "green and blue). Filtered: what the filter makes of it, the "
                                  "threshold at mid-grey. Beside them full depth and normals, and "
                                  "the exact outline. {} {}",
                                  kErrorsInColour,
                                  where));
    const GridFigure zoom = zoom_figure(views, pair);
    writer.grid(
        "zoom",
        zoom,
        zoom.bands.empty()
            ? fmt::format("{} and {} drew no view both.", pair.first, pair.second)
            : fmt::format("The windows in which {} and {} differ most in wrong pixels, {} "
                          "times enlarged, a pixel a square. Dark on white: the exact lines "
                          "of the truth, finer than pixels. Below: what the methods have "
                          "inside there. {}",
                          pair.first,
                          pair.second,
                          kZoom,
                          kErrorsInColour));
}

void write_charts(const std::vector<harness::Row>& rows,
                  const std::string& source,
                  Writer& writer) {
    const std::vector<experiment::MethodSummary> summaries = experiment::summarise(rows);
    std::optional<double> sampled_error;
    for (const experiment::MethodSummary& s : summaries) {
        if (s.method == "sampled" && s.f_2px) sampled_error = 1 - *s.f_2px;
    }
    writer.chart("error_time",
                 error_time_chart(timed_errors(summaries), sampled_error),
                 fmt::format("Error 1 - F at 2 px of the counts pooled over all views against the "
                             "median time to draw a frame, both axes logarithmic. Upright bars: 95 "
                             "% intervals, scenes resampled with all their views. Lying bars: "
                             "quartiles of the time over views. Grey stair: the lowest error to be "
                             "had at each time. Hollow: tuned settings. Dotted: exact lines seen "
                             "once a pixel centre. {}",
                             source));
    writer.chart("classes",
                 class_chart(summaries, rows),
                 fmt::format("Share of the true pixels of each class found within 2 px, each class "
                             "by a matching of its own, pooled over views; lines: 95 % intervals, "
                             "scenes resampled. {}",
                             source));
}

}  // namespace

FigureFiles make_figures(const std::vector<harness::SceneViews>& scenes,
                         const FigureOptions& options) {
    const Pair pair = pair_of(options);
    harness::make_out_folder(options.out);
    const DrawnScenes drawn = draw_scenes(scenes, options.drawing);
    Writer writer(options.out);
    write_grids(drawn.shown, pair, writer);
    const std::vector<harness::Row>& rows = options.charts ? options.charts->rows : drawn.rows;
    const std::string source = options.charts ? options.charts->words : shown_words(drawn.shown);
    write_charts(rows, source, writer);
    writer.table("figure_summary.csv",
                 experiment::summary_csv(rows, {}),
                 "The numbers of the charts, a line a method (the columns of `inkbench compare`).");
    writer.table(
        "figure_rows.csv", rows_csv(drawn.rows), "The numbers of the pictures, a line each.");
    FigureFiles files = writer.finish(options.command);
    files.is_interrupted = drawn.is_interrupted;
    return files;
}

}  // namespace ink::report
