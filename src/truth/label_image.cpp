#include "truth/label_image.h"

#include <algorithm>
#include <cmath>

#include "edge/thin.h"

namespace ink::truth {
namespace {

constexpr double kSamplesPerPx = 16;
constexpr int kBlock_px = 8;

using Labels = core::Image<std::uint8_t>;

void draw(const Curve& curve, Labels& labels) {
    const double dx = curve.end.x_px - curve.begin.x_px;
    const double dy = curve.end.y_px - curve.begin.y_px;
    const int steps = static_cast<int>(std::ceil(std::hypot(dx, dy) * kSamplesPerPx));
    const auto label = static_cast<std::uint8_t>(curve.line_class);
    for (int i = 0; i <= steps; ++i) {
        const double s = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
        const int x = static_cast<int>(std::floor(curve.begin.x_px + s * dx));
        const int y = static_cast<int>(std::floor(curve.begin.y_px + s * dy));
        if (!labels.contains(x, y)) continue;
        std::uint8_t& pixel = labels.at(x, y);
        if (pixel == 0 || label < pixel) pixel = label;
    }
}

edge::Mask drawn(const Labels& labels) {
    edge::Mask mask(labels.width_px(), labels.height_px());
    std::transform(labels.data(), labels.data() + labels.size(), mask.data(), [](std::uint8_t l) {
        return static_cast<std::uint8_t>(l != 0 && l != static_cast<std::uint8_t>(LineClass::ignore));
    });
    return mask;
}

std::size_t count(const edge::Mask& mask) {
    return static_cast<std::size_t>(std::count(mask.data(), mask.data() + mask.size(), 1));
}

/// Labels where the mask is on.
void keep(Labels& labels, const edge::Mask& mask) {
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const bool is_ignore = labels.data()[i] == static_cast<std::uint8_t>(LineClass::ignore);
        if (mask.data()[i] == 0 && !is_ignore) labels.data()[i] = 0;
    }
}

struct Block {
    int x_begin, x_end, y_begin, y_end;
};

std::size_t count(const edge::Mask& mask, const Block& block) {
    std::size_t n = 0;
    for (int y = block.y_begin; y < block.y_end; ++y)
        n += static_cast<std::size_t>(
            std::count(mask.row(y) + block.x_begin, mask.row(y) + block.x_end, 1));
    return n;
}

/// Marks crowded blocks in `labels` as `ignore`; returns how many drawn pixels they hold.
std::size_t ignore_crowded(const edge::Mask& before_thinning, Labels& labels) {
    std::size_t crowded = 0;
    for (int y = 0; y < labels.height_px(); y += kBlock_px) {
        for (int x = 0; x < labels.width_px(); x += kBlock_px) {
            const Block block{x,
                              std::min(x + kBlock_px, labels.width_px()),
                              y,
                              std::min(y + kBlock_px, labels.height_px())};
            const int area = (block.x_end - block.x_begin) * (block.y_end - block.y_begin);
            const std::size_t n = count(before_thinning, block);
            if (4 * n <= static_cast<std::size_t>(area)) continue;
            crowded += n;
            for (int row = block.y_begin; row < block.y_end; ++row)
                std::fill(labels.row(row) + block.x_begin,
                          labels.row(row) + block.x_end,
                          static_cast<std::uint8_t>(LineClass::ignore));
        }
    }
    return crowded;
}

}  // namespace

LabelImage draw_labels(std::span<const Curve> curves, int width_px, int height_px) {
    LabelImage result;
    result.labels = Labels(width_px, height_px);
    for (const Curve& curve : curves)
        draw(curve, result.labels);
    const edge::Mask before = drawn(result.labels);
    const edge::Mask thinned = edge::thin(before);
    const std::size_t n = count(before);
    result.merged_px = n - count(thinned);
    keep(result.labels, thinned);
    const std::size_t crowded = ignore_crowded(before, result.labels);
    result.crowded_share = n == 0 ? 0 : static_cast<double>(crowded) / static_cast<double>(n);
    keep(result.labels, edge::thin(drawn(result.labels)));
    return result;
}

}  // namespace ink::truth
