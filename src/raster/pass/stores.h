#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "raster/pass/tile_buffer.h"
#include "raster/pass/triangle_stage.h"

/// What a pass does at a pixel, as types that the fill loop is compiled with: its only two choices.
/// A depth store turns q into the format's number. An attribute store is made per triangle, told
/// each row, and writes one pixel. They copy what they need, so that it stays in registers: a store
/// of bytes could alias anything.
namespace ink::raster {

struct FloatDepth {
    using Value = float;
    explicit FloatDepth(const QuantisedDepth&) {}
    [[nodiscard]] Value of(double q) const { return static_cast<float>(q); }
};

struct StepDepth {
    using Value = std::uint32_t;
    explicit StepDepth(const QuantisedDepth& depth) : depth_(depth) {}
    [[nodiscard]] Value of(double q) const { return depth_.of(q); }

  private:
    QuantisedDepth depth_;
};

/// The triangle that is being filled and where its planes are found.
struct FillSource {
    const PassFormat& format;
    const PassInput& input;
    const Batch& batch;
    std::uint32_t index = 0;

    [[nodiscard]] const SetupTriangle& triangle() const { return batch.triangles[index]; }
    [[nodiscard]] std::uint32_t constant() const {
        return format.constant ? input.constants[triangle().triangle] : 0;
    }
};

/// Depth alone.
class NoStore {
  public:
    explicit NoStore(const FillSource&) {}
    void start_row(TileBuffer&, int) {}
    void write(int, double) const {}
};

/// The low bits of the triangle's constant.
template <class T>
class ConstantStore {
  public:
    explicit ConstantStore(const FillSource& from) : constant_(static_cast<T>(from.constant())) {}
    void start_row(TileBuffer& buffer, int y) { row_ = buffer.plane_row<T>(0, y); }
    void write(int x, double) const { row_[x] = constant_; }

  private:
    T constant_;
    T* row_ = nullptr;
};

/// A 48.16 code as the store keeps it.
template <class T, Overflow kOverflow>
[[nodiscard]] T stored_code(std::int64_t fixed) {
    constexpr std::int64_t kMost = std::numeric_limits<T>::max();
    const std::int64_t code = fixed >> kCodeFractionBits;
    if constexpr (kOverflow == Overflow::wrap) return static_cast<T>(code & kMost);
    return static_cast<T>(std::clamp<std::int64_t>(code, 0, kMost));
}

/// K integer planes, affine.
template <class T, std::size_t kCount, Overflow kOverflow>
class CodeStore {
  public:
    explicit CodeStore(const FillSource& from)
        : ref_x_(from.triangle().ref_x),
          ref_y_(from.triangle().ref_y),
          is_thin_(from.triangle().is_thin) {
        std::copy_n(from.batch.code_planes.data() + from.index * kCount, kCount, planes_.begin());
    }
    void start_row(TileBuffer& buffer, int y) {
        for (std::size_t k = 0; k < kCount; ++k) {
            rows_[k] = buffer.code_row(static_cast<int>(k), y);
            at_row_[k] = planes_[k].at_ref + planes_[k].dy * (y - ref_y_);
        }
    }
    void write(int x, double) const {
        for (std::size_t k = 0; k < kCount; ++k) {
            std::int64_t fixed = at_row_[k] + planes_[k].dx * (x - ref_x_);
            if (is_thin_) fixed = std::clamp(fixed, planes_[k].lowest, planes_[k].highest);
            rows_[k][x] = stored_code<T, kOverflow>(fixed);
        }
    }

  private:
    int ref_x_;
    int ref_y_;
    bool is_thin_;
    std::array<CodePlane, kCount> planes_;
    std::array<std::int64_t, kCount> at_row_{};
    std::array<std::uint32_t*, kCount> rows_{};
};

/// What FloatStore and PerspectiveStore share: K planes in double, followed row by row.
template <class T, std::size_t kCount>
class FloatPlaneRows {
    /// Codes are drawn with 32 bits.
    using Drawn = std::conditional_t<std::is_same_v<T, float>, float, std::uint32_t>;

  public:
    explicit FloatPlaneRows(const FillSource& from)
        : ref_x_(from.triangle().ref_x), ref_y_(from.triangle().ref_y) {
        std::copy_n(from.batch.float_planes.data() + from.index * kCount, kCount, planes_.begin());
    }
    void start_row(TileBuffer& buffer, int y) {
        for (std::size_t k = 0; k < kCount; ++k) {
            rows_[k] = buffer.plane_row<Drawn>(static_cast<int>(k), y);
            at_row_[k] = planes_[k].plane.at_ref + planes_[k].plane.dy * (y - ref_y_);
        }
    }
    [[nodiscard]] double at(std::size_t k, int x) const {
        return at_row_[k] + planes_[k].plane.dx * (x - ref_x_);
    }
    [[nodiscard]] float limited(std::size_t k, double value) const {
        return std::clamp(static_cast<float>(value), planes_[k].lowest, planes_[k].highest);
    }
    [[nodiscard]] Drawn& pixel(std::size_t k, int x) const { return rows_[k][x]; }

  private:
    int ref_x_;
    int ref_y_;
    std::array<FloatPlane, kCount> planes_;
    std::array<double, kCount> at_row_{};
    std::array<Drawn*, kCount> rows_{};
};

/// K floats, affine.
template <std::size_t kCount>
class FloatStore {
  public:
    explicit FloatStore(const FillSource& from)
        : planes_(from), is_thin_(from.triangle().is_thin) {}
    void start_row(TileBuffer& buffer, int y) { planes_.start_row(buffer, y); }
    void write(int x, double) const {
        for (std::size_t k = 0; k < kCount; ++k) {
            const double v = planes_.at(k, x);
            planes_.pixel(k, x) = is_thin_ ? planes_.limited(k, v) : static_cast<float>(v);
        }
    }

  private:
    FloatPlaneRows<float, kCount> planes_;
    bool is_thin_;
};

/// K floats or codes, linear on the surface: a division a pixel and plane.
template <class T, std::size_t kCount, Overflow kOverflow>
class PerspectiveStore {
  public:
    explicit PerspectiveStore(const FillSource& from)
        : planes_(from),
          constant_(static_cast<std::int64_t>(from.constant()) << kCodeFractionBits) {}
    void start_row(TileBuffer& buffer, int y) { planes_.start_row(buffer, y); }
    void write(int x, double q) const {
        for (std::size_t k = 0; k < kCount; ++k) {
            const float v = planes_.limited(k, planes_.at(k, x) / q);
            if constexpr (std::is_same_v<T, float>) {
                planes_.pixel(k, x) = v;
            } else {
                planes_.pixel(k, x) = stored_code<T, kOverflow>(to_fixed(v) + constant_);
            }
        }
    }

  private:
    [[nodiscard]] static std::int64_t to_fixed(float v) {
        constexpr double kFarthest = 0x1p60;
        const double fixed = std::floor(static_cast<double>(v) * (1 << kCodeFractionBits));
        return static_cast<std::int64_t>(std::clamp(fixed, -kFarthest, kFarthest));
    }

    FloatPlaneRows<T, kCount> planes_;
    std::int64_t constant_;  ///< 48.16
};

}  // namespace ink::raster
