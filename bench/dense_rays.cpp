#include "bench/dense_rays.h"

#include <algorithm>
#include <vector>

#include "core/hash.h"

namespace ink::bench {
namespace {

constexpr int kGrid = 16;  ///< rays a pixel, each way

bool is_one(const PacketIds& ids, std::uint32_t id) {
    return std::all_of(ids.begin(), ids.end(), [id](std::uint32_t i) { return i == id; });
}

/// Counts mixed pixels and remembers which.
class Mixed {
  public:
    void add(int x, int y) {
        ++count_;
        places_.value(x).value(y);
    }
    [[nodiscard]] DenseCounts with(std::size_t rays) const { return {rays, count_, places_.hex()}; }

  private:
    std::size_t count_ = 0;
    core::Hasher places_;
};

}  // namespace

DenseRays::DenseRays(const scene::Scene& scene, const scene::View& view)
    : tree_(scene, view), width_px_(view.width_px), height_px_(view.height_px) {}

/// All 256 rays of a pixel; whether they see more than one thing.
bool DenseRays::is_mixed(int x, int y) const {
    constexpr double kStep = 1.0 / kGrid;
    bool is_pure = true;
    std::uint32_t first = 0;
    for (int block = 0; block < kGrid * kGrid / kPacket; ++block) {
        const PacketIds ids = tree_.cast(x + (block % kPacketSide * kPacketSide + 0.5) * kStep,
                                         y + (block / kPacketSide * kPacketSide + 0.5) * kStep,
                                         kStep);
        if (block == 0) first = ids[0];
        is_pure = is_pure && is_one(ids, first);
    }
    return !is_pure;
}

DenseCounts DenseRays::cast_everywhere() const {
    Mixed mixed;
    for (int y = 0; y < height_px_; ++y) {
        for (int x = 0; x < width_px_; ++x) {
            if (is_mixed(x, y)) mixed.add(x, y);
        }
    }
    return mixed.with(static_cast<std::size_t>(width_px_) * height_px_ * kGrid * kGrid);
}

DenseCounts DenseRays::cast_adaptive() const {
    // Rays at the pixels' own corners are shared by four pixels: a pixel whose corners and those of
    // its eight neighbours see one triangle is taken to show nothing else.
    const auto whole = [](int n) { return (n + kPacketSide) / kPacketSide * kPacketSide; };
    const int columns = whole(width_px_);
    const int rows = whole(height_px_);
    std::vector<std::uint32_t> corner(static_cast<std::size_t>(columns) * rows);
    for (int y = 0; y < rows; y += kPacketSide) {
        for (int x = 0; x < columns; x += kPacketSide) {
            const PacketIds ids = tree_.cast(x, y, 1);
            for (int i = 0; i < kPacket; ++i)
                corner[static_cast<std::size_t>(y + i / kPacketSide) * columns + x +
                       i % kPacketSide] = ids[static_cast<std::size_t>(i)];
        }
    }
    Mixed mixed;
    std::size_t rays = corner.size();
    for (int y = 0; y < height_px_; ++y) {
        for (int x = 0; x < width_px_; ++x) {
            const std::uint32_t id = corner[static_cast<std::size_t>(y) * columns + x];
            bool is_pure = true;
            for (int j = std::max(0, y - 1); j <= std::min(y + 2, height_px_) && is_pure; ++j) {
                for (int i = std::max(0, x - 1); i <= std::min(x + 2, width_px_); ++i)
                    is_pure = is_pure && corner[static_cast<std::size_t>(j) * columns + i] == id;
            }
            if (is_pure) continue;
            rays += kGrid * kGrid;
            if (is_mixed(x, y)) mixed.add(x, y);
        }
    }
    return mixed.with(rays);
}

}  // namespace ink::bench
