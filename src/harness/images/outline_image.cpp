#include "harness/images/outline_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "core/srgb.h"
#include "image_io/image_file.h"

namespace ink::harness {
namespace {

using image_io::Rgb;
using Gray = core::Image<std::uint8_t>;
using Colours = core::Image<Rgb>;

/// Lines cover at most so much of an image.
constexpr double kMostLines = 0.25;

/// Each pixel v as 255 - v: dark lines as edge responses.
void invert(Gray& image) {
    image =
        core::mapped<std::uint8_t>(image, [](int v) { return static_cast<std::uint8_t>(255 - v); });
}

/// Whether the pixels of `mask` are surfaces rather than lines: most have others 4 px away on all
/// four sides.
bool is_filled(const edge::Mask& mask) {
    constexpr int kReach_px = 4;
    std::size_t set = 0;
    std::size_t inside = 0;
    for (int y = 0; y < mask.height_px(); ++y) {
        for (int x = 0; x < mask.width_px(); ++x) {
            if (mask.at(x, y) == 0) continue;
            ++set;
            const auto is_set = [&](int dx, int dy) {
                return mask.contains(x + dx, y + dy) && mask.at(x + dx, y + dy) != 0;
            };
            if (is_set(-kReach_px, 0) && is_set(kReach_px, 0) && is_set(0, -kReach_px) &&
                is_set(0, kReach_px))
                ++inside;
        }
    }
    return 2 * inside > set;
}

/// Whether the opposite of the lines of a picture with alpha is white.
bool is_ground_light(const image_io::Picture& picture, Polarity polarity) {
    if (polarity != Polarity::automatic) return polarity == Polarity::dark_on_light;
    edge::Mask opaque(picture.alpha.width_px(), picture.alpha.height_px());
    double sum = 0;
    double weight = 0;
    for (std::size_t i = 0; i < opaque.size(); ++i) {
        const int alpha = picture.alpha.data()[i];
        opaque.data()[i] = alpha >= 128 ? 1 : 0;
        sum += alpha * image_io::luma(picture.colour.data()[i]);
        weight += alpha;
    }
    const bool is_opaque_light = weight > 0 && sum >= 128 * weight;
    return is_filled(opaque) ? is_opaque_light : weight > 0 && !is_opaque_light;
}

/// Lays the picture over a ground if parts of it are transparent.
void lay_over_ground(image_io::Picture& picture, Polarity polarity) {
    const auto& alphas = picture.alpha;
    const auto is_opaque = [](int alpha) { return alpha == 255; };
    if (std::all_of(alphas.data(), alphas.data() + alphas.size(), is_opaque)) return;
    const bool is_light = is_ground_light(picture, polarity);
    const int ground = is_light ? 255 : 0;
    for (std::size_t i = 0; i < picture.alpha.size(); ++i) {
        const int alpha = picture.alpha.data()[i];
        for (int c = 0; c < 3; ++c) {
            std::uint8_t& value = picture.colour.data()[i][c];
            value = static_cast<std::uint8_t>((value * alpha + ground * (255 - alpha) + 127) / 255);
        }
    }
    picture.notes.push_back(fmt::format("its alpha laid over {}", is_light ? "white" : "black"));
}

/// The mean of the commonest colours: those in one cell of 8 x 8 x 8.
glm::dvec3 commonest(const Colours& colours) {
    struct Cell {
        glm::dvec3 sum{0};
        std::size_t count = 0;
    };
    std::vector<Cell> cells(32 * 32 * 32);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const Rgb& rgb = colours.data()[i];
        Cell& cell =
            cells[static_cast<std::size_t>(rgb.r >> 3 << 10 | rgb.g >> 3 << 5 | rgb.b >> 3)];
        cell.sum += glm::dvec3(rgb);
        ++cell.count;
    }
    const auto most = std::max_element(
        cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.count < b.count; });
    return most->sum / static_cast<double>(most->count);
}

/// How far each pixel's colour is from the ground's: 0 for the same, 255 for the farthest there is.
Gray distances(const Colours& colours, const glm::dvec3& ground) {
    double farthest = 1;
    for (std::size_t i = 0; i < colours.size(); ++i)
        farthest = std::max(farthest, glm::distance(glm::dvec3(colours.data()[i]), ground));
    return core::mapped<std::uint8_t>(colours, [&](const Rgb& rgb) {
        return static_cast<std::uint8_t>(255 * glm::distance(glm::dvec3(rgb), ground) / farthest +
                                         0.5);
    });
}

/// How far values tell the pixels of `lines` from the others: the difference of their means.
double contrast(const Gray& values, const edge::Mask& lines) {
    std::array<double, 2> sum{};
    std::array<double, 2> count{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum[lines.data()[i]] += values.data()[i];
        ++count[lines.data()[i]];
    }
    return sum[1] / count[1] - sum[0] / count[0];
}

/// A picture's lines as something of its colours shows them.
struct ShownLines {
    Gray values;
    std::string note;  ///< "" for luma
    double contrast = 0;
    bool is_inverted = false;
};

