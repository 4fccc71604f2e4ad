#include "report/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "image_io/image_file.h"
#include "report/html.h"

namespace ink::report {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kScalePerPx = 1 / 30.0;  // its capitals are 21 units high, a sans-serif's .72 em
constexpr int kFine = 4;                  // letters are drawn this much larger and averaged

/// OpenCV's letters know ASCII only.
std::string ascii(const std::string& text) {
    std::string plain;
    for (const char c : text)
        plain += (c >= ' ' && c <= '~') ? c : '?';
    return plain;
}

/// Width and stroke of letters drawn kFine times larger.
struct Letters {
    double scale;
    int stroke;

    explicit Letters(const TextStyle& style)
        : scale(style.size * kScalePerPx * kFine),
          stroke(std::max(1,
                          static_cast<int>(
                              std::lround(style.size * kFine * (style.is_bold ? 0.115 : 0.075))))) {
    }
};

double raster_width(const std::string& words, const TextStyle& style) {
    const Letters letters(style);
    int below = 0;
    return cv::getTextSize(ascii(words), kFont, letters.scale, letters.stroke, &below).width /
           static_cast<double>(kFine);
}

double left_of(const SheetText& text, double width) {
    if (text.style.anchor == "middle") return text.x - width / 2;
    return text.style.anchor == "end" ? text.x - width : text.x;
}

/// "#rrggbb" as bytes.
glm::u8vec3 rgb_of(std::string_view hex) {
    const auto byte = [&](std::size_t at) {
        return static_cast<std::uint8_t>(std::stoi(std::string(hex.substr(at, 2)), nullptr, 16));
    };
    return {byte(1), byte(3), byte(5)};
}

cv::Scalar scalar_of(const glm::u8vec3& rgb) {
    return {static_cast<double>(rgb.r), static_cast<double>(rgb.g), static_cast<double>(rgb.b)};
}

/// Blends `colour` in where the letters cover a pixel.
void put_text(draw::RgbImage& canvas, const SheetText& text) {
    const Letters letters(text.style);
    const double width = raster_width(text.words, text.style);
    const double left = left_of(text, width);
    const int x0 = std::max(0, static_cast<int>(left) - 2);
    const int y0 = std::max(0, static_cast<int>(text.y - text.style.size) - 2);
    const int x1 = std::min(canvas.width_px(), static_cast<int>(left + width) + 3);
    const int y1 = std::min(canvas.height_px(), static_cast<int>(text.y + text.style.size / 2) + 2);
    if (x1 <= x0 || y1 <= y0) return;
    cv::Mat large = cv::Mat::zeros((y1 - y0) * kFine, (x1 - x0) * kFine, CV_8UC1);
    cv::putText(large,
                ascii(text.words),
                {static_cast<int>(std::lround((left - x0) * kFine)),
                 static_cast<int>(std::lround((text.y - y0) * kFine))},
                kFont,
                letters.scale,
                cv::Scalar(255),
                letters.stroke,
                cv::LINE_8);
    cv::Mat cover;
    cv::resize(large, cover, {x1 - x0, y1 - y0}, 0, 0, cv::INTER_AREA);
    const glm::vec3 ink(rgb_of(text.style.fill));
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const float share = static_cast<float>(cover.at<std::uint8_t>(y - y0, x - x0)) / 255;
            glm::u8vec3& pixel = canvas.at(x, y);
            pixel = glm::u8vec3(glm::vec3(pixel) * (1 - share) + ink * share + 0.5F);
        }
    }
}

void put_line(draw::RgbImage& canvas, const SheetLine& line) {
    constexpr int kShift = 4;
    cv::Mat pixels(canvas.height_px(), canvas.width_px(), CV_8UC3, canvas.data());
    std::vector<cv::Point> points;
    // Centres of pixels are whole numbers there and halves here.
    for (std::size_t i = 0; i + 1 < line.xy.size(); i += 2) {
        points.emplace_back(static_cast<int>(std::lround((line.xy[i] - 0.5) * (1 << kShift))),
                            static_cast<int>(std::lround((line.xy[i + 1] - 0.5) * (1 << kShift))));
    }
    cv::polylines(pixels,
                  points,
                  false,
                  scalar_of(line.colour.rgb),
                  std::max(1, static_cast<int>(std::lround(line.width_px))),
                  cv::LINE_AA,
                  kShift);
}

