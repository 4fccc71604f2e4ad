#include "truth/label_image.h"

#include <algorithm>
#include <utility>

#include "edge/thin.h"

namespace ink::truth {
namespace {

constexpr int kBlock_px = 8;
constexpr int kFullOutOf4 = 3;  ///< a block is full if more than this many quarters of it are drawn

using Labels = core::Image<std::uint8_t>;

void draw(const Curve& curve, Labels& labels) {
    const auto label = static_cast<std::uint8_t>(curve.line_class);
    visit_pixels(curve, [&](int x, int y) {
        if (!labels.contains(x, y)) return;
        std::uint8_t& pixel = labels.at(x, y);
        if (pixel == 0 || label < pixel) pixel = label;
    });
}

/// 1 at the intersections of `labels` through whose pixel no curve but such below the crease angle
/// runs.
Labels draw_below_crease(std::span<const Curve> curves, double crease_rad, const Labels& labels) {
    Labels below(labels.width_px(), labels.height_px());
    const auto mark = [&](bool is_below, std::uint8_t value) {
        for (const Curve& curve : curves) {
            if (is_below_crease(curve, crease_rad) != is_below) continue;
            visit_pixels(curve, [&](int x, int y) {
                if (below.contains(x, y)) below.at(x, y) = value;
            });
        }
    };
    const bool is_any = std::ranges::any_of(
        curves, [&](const Curve& curve) { return is_below_crease(curve, crease_rad); });
    if (!is_any) return below;
    mark(true, 1);
    mark(false, 0);
    for (std::size_t i = 0; i < below.size(); ++i) {
        if (labels.data()[i] != static_cast<std::uint8_t>(LineClass::intersection))
            below.data()[i] = 0;
    }
    return below;
}

edge::Mask drawn(const Labels& labels) {
    edge::Mask mask(labels.width_px(), labels.height_px());
    std::transform(labels.data(), labels.data() + labels.size(), mask.data(), [](std::uint8_t l) {
        return static_cast<std::uint8_t>(l != 0 &&
                                         l != static_cast<std::uint8_t>(LineClass::ignore));
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

/// Marks crowded blocks in `labels`, full ones and those beside them, as `ignore`; returns how many
/// drawn pixels they hold.
std::size_t ignore_crowded(const edge::Mask& before_thinning, Labels& labels) {
    const int columns = (labels.width_px() + kBlock_px - 1) / kBlock_px;
    const int rows = (labels.height_px() + kBlock_px - 1) / kBlock_px;
    core::Image<int> drawn(columns, rows);
    for (int y = 0; y < labels.height_px(); ++y) {
        for (int x = 0; x < labels.width_px(); ++x)
            drawn.at(x / kBlock_px, y / kBlock_px) += before_thinning.at(x, y);
    }
    core::Image<std::uint8_t> is_crowded(columns, rows);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            // The last ones are cut off by the image's border.
            const int width = std::min(kBlock_px, labels.width_px() - column * kBlock_px);
            const int height = std::min(kBlock_px, labels.height_px() - row * kBlock_px);
            if (kFullOutOf4 * width * height >= 4 * drawn.at(column, row)) continue;
            for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r) {
                for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c)
                    is_crowded.at(c, r) = 1;
            }
        }
    }
    std::size_t crowded = 0;
    for (int y = 0; y < labels.height_px(); ++y) {
        for (int x = 0; x < labels.width_px(); ++x) {
            if (is_crowded.at(x / kBlock_px, y / kBlock_px) == 0) continue;
            labels.at(x, y) = static_cast<std::uint8_t>(LineClass::ignore);
            crowded += before_thinning.at(x, y);
        }
    }
    return crowded;
}

}  // namespace

LabelImage draw_labels(std::span<const Curve> curves,
                       int width_px,
                       int height_px,
                       double crease_rad,
                       Crowded crowded) {
    LabelImage result;
    result.labels = Labels(width_px, height_px);
    for (const Curve& curve : curves)
        draw(curve, result.labels);
    const edge::Mask before = drawn(result.labels);
    const edge::Mask thinned = edge::thin(before);
    const std::size_t n = count(before);
    result.merged_px = n - count(thinned);
    keep(result.labels, thinned);
    Labels without = result.labels;
    const std::size_t left_out = ignore_crowded(before, without);
    result.crowded_share = n == 0 ? 0 : static_cast<double>(left_out) / static_cast<double>(n);
    if (crowded == Crowded::ignore) result.labels = std::move(without);
    keep(result.labels, edge::thin(drawn(result.labels)));
    result.below_crease = draw_below_crease(curves, crease_rad, result.labels);
    return result;
}

core::Image<std::uint32_t> draw_curve_map(std::span<const Curve> curves,
                                          int width_px,
                                          int height_px) {
    core::Image<std::uint32_t> map(width_px, height_px, kNoCurve);
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
        visit_pixels(curves[i], [&](int x, int y) {
            if (!map.contains(x, y)) return;
            std::uint32_t& pixel = map.at(x, y);
            if (pixel == kNoCurve || curves[i].line_class < curves[pixel].line_class) pixel = i;
        });
    }
    return map;
}

}  // namespace ink::truth