/// What shows lines of one ground, the plainest first: luma, channels, the distance from the ground
/// where it need not say which lines are light.
std::vector<ShownLines> shown_lines(const Colours& colours,
                                    const glm::dvec3& ground,
                                    const Gray& distance,
                                    bool may_be_distance) {
    std::vector<ShownLines> shown = {{core::mapped<std::uint8_t>(colours, image_io::luma), ""}};
    constexpr std::array<const char*, 3> kChannels = {"red", "green", "blue"};
    for (int c = 0; c < 3; ++c) {
        shown.push_back(
            {core::mapped<std::uint8_t>(colours, [c](const Rgb& rgb) { return rgb[c]; }),
             fmt::format("lines by the {} channel", kChannels[static_cast<std::size_t>(c)])});
    }
    if (may_be_distance) {
        shown.push_back({distance,
                         fmt::format("lines by the distance from the ground's colour "
                                     "({:.0f},{:.0f},{:.0f})",
                                     ground.r,
                                     ground.g,
                                     ground.b)});
    }
    return shown;
}

/// The pixels that are farther from the ground's colour than half of the farthest.
edge::Mask far_pixels(const Gray& distance) {
    return core::mapped<std::uint8_t>(distance,
                                      [](int v) { return static_cast<std::uint8_t>(v >= 128); });
}

/// Whether a mask is of lines on a ground.
bool is_of_lines(const edge::Mask& mask) {
    const auto set = std::count(mask.data(), mask.data() + mask.size(), 1);
    return set > 0 && static_cast<double>(set) <= kMostLines * static_cast<double>(mask.size()) &&
           !is_filled(mask);
}

/// Makes `outline` of what shows coloured lines best. False where luma does nearly as well, and
/// where there are no thin lines on a ground of one colour.
bool read_coloured_lines(const Colours& colours, Polarity polarity, OutlineImage& outline) {
    const auto is_gray = [](const Rgb& rgb) { return rgb.r == rgb.g && rgb.g == rgb.b; };
    if (std::all_of(colours.data(), colours.data() + colours.size(), is_gray)) return false;
    const glm::dvec3 ground = commonest(colours);
    const Gray distance = distances(colours, ground);
    const edge::Mask lines = far_pixels(distance);
    if (!is_of_lines(lines)) return false;

    const bool is_automatic = polarity == Polarity::automatic;
    std::vector<ShownLines> all = shown_lines(colours, ground, distance, is_automatic);
    double best = 0;
    for (ShownLines& shown : all) {
        const double lighter = contrast(shown.values, lines);
        shown.is_inverted = is_automatic ? lighter < 0 : polarity == Polarity::dark_on_light;
        shown.contrast = shown.is_inverted ? -lighter : lighter;
        best = std::max(best, shown.contrast);
    }
    // The distance always reaches the best. Lines in dark ink are to count by their luma.
    constexpr double kAsGood = 0.75;
    for (ShownLines& shown : all) {
        if (shown.contrast <= 0 || shown.contrast < kAsGood * best) continue;
        if (shown.note.empty()) return false;
        if (shown.is_inverted) invert(shown.values);
        const bool would_ground_count = is_automatic && has_dark_lines(shown.values);
        if (would_ground_count) continue;
        outline.responses = std::move(shown.values);
        outline.is_inverted = shown.is_inverted;
        outline.notes.push_back(std::move(shown.note));
        return true;
    }
    return false;
}

/// Greys as the light that a screen gives for them.
void take_light(OutlineImage& outline) {
    std::array<std::uint8_t, 256> light{};
    for (std::size_t v = 0; v < light.size(); ++v)
        light[v] = static_cast<std::uint8_t>(
            std::lround(255 * core::light_of(static_cast<double>(v) / 255)));
    Gray& values = outline.responses;
    values = core::mapped<std::uint8_t>(values, [&](std::size_t v) { return light[v]; });
    outline.notes.push_back("its greys taken as light, as the file says");
}

}  // namespace

bool has_dark_lines(const Gray& image) {
    constexpr double kLeastLight = 0.75;
    if (image.is_empty()) return false;
    const auto* end = image.data() + image.size();
    const auto light = std::count_if(image.data(), end, [](int v) { return v >= 128; });
    const auto [least, most] = std::minmax_element(image.data(), end);
    return *least != *most &&
           static_cast<double>(light) > kLeastLight * static_cast<double>(image.size());
}

OutlineImage read_outline_image(const std::filesystem::path& path, Polarity polarity) {
    image_io::Picture picture = image_io::read_picture(path);
    if (!picture.alpha.is_empty()) lay_over_ground(picture, polarity);
    const auto mixed = picture.texts.find(image_io::kMixedText);
    const bool is_of_light = mixed != picture.texts.end() && mixed->second == "linear";
    OutlineImage outline;
    outline.notes = std::move(picture.notes);
    if (read_coloured_lines(picture.colour, polarity, outline)) return outline;
    outline.responses = core::mapped<std::uint8_t>(picture.colour, image_io::luma);
    if (is_of_light) take_light(outline);
    outline.is_inverted = polarity == Polarity::dark_on_light ||
                          (polarity == Polarity::automatic && has_dark_lines(outline.responses));
    if (outline.is_inverted) invert(outline.responses);
    return outline;
}

}  // namespace ink::harness
