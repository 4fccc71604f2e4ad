#include <numeric>

#include "core/disjoint_sets.h"
#include "score/motion.h"

namespace ink::score {
namespace {

/// The false pixels of a frame, numbered on from those of the frames before.
struct FalsePixels {
    PixelList pixels;
    std::size_t first = 0;
};

std::vector<FalsePixels> false_pixels(std::span<const MotionFrame> frames, const Disk& disk) {
    std::vector<FalsePixels> result;
    std::size_t first = 0;
    for (const MotionFrame& frame : frames) {
        PixelList pixels = frame.counted;
        pixels.drop(within_reach(pixels, frame.truth, disk));
        const std::size_t size = pixels.size();
        result.push_back({std::move(pixels), first});
        first += size;
    }
    return result;
}

/// Joins each pixel of `a` with those of `b` within `disk`.
void join_reached(const FalsePixels& a,
                  const FalsePixels& b,
                  const Disk& disk,
                  core::DisjointSets& groups) {
    visit_reach(a.pixels, b.pixels, disk, [&](std::size_t i, std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            groups.join(static_cast<std::uint32_t>(a.first + i),
                        static_cast<std::uint32_t>(b.first + k));
    });
}

}  // namespace

std::vector<FalseLine> false_lines(std::span<const MotionFrame> frames, double tolerance_px) {
    if (frames.empty()) return {};
    const Disk disk(tolerance_px);
    const Disk touching(1.5);  // the 8 neighbours
    const std::vector<FalsePixels> all = false_pixels(frames, disk);
    const std::size_t count = all.back().first + all.back().pixels.size();
    core::DisjointSets groups(count);
    for (std::size_t t = 0; t < all.size(); ++t) {
        join_reached(all[t], all[t], touching, groups);
        if (t > 0) join_reached(all[t - 1], all[t], disk, groups);
    }

    std::vector<FalseLine> lines;
    std::vector<std::size_t> line_of(count);
    const int last = static_cast<int>(frames.size()) - 1;
    for (int t = 0; t <= last; ++t) {
        const FalsePixels& now = all[static_cast<std::size_t>(t)];
        for (std::size_t i = now.first; i < now.first + now.pixels.size(); ++i) {
            // A root is the first pixel of its line, so lines come in order.
            const std::size_t root = groups.root(static_cast<std::uint32_t>(i));
            if (root == i) {
                line_of[i] = lines.size();
                lines.push_back({.first_frame = t});
            }
            FalseLine& line = lines[line_of[root]];
            line.last_frame = t;
            line.is_cut = line.first_frame == 0 || t == last;
            ++line.n_px;
        }
    }
    return lines;
}

std::vector<std::int64_t> life_counts(std::span<const FalseLine> lines) {
    std::vector<std::int64_t> counts;
    for (const FalseLine& line : lines) {
        const auto life = static_cast<std::size_t>(line.life());
        if (counts.size() < life) counts.resize(life);
        ++counts[life - 1];
    }
    return counts;
}

}  // namespace ink::score
