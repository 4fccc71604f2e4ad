#pragma once

#include <cstdint>

#include "raster/pass/screen_vertex.h"

namespace ink::raster {

/// The fragments of one line as OpenGL rasterizes it (specification 2.1, sections 3.4.1 and
/// 3.4.2.1): at each step along its longer axis (x if both are equal) a run of `width_px` pixels on
/// the other, by the diamond-exit rule.
///
/// A line of width w is that of width 1 moved by (w-1)/2 px on its shorter axis, left or, in
/// OpenGL's window, which has y up, down; each of its fragments is the first of a run to the right
/// or up. What lies exactly on the border of a diamond falls as if the line were moved by (-e,
/// -e^2) in that window. Ends are whole numbers of 1/256 px, so all of it is exact, and a chain of
/// lines that go the same way has no pixel twice at its joints and leaves none out.
///
/// Which steps are an end's first and last is decided before the line is moved. The specification
/// has them decided after; Mesa does as is done here, at even widths half a pixel makes the
/// difference, and images were to agree with an OpenGL that exists.
class LineSteps {
  public:
    /// From `a` to `b`, both within the guard band; width_px >= 1. A line without length has no
    /// steps. `is_both_ways`: all steps that it has from a to b or from b to a, as an edge between
    /// two triangles is drawn.
    LineSteps(const ScreenVertex& a,
              const ScreenVertex& b,
              int width_px,
              bool is_both_ways = false);

    /// Whether steps are columns and runs go down them; else steps are rows.
    [[nodiscard]] bool is_x_major() const { return is_x_major_; }
    /// Steps [begin, end).
    [[nodiscard]] int begin() const { return begin_; }
    [[nodiscard]] int end() const { return end_; }

    /// Goes to a step of [begin, end), and on to the next.
    void start(int step);
    void advance() {
        remainder_ += kSubpixels * rise_;
        if (remainder_ < 0) {
            remainder_ += divisor_;
            --quotient_;
        } else if (remainder_ >= divisor_) {
            remainder_ -= divisor_;
            ++quotient_;
        }
    }
    /// The run's least pixel on the other axis; it goes to first + width - 1.
    [[nodiscard]] int first() const { return quotient_ - below_; }

  private:
    /// 1/256 px along the steps and across them.
    struct Point {
        std::int64_t along;
        std::int64_t across;
    };
    [[nodiscard]] Point point(const ScreenVertex& v) const;
    [[nodiscard]] int bound(const Point& p, bool is_upwards);
    [[nodiscard]] bool is_in_diamond(const Point& p, int step);

    bool is_x_major_ = true;
    int below_ = 0;  ///< pixels of a run before that of the moved line
    int begin_ = 0;
    int end_ = 0;
    // At step s the moved line is in pixel floor((at_zero_ + s * 256 rise_) / divisor_).
    std::int64_t rise_ = 0;
    std::int64_t divisor_ = 1;
    std::int64_t at_zero_ = 0;
    std::int64_t remainder_ = 0;
    int quotient_ = 0;
};

}  // namespace ink::raster
