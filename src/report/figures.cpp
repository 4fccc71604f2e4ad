#include "report/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <opencv2/imgproc.hpp>
#include <set>

#include "core/error.h"
#include "core/parallel.h"
#include "core/text_table.h"
#include "core/whole_file.h"
#include "draw/error_image.h"
#include "draw/palette.h"
#include "experiment/summary/cause_totals.h"
#include "image_io/image_file.h"
#include "report/cancellation_chart.h"
#include "report/cause_chart.h"
#include "report/charts.h"
#include "report/verdict.h"

namespace ink::report {
namespace {

constexpr int kStripCell_px = 480;  // wider pictures are shrunk by a whole factor
constexpr int kOverviewCell_px = 300;
constexpr double kFontScale = 0.48;
constexpr int kLetter_px = 9;  // mean advance at that scale
constexpr int kGap_px = 12;
constexpr int kCaptionHeight_px = 30;
constexpr int kLegendHeight_px = 26;
constexpr int kLineCells = 7;  // pictures side by side; a strip of more goes on below
constexpr std::size_t kOverviewStrips = 8;
constexpr std::size_t kOverviewCells = 72;  // with many methods, fewer strips

int shrink_factor(int width_px, int cell_px) {
    return std::max(1, (width_px + cell_px / 2) / cell_px);
}

/// OpenCV's letters know ASCII only.
std::string ascii(const std::string& text) {
    std::string plain;
    for (const char c : text)
        plain += (c >= ' ' && c <= '~') ? c : '?';
    return plain;
}

void put_text(draw::RgbImage& canvas,
              cv::Point place,
              const std::string& text,
              glm::u8vec3 colour) {
    cv::Mat pixels(canvas.height_px(), canvas.width_px(), CV_8UC3, canvas.data());
    cv::putText(pixels,
                ascii(text),
                place,
                cv::FONT_HERSHEY_SIMPLEX,
                kFontScale,
                cv::Scalar(colour.r, colour.g, colour.b),
                1,
                cv::LINE_AA);
}

void put_image(draw::RgbImage& canvas, int left, int top, const draw::RgbImage& image) {
    for (int y = 0; y < std::min(image.height_px(), canvas.height_px() - top); ++y) {
        std::copy_n(image.row(y), image.width_px(), canvas.row(top + y) + left);
    }
}

void put_frame(draw::RgbImage& canvas, const cv::Rect& frame) {
    cv::Mat pixels(canvas.height_px(), canvas.width_px(), CV_8UC3, canvas.data());
    cv::rectangle(
        pixels, frame, cv::Scalar(draw::kMist.rgb.r, draw::kMist.rgb.g, draw::kMist.rgb.b));
}

/// A picture of a strip with the words below it.
struct Cell {
    draw::RgbImage image;
    std::string caption;
};

std::string caption_of(const std::vector<harness::Row>& rows,
                       const harness::ShownView& view,
                       const std::string& method) {
    for (const harness::Row& row : rows) {
        if (row.scene != view.scene || row.view != view.view || row.method != method) continue;
        std::string caption = fmt::format("{}  F {}", method, core::format_share(row.f_2px));
        if (row.draw_ns) {
            caption += fmt::format("  {} ms", format_ms(static_cast<double>(*row.draw_ns) * 1e-6));
        }
        return caption;
    }
    return method;
}

/// Truth and errors of a view, once, for strips of any size.
struct MarkedView {
    const harness::ShownView* view = nullptr;
    std::vector<draw::Marks> marks;  ///< one per picture of the view
};

std::vector<MarkedView> mark_views(const std::vector<harness::ShownView>& views) {
    std::vector<MarkedView> marked(views.size());
    core::parallel_for(views.size(), core::hardware_threads(), [&](std::size_t i) {
        marked[i].view = &views[i];
        for (const harness::MethodImage& image : views[i].images) {
            const draw::Marks marks =
                draw::mark_errors(views[i].labels,
                                  image.edge_response,
                                  {.threshold = image.threshold, .wrong = image.wrong});
            marked[i].marks.push_back(marks);
        }
    });
    return marked;
}

std::vector<Cell> cells_of(const std::vector<harness::Row>& rows,
                           const MarkedView& marked,
                           int cell_px) {
    const harness::ShownView& view = *marked.view;
    const int factor = shrink_factor(view.labels.width_px(), cell_px);
    std::vector<Cell> cells;
    cells.push_back({draw::truth_image(draw::shrink(view.labels, factor)),
                     fmt::format("{} {}: truth", view.scene, view.view)});
    for (std::size_t i = 0; i < marked.marks.size(); ++i) {
        cells.push_back({draw::error_image(draw::shrink(marked.marks[i], factor)),
                         caption_of(rows, view, view.images[i].method)});
    }
    return cells;
}

draw::RgbImage strip_of(const std::vector<Cell>& cells) {
    const int width = cells.front().image.width_px();
    const int height = cells.front().image.height_px();
    const auto count = static_cast<int>(cells.size());
    const int lines = (count + kLineCells - 1) / kLineCells;
    const int in_line = (count + lines - 1) / lines;  // lines of even length
    const int line_height = height + kGap_px + kCaptionHeight_px;
    draw::RgbImage strip(
        in_line * (width + kGap_px) + kGap_px, lines * line_height, draw::kPaper.rgb);
    for (int i = 0; i < count; ++i) {
        const int left = kGap_px + (i % in_line) * (width + kGap_px);
        const int top = kGap_px + (i / in_line) * line_height;
        const Cell& cell = cells[static_cast<std::size_t>(i)];
        put_image(strip, left, top, cell.image);
        put_frame(strip, {left - 1, top - 1, width + 2, height + 2});
        // Captions that are too long are cut where the next picture's begins.
        const auto letters = static_cast<std::size_t>(width / kLetter_px);
        put_text(strip, {left, top + height + 20}, cell.caption.substr(0, letters), draw::kInk.rgb);
    }
    return strip;
}

struct LegendEntry {
    draw::Colour colour;
    std::string words;
};

/// One group of colours a line; a line that is too long for the picture goes on in the next.
std::vector<std::vector<LegendEntry>> legend_groups() {
    std::vector<LegendEntry> truth_lines;
    for (const truth::LineClass c : truth::kLineClasses)
        truth_lines.push_back({draw::colour_of(c), std::string(truth::name(c))});
    std::vector<LegendEntry> misses = {{draw::kHitColour, "right"}};
    for (const score::Cause cause : score::kFalseNegativeCauses)
        misses.push_back(
            {draw::colour_of(cause), fmt::format("missing: {}", experiment::label_of(cause))});
    std::vector<LegendEntry> false_lines = {{draw::kIgnoredColour, "not counted"}};
    for (const score::Cause cause : score::kFalsePositiveCauses)
        false_lines.push_back(
            {draw::colour_of(cause), fmt::format("false: {}", experiment::label_of(cause))});
    return {misses, false_lines, truth_lines};
}

int needed_px(const LegendEntry& entry) {
    return 24 + kLetter_px * static_cast<int>(entry.words.size()) + 14;
}

/// The groups broken into lines that fit into `width_px`.
std::vector<std::vector<LegendEntry>> legend_lines(int width_px) {
    std::vector<std::vector<LegendEntry>> lines;
    for (const std::vector<LegendEntry>& group : legend_groups()) {
        int left = width_px;  // the first entry begins a line
        for (const LegendEntry& entry : group) {
            if (left + needed_px(entry) > width_px) {
                lines.emplace_back();
                left = kGap_px;
            }
            lines.back().push_back(entry);
            left += needed_px(entry);
        }
    }
    return lines;
}

draw::RgbImage legend_line(const std::vector<LegendEntry>& entries, int width_px) {
    draw::RgbImage image(width_px, kLegendHeight_px, draw::kPaper.rgb);
    int left = kGap_px;
    for (const LegendEntry& entry : entries) {
        const auto& [colour, words] = entry;
        cv::Mat pixels(image.height_px(), image.width_px(), CV_8UC3, image.data());
        cv::rectangle(pixels,
                      {left, 6, 16, 12},
                      cv::Scalar(colour.rgb.r, colour.rgb.g, colour.rgb.b),
                      cv::FILLED);
        put_text(image, {left + 22, 17}, words, draw::kInk.rgb);
        left += needed_px(entry);
    }
    return image;
}

draw::RgbImage stacked(const std::vector<draw::RgbImage>& images) {
    int width = 1;
    int height = 0;
    for (const draw::RgbImage& image : images) {
        width = std::max(width, image.width_px());
        height += image.height_px();
    }
    draw::RgbImage canvas(width, height, draw::kPaper.rgb);
    int top = 0;
    for (const draw::RgbImage& image : images) {
        put_image(canvas, 0, top, image);
        top += image.height_px();
    }
    return canvas;
}

/// What the colours mean, `width_px` wide.
draw::RgbImage legend(int width_px) {
    std::vector<draw::RgbImage> lines;
    for (const std::vector<LegendEntry>& line : legend_lines(width_px))
        lines.push_back(legend_line(line, width_px));
    return stacked(lines);
}

void write_strips(const std::vector<harness::Row>& rows,
                  const std::vector<MarkedView>& views,
                  const std::filesystem::path& folder) {
    std::vector<std::string> names;
    std::set<std::string> taken = {"overview"};
    for (const MarkedView& marked : views) {
        const std::string stem = file_stem(marked.view->scene);
        std::string name = stem;
        for (int n = 2; !taken.insert(name).second; ++n)
            name = fmt::format("{}.{}", stem, n);
        names.push_back(name + ".png");
    }
    core::parallel_for(views.size(), core::hardware_threads(), [&](std::size_t i) {
        const draw::RgbImage strip = strip_of(cells_of(rows, views[i], kStripCell_px));
        image_io::write_png(stacked({strip, legend(strip.width_px())}), folder / names[i]);
    });
}

/// Some strips below each other, small enough to open a README with. Scenes that are listed side by
/// side are alike, so the strips are taken at even distances.
void write_overview(const std::vector<harness::Row>& rows,
                    const std::vector<MarkedView>& views,
                    const std::filesystem::path& folder) {
    if (views.empty()) return;
    const std::size_t fitting = kOverviewCells / (views.front().marks.size() + 1);
    const std::size_t count =
        std::min(views.size(), std::clamp<std::size_t>(fitting, 2, kOverviewStrips));
    std::vector<draw::RgbImage> strips;
    int width_px = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const MarkedView& marked = views[i * views.size() / count];
        strips.push_back(strip_of(cells_of(rows, marked, kOverviewCell_px)));
        width_px = std::max(width_px, strips.back().width_px());
    }
    strips.push_back(legend(width_px));
    image_io::write_png(stacked(strips), folder / "overview.png");
}

}  // namespace

