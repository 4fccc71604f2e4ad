#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"
#include "harness/rows/row.h"
#include "truth/line_class.h"

namespace ink::report {

/// How large an invented image is.
struct MadeUpSize {
    int width_px = 160;
    int height_px = 90;
};

/// A truth of circles (contours) with a cross (creases), a bar (seam) and a corner to be ignored.
inline core::Image<std::uint8_t> made_up_labels(const MadeUpSize& size, std::uint64_t seed) {
    using truth::LineClass;
    core::Image<std::uint8_t> labels(size.width_px, size.height_px);
    const auto put = [&](double x, double y, LineClass c) {
        const int px = static_cast<int>(x);
        const int py = static_cast<int>(y);
        if (labels.contains(px, py)) labels.at(px, py) = static_cast<std::uint8_t>(c);
    };
    std::mt19937_64 random(seed);
    const double radius = size.height_px * (0.2 + 0.02 * static_cast<double>(random() % 9));
    const double cx = size.width_px * (0.4 + 0.02 * static_cast<double>(random() % 9));
    const double cy = size.height_px * 0.5;
    for (int i = -1000; i <= 1000; ++i) {
        const double t = i / 1000.0;
        put(cx + t * radius * 0.7, cy + t * radius * 0.7, LineClass::crease);
        put(cx + t * radius * 0.7, cy - t * radius * 0.7, LineClass::crease);
        put(size.width_px * (0.5 + 0.4 * t), size.height_px * 0.85, LineClass::seam);
        put(size.width_px * (0.15 + 0.05 * t), size.height_px * 0.3, LineClass::boundary);
    }
    for (int i = 0; i < 4000; ++i) {
        const double a = i * 6.2831853 / 4000;
        put(cx + radius * std::cos(a), cy + radius * std::sin(a), LineClass::contour);
    }
    for (int y = size.height_px * 3 / 5; y < size.height_px * 7 / 10; ++y) {
        for (int x = size.width_px * 8 / 10; x < size.width_px * 9 / 10; ++x)
            put(x, y, LineClass::ignore);
    }
    return labels;
}

/// Lines of `labels` drawn badly: some left out, some made two pixels wide, some invented.
inline edge::EdgeImage made_up_drawing(const core::Image<std::uint8_t>& labels,
                                       double error,
                                       std::uint64_t seed) {
    edge::EdgeImage drawing(labels.width_px(), labels.height_px());
    std::mt19937_64 random(seed);
    const auto random_baseline = [&] { return static_cast<double>(random() % 10000) / 10000; };
    constexpr int kBlock = 16;
    std::vector<bool> is_left_out;
    for (int i = 0; i < (labels.width_px() / kBlock + 1) * (labels.height_px() / kBlock + 1); ++i) {
        is_left_out.push_back(random_baseline() < error);
    }
    for (int y = 1; y < labels.height_px() - 1; ++y) {
        for (int x = 1; x < labels.width_px() - 1; ++x) {
            const std::uint8_t label = labels.at(x, y);
            const int block = (y / kBlock) * (labels.width_px() / kBlock + 1) + x / kBlock;
            if (label == 0 || label == 7 || is_left_out[static_cast<std::size_t>(block)]) continue;
            drawing.at(x, y) = drawing.at(x + 1, y) = 255;
        }
    }
    for (int i = 0; i < static_cast<int>(error * 20); ++i) {
        const int left = 8 + static_cast<int>(random_baseline() * (labels.width_px() - 60));
        const int y = 8 + static_cast<int>(random_baseline() * (labels.height_px() - 16));
        for (int x = left; x < std::min(left + 40, labels.width_px()); ++x)
            drawing.at(x, y) = 200;
    }
    return drawing;
}

inline harness::Row made_up_row(const std::string& method, double f, double draw_ms) {
    harness::Row row;
    row.method = method;
    row.view = "front";
    row.split = "train";
    row.n_truth = 1000;
    row.n_pred = 1000;
    row.k_2px = std::llround(f * 1000);
    row.k_1px = std::llround(f * 900);
    row.n_pred_1px = 1000;
    row.f_2px = static_cast<double>(row.k_2px) / 1000;
    row.f_1px = static_cast<double>(*row.k_1px) / 1000;
    row.precision_2px = row.f_2px;
    row.recall_2px = row.f_2px;
    row.false_negatives = row.unmatched_truth = (1000 - row.k_2px) / 2;
    row.false_positives = row.unmatched_duplicates = (1000 - row.k_2px) / 2;
    row.truth_px = 1000;
    row.ap = f * 0.95;
    row.mean_width_px = 1.7;
    row.by_class = {{"contour", {std::llround(std::min(600.0, f * 630)), 600, 600}},
                    {"crease", {std::llround(f * 270), 300, 300}},
                    {"seam", {std::llround(f * 50), 100, 100}}};
    row.params = "clip_bits=2;threshold=24";
    row.threshold = 24;
    if (draw_ms > 0) {
        row.draw_ns = static_cast<std::int64_t>(draw_ms * 1e6);
        row.bytes_per_px = 5;
    }
    return row;
}

}  // namespace ink::report
