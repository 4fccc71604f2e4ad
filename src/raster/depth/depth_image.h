#pragma once

#include <bit>
#include <cstdint>

#include "core/image.h"
#include "raster/depth/depth.h"
#include "raster/pass/pass.h"

namespace ink::raster {

/// A frame's depth in one of the formats of the depth test: what lines are tested against.
///
/// A pixel holds 32 bits: a whole number of steps (z24, z16), or the float q (q32). Numbers of both
/// kinds are at least 0, so that their bits compare as they do: more is nearer, 0 is sky.
class DepthImage {
  public:
    DepthImage() = default;

    /// Makes it that of a frame, holding anything; `near` and `far` are not looked at for q32.
    void start(DepthFormat format, double near, double far, int width_px, int height_px);

    [[nodiscard]] DepthFormat format() const { return format_; }
    [[nodiscard]] double near() const { return near_; }
    [[nodiscard]] double far() const { return far_; }
    [[nodiscard]] core::Image<std::uint32_t>& bits() { return bits_; }
    [[nodiscard]] const core::Image<std::uint32_t>& bits() const { return bits_; }

  private:
    DepthFormat format_ = DepthFormat::q32;
    double near_ = 0;
    double far_ = 0;
    core::Image<std::uint32_t> bits_;
};

/// Fills a DepthImage that was started for the pass's format and size; every tile, sky included.
class DepthSink : public TileSink {
  public:
    explicit DepthSink(DepthImage& image) : image_(image) {}
    void finish(const Tile& tile) override;

  private:
    DepthImage& image_;
};

/// The same for many: one of the two is compiled into a loop.
struct FloatBits {
    explicit FloatBits(const DepthImage&) {}
    [[nodiscard]] std::uint32_t of(double q) const {
        return q > 0 ? std::bit_cast<std::uint32_t>(static_cast<float>(q)) : 0;
    }
};
struct StepBits {
    explicit StepBits(const DepthImage& image)
        : depth_(image.format(), image.near(), image.far()) {}
    [[nodiscard]] std::uint32_t of(double q) const { return depth_.of(q); }

  private:
    QuantisedDepth depth_;
};

}  // namespace ink::raster