std::string file_stem(const std::string& scene) {
    constexpr std::size_t kLongest = 80;
    std::string stem;
    for (const char c : scene.substr(0, kLongest)) {
        const bool is_plain =
            std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
        stem += is_plain ? c : '_';
    }
    if (stem.empty() || stem[0] == '.') stem = "_" + stem;
    return stem;
}

void write_figures(const ReportData& data, const std::filesystem::path& folder) {
    const std::filesystem::path figures = folder / "figures";
    std::error_code failure;
    std::filesystem::create_directories(figures, failure);
    if (failure) {
        throw core::Error(
            figures.string(), "this folder cannot be made", "a writable place for figures");
    }
    const std::vector<experiment::MethodSummary> summaries = experiment::summarise(data.rows);
    core::write_whole_file(figures / "fronts.svg",
                           front_chart(experiment::summarise_fronts(data.rows, data.sweep))
                               .file("Error against time, per method"));
    core::write_whole_file(
        figures / "classes.svg",
        class_chart(summaries, data.rows).file("Recall per line class and method"));
    core::write_whole_file(figures / "causes.svg",
                           cause_chart(experiment::cause_totals(data.rows))
                               .file("Where the error goes, per method and cause"));
    core::write_whole_file(figures / "cancellation.svg",
                           cancellation_chart(data.cancellation)
                               .file("Predicted against measured miss rates, per method"));
    const std::vector<MarkedView> views = mark_views(data.views);
    write_strips(data.rows, views, figures);
    write_overview(data.rows, views, figures);
}

}  // namespace ink::report
