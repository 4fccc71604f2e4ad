#include "edge/thin.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

#include "edge/set_pixels.h"

namespace ink::edge {
namespace {

/// The paper's x1..x8 are bits 0..7: counter-clockwise from the right-hand neighbour.
constexpr bool neighbour(unsigned ring, int i) {
    return ((ring >> ((i - 1) & 7)) & 1U) != 0;
}

/// G1, G2 and the subiteration's G3: may a pixel with these neighbours go?
constexpr bool is_removable(unsigned ring, bool is_second) {
    int crossings = 0;
    int pairs_from_odd = 0;
    int pairs_from_even = 0;
    for (int i = 1; i <= 7; i += 2) {
        const bool side = neighbour(ring, i);
        const bool corner = neighbour(ring, i + 1);
        const bool next_side = neighbour(ring, i + 2);
        crossings += !side && (corner || next_side);
        pairs_from_odd += side || corner;
        pairs_from_even += corner || next_side;
    }
    const int pairs = std::min(pairs_from_odd, pairs_from_even);
    const int o = is_second ? 4 : 0;  // G3' is G3 turned by 180 degrees
    const bool keeps_side =
        (neighbour(ring, 2 + o) || neighbour(ring, 3 + o) || !neighbour(ring, 8 + o)) &&
        neighbour(ring, 1 + o);
    return crossings == 1 && pairs >= 2 && pairs <= 3 && !keeps_side;
}

constexpr std::array<std::array<bool, 256>, 2> make_removable() {
    std::array<std::array<bool, 256>, 2> table{};
    for (unsigned ring = 0; ring < 256; ++ring) {
        table[0][ring] = is_removable(ring, false);
        table[1][ring] = is_removable(ring, true);
    }
    return table;
}
constexpr auto kRemovable = make_removable();

constexpr std::uint8_t kSet = 1;
/// A pixel that waits to be looked at in the first (shifted by one: second) subiteration.
constexpr std::uint8_t kWaits = 2;

/// The mask inside a frame of zeros one pixel wide, with a list of pixels to look at per
/// subiteration.
///
/// A pixel that stayed can go later only after one of its neighbours went. So after each
/// subiteration has seen every pixel once, only neighbours of removed pixels are looked at again:
/// the same result as full passes, since each subiteration removes all its pixels at once.
class Thinner {
  public:
    explicit Thinner(const Mask& mask);
    void run();
    [[nodiscard]] Mask result() const;

  private:
    [[nodiscard]] unsigned ring(std::ptrdiff_t p) const;
    bool subiterate(int which);
    void remove(std::ptrdiff_t p);

    int width_px_;
    int height_px_;
    std::ptrdiff_t stride_;
    std::array<std::ptrdiff_t, 8> to_neighbour_;  ///< in the order of x1..x8
    std::vector<std::uint8_t> cells_;
    std::array<std::vector<std::ptrdiff_t>, 2> waiting_;
    std::vector<std::ptrdiff_t> looked_at_;
    std::vector<std::ptrdiff_t> doomed_;
};

Thinner::Thinner(const Mask& mask)
    : width_px_(mask.width_px()),
      height_px_(mask.height_px()),
      stride_(mask.width_px() + 2),
      to_neighbour_{1, 1 - stride_, -stride_, -1 - stride_, -1, stride_ - 1, stride_, stride_ + 1},
      cells_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_px_ + 2)) {
    for (int y = 0; y < height_px_; ++y) {
        const std::uint8_t* from = mask.row(y);
        const std::ptrdiff_t first = (y + 1) * stride_ + 1;
        visit_set_pixels(from, width_px_, [&](int x) {
            cells_[static_cast<std::size_t>(first + x)] = kSet | kWaits | (kWaits << 1);
            waiting_[0].push_back(first + x);
        });
    }
    waiting_[1] = waiting_[0];
}

unsigned Thinner::ring(std::ptrdiff_t p) const {
    const std::uint8_t* centre = cells_.data() + p;
    unsigned bits = 0;
    for (unsigned i = 0; i < 8; ++i) {
        bits |= static_cast<unsigned>(centre[to_neighbour_[i]] & kSet) << i;
    }
    return bits;
}

void Thinner::remove(std::ptrdiff_t p) {
    cells_[static_cast<std::size_t>(p)] = 0;
    for (const std::ptrdiff_t step : to_neighbour_) {
        std::uint8_t& cell = cells_[static_cast<std::size_t>(p + step)];
        if ((cell & kSet) == 0) continue;
        for (unsigned which = 0; which < 2; ++which) {
            const auto waits = static_cast<std::uint8_t>(kWaits << which);
            if ((cell & waits) == 0) waiting_[which].push_back(p + step);
            cell |= waits;
        }
    }
}

/// Returns whether any pixel went.
bool Thinner::subiterate(int which) {
    const auto waits = static_cast<std::uint8_t>(kWaits << which);
    const auto& removable = kRemovable[static_cast<std::size_t>(which)];
    looked_at_.swap(waiting_[static_cast<std::size_t>(which)]);
    doomed_.clear();
    for (const std::ptrdiff_t p : looked_at_) {
        std::uint8_t& cell = cells_[static_cast<std::size_t>(p)];
        if ((cell & kSet) == 0) continue;
        cell = static_cast<std::uint8_t>(cell & ~waits);
        if (removable[ring(p)]) doomed_.push_back(p);
    }
    looked_at_.clear();
    for (const std::ptrdiff_t p : doomed_)
        remove(p);
    return !doomed_.empty();
}

void Thinner::run() {
    bool has_changed = true;
    while (has_changed) {
        const bool first = subiterate(0);
        const bool second = subiterate(1);
        has_changed = first || second;
    }
}

Mask Thinner::result() const {
    Mask mask(width_px_, height_px_);
    for (int y = 0; y < height_px_; ++y) {
        const std::uint8_t* from = cells_.data() + (y + 1) * stride_ + 1;
        std::uint8_t* to = mask.row(y);
        for (int x = 0; x < width_px_; ++x) {
            to[x] = from[x] & kSet;
        }
    }
    return mask;
}

}  // namespace

Mask thin(const Mask& mask) {
    Thinner thinner(mask);
    thinner.run();
    return thinner.result();
}

}  // namespace ink::edge