void put_image(draw::RgbImage& canvas, int left, int top, const draw::RgbImage& image) {
    for (int y = 0; y < image.height_px(); ++y)
        std::copy_n(image.row(y), image.width_px(), canvas.row(top + y) + left);
    cv::Mat pixels(canvas.height_px(), canvas.width_px(), CV_8UC3, canvas.data());
    cv::rectangle(pixels,
                  cv::Rect(left - 1, top - 1, image.width_px() + 2, image.height_px() + 2),
                  scalar_of(draw::kMist.rgb));
}

}  // namespace

void Sheet::image(int left, int top, draw::RgbImage image) {
    assert(left >= 0 && top >= 0 && left + image.width_px() <= width_px_ &&
           top + image.height_px() <= height_px_);
    images_.push_back({left, top, std::move(image)});
}

void Sheet::box(const Box& box, const draw::Colour& colour) {
    boxes_.push_back({box, colour});
}

void Sheet::text(SheetText text) {
    if (!text.words.empty()) texts_.push_back(std::move(text));
}

std::vector<Box> Sheet::text_boxes() const {
    std::vector<Box> boxes;
    for (const SheetText& text : texts_) {
        const double width = sheet_text_width(text.words, text.style);
        boxes.push_back(
            {left_of(text, width), text.y - 0.78 * text.style.size, width, 1.05 * text.style.size});
    }
    return boxes;
}

draw::RgbImage Sheet::raster() const {
    draw::RgbImage canvas(width_px_, height_px_, draw::kPaper.rgb);
    for (const Placed& placed : images_)
        put_image(canvas, placed.left, placed.top, placed.image);
    cv::Mat pixels(canvas.height_px(), canvas.width_px(), CV_8UC3, canvas.data());
    for (const Filled& filled : boxes_) {
        const cv::Rect rect(static_cast<int>(filled.box.x),
                            static_cast<int>(filled.box.y),
                            static_cast<int>(filled.box.width),
                            static_cast<int>(filled.box.height));
        cv::rectangle(pixels, rect, scalar_of(filled.colour.rgb), cv::FILLED);
    }
    for (const SheetLine& line : lines_)
        put_line(canvas, line);
    for (const SheetText& text : texts_)
        put_text(canvas, text);
    return canvas;
}

std::string Sheet::svg(std::string_view title) const {
    Svg svg(width_px_, height_px_);
    for (const Placed& placed : images_) {
        const int width = placed.image.width_px();
        const int height = placed.image.height_px();
        svg.raw(fmt::format(
            R"(<image x="{}" y="{}" width="{}" height="{}" style="image-rendering:pixelated" href="{}"/>)",
            placed.left,
            placed.top,
            width,
            height,
            png_uri(image_io::encode_png(placed.image))));
        svg.rect({placed.left - 0.5, placed.top - 0.5, width + 1.0, height + 1.0},
                 fmt::format(R"(fill="none" stroke="{}")", draw::kMist.hex));
    }
    for (const Filled& filled : boxes_)
        svg.rect(filled.box, fmt::format(R"(fill="{}")", filled.colour.hex));
    for (const SheetLine& line : lines_) {
        svg.polyline(
            line.xy,
            fmt::format(R"(stroke="{}" stroke-width="{:g}")", line.colour.hex, line.width_px));
    }
    for (const SheetText& text : texts_)
        svg.text(text.x, text.y, text.words, text.style);
    return svg.file(title);
}

double sheet_text_width(const std::string& words, const TextStyle& style) {
    if (words.empty()) return 0;
    return std::max(raster_width(words, style), text_width(words, style.size));
}

std::string fitting(std::string words, const TextStyle& style, double width_px) {
    if (words.empty() || sheet_text_width(words, style) <= width_px) return words;
    while (!words.empty() && sheet_text_width(words + "~", style) > width_px)
        words.pop_back();
    return words + "~";
}

}  // namespace ink::report
