#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image.h"
#include "raster/pass/pass.h"

namespace ink::raster {

/// Puts the tiles' own pixels together to whole images. T is the store's type, D the depth's.
template <class T, class D = float>
class GatherSink : public TileSink {
  public:
    GatherSink(const PassFormat& format, int width_px, int height_px)
        : depth(width_px, height_px), plane_count_(format.planes()) {
        for (int i = 0; i < plane_count_; ++i)
            planes[static_cast<std::size_t>(i)] = core::Image<T>(width_px, height_px);
    }

    void finish(const Tile& tile) override {
        for (int y = 0; y < tile.height_px; ++y) {
            for (int x = 0; x < tile.width_px; ++x) {
                depth.at(tile.x0_px + x, tile.y0_px + y) = tile.depth_row<D>(y)[x];
                for (int i = 0; i < plane_count_; ++i) {
                    planes[static_cast<std::size_t>(i)].at(tile.x0_px + x, tile.y0_px + y) =
                        tile.row<T>(i, y)[x];
                }
            }
        }
    }

    core::Image<D> depth;
    std::array<core::Image<T>, kMaxPlanes> planes;

  private:
    int plane_count_;
};

/// One pass on one thread, put together.
template <class T, class D = float>
GatherSink<T, D> gathered(const PassFormat& format,
                          const PassInput& input,
                          int width_px,
                          int height_px) {
    GatherSink<T, D> sink(format, width_px, height_px);
    draw_pass(format, input, width_px, height_px, 1, sink);
    return sink;
}

/// What plane `k` of a tile has at a pixel, whatever it stores.
inline std::uint32_t word_at(const Tile& tile, Store store, int k, int x, int y) {
    if (store == Store::u8) return tile.row<std::uint8_t>(k, y)[x];
    if (store == Store::u16) return tile.row<std::uint16_t>(k, y)[x];
    return tile.row<std::uint32_t>(k, y)[x];
}

/// All words of a pixel of a tile: depth and planes.
inline void append_words(
    const Tile& tile, const PassFormat& format, int x, int y, std::vector<std::uint32_t>& words) {
    words.push_back(tile.depth_row<std::uint32_t>(y)[x]);
    for (int k = 0; k < format.planes(); ++k)
        words.push_back(word_at(tile, format.store, k, x, y));
}

/// Triangles with all that a pass may want of them, owned.
struct TestMesh {
    std::vector<glm::dvec3> p_clip;
    std::vector<scene::Triangle> triangles;
    std::vector<float> values;

    [[nodiscard]] PassInput input() const {
        PassInput result;
        result.p_clip = p_clip;
        result.triangles = triangles;
        result.values = values;
        result.near = 0.5;
        result.far = 100;
        return result;
    }
    /// A vertex at (x, y) px and distance w.
    std::uint32_t add(double x_px, double y_px, double w = 1) {
        p_clip.emplace_back(x_px * w, y_px * w, w);
        return static_cast<std::uint32_t>(p_clip.size() - 1);
    }
    /// A triangle of three new vertices.
    void add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const auto first = static_cast<std::uint32_t>(p_clip.size());
        for (const glm::dvec3& v : {a, b, c})
            add(v.x, v.y, v.z);
        triangles.push_back({first, first + 1, first + 2});
    }
};

/// A format that keeps the index of the nearest triangle, with `constants` = 0, 1, 2, ...
inline PassFormat id_format() {
    return {.constant = true, .store = Store::u32};
}

inline constexpr std::uint32_t kNobody = 0xffffffffU;

/// Ids and depths of what is nearest.
inline GatherSink<std::uint32_t> draw_ids(PassInput input, int width_px, int height_px) {
    std::vector<std::uint32_t> ids(input.triangles.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
        ids[i] = static_cast<std::uint32_t>(i);
    input.constants = ids;
    input.sky_code = {kNobody};
    return gathered<std::uint32_t>(id_format(), input, width_px, height_px);
}

/// How many triangles cover each pixel, each drawn by itself.
inline core::Image<int> count_coverage(const PassInput& input, int width_px, int height_px) {
    core::Image<int> count(width_px, height_px);
    PassInput one = input;
    for (std::size_t t = 0; t < input.triangles.size(); ++t) {
        one.triangles = input.triangles.subspan(t, 1);
        const auto drawn = draw_ids(one, width_px, height_px);
        for (std::size_t p = 0; p < count.size(); ++p)
            count.data()[p] += drawn.planes[0].data()[p] == kNobody ? 0 : 1;
    }
    return count;
}

}  // namespace ink::raster
