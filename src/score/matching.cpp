#include "score/matching.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "score/bit_matcher.h"

namespace ink::score {
namespace {

/// A part of an image; empty where a list is.
struct Box {
    int x0 = std::numeric_limits<int>::max();
    int y0 = std::numeric_limits<int>::max();
    int x1 = 0;  ///< behind the last
    int y1 = 0;
};

Box box_of(const PixelList& pixels) {
    Box box;
    for (int y = 0; y < pixels.height_px(); ++y) {
        const std::size_t begin = pixels.row_begin(y), end = pixels.row_begin(y + 1);
        if (begin == end) continue;
        box = {std::min(box.x0, pixels.x(begin)),
               std::min(box.y0, y),
               std::max(box.x1, pixels.x(end - 1) + 1),
               y + 1};
    }
    return box;
}

/// A matcher of the two lists, on the part of the image where they are near each other; nothing if
/// they nowhere are.
std::optional<BitMatcher> matcher_of(const PixelList& left,
                                     const PixelList& right,
                                     const Disk& disk) {
    if (left.is_empty() || right.is_empty()) return std::nullopt;
    const Box a = box_of(left), b = box_of(right);
    const int reach = disk.radius_px();
    const Box box{std::max({0, std::max(a.x0, b.x0) - reach}),
                  std::max({0, std::max(a.y0, b.y0) - reach}),
                  std::min(std::max(a.x1, b.x1), std::min(a.x1, b.x1) + reach),
                  std::min(std::max(a.y1, b.y1), std::min(a.y1, b.y1) + reach)};
    if (box.x0 >= box.x1 || box.y0 >= box.y1) return std::nullopt;
    std::optional<BitMatcher> matcher(std::in_place, box.x1 - box.x0, box.y1 - box.y0, disk);
    matcher->set_left(left, box.x0, box.y0);
    matcher->set_right(right, box.x0, box.y0);
    return matcher;
}

}  // namespace

MatchCounts match_pixels(const PixelList& left, const PixelList& right, const Disk& disk) {
    std::optional<BitMatcher> matcher = matcher_of(left, right, disk);
    if (!matcher) return {};
    return {.k = matcher->match(),
            .left_reached = matcher->left_reached(),
            .right_reached = matcher->right_reached()};
}

std::int64_t count_pairs(const PixelList& left, const PixelList& right, const Disk& disk) {
    std::optional<BitMatcher> matcher = matcher_of(left, right, disk);
    return matcher ? matcher->match() : 0;
}

}  // namespace ink::score
