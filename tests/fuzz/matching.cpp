// The matching is as large as any, by trying all.

#include "score/matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/image.h"
#include "edge/bit_mask.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

using Image = core::Image<std::uint8_t>;

constexpr std::size_t kMostPixels = 10;  // of the right side: all their subsets are tried

struct Pixel {
    int x = 0;
    int y = 0;
};

bool is_reached(const Pixel& a, const Pixel& b, double square) {
    const int dx = a.x - b.x;
    const int dy = a.y - b.y;
    return dx * dx + dy * dy <= square;
}

/// The most pairs: for each set of right pixels that are taken, the most left pixels that could be
/// placed on them.
std::int64_t most_pairs(const std::vector<Pixel>& left,
                        const std::vector<Pixel>& right,
                        double square) {
    std::vector<int> best(std::size_t{1} << right.size(), -1);
    best[0] = 0;
    for (const Pixel& pixel : left) {
        for (std::size_t taken = best.size(); taken-- > 0;) {
            for (std::size_t r = 0; r < right.size() && best[taken] >= 0; ++r) {
                const std::size_t more = taken | std::size_t{1} << r;
                if (more == taken || !is_reached(pixel, right[r], square)) continue;
                best[more] = std::max(best[more], best[taken] + 1);
            }
        }
    }
    return *std::max_element(best.begin(), best.end());
}

std::int64_t reached(const std::vector<Pixel>& from, const std::vector<Pixel>& to, double square) {
    return std::count_if(from.begin(), from.end(), [&](const Pixel& a) {
        return std::any_of(
            to.begin(), to.end(), [&](const Pixel& b) { return is_reached(a, b, square); });
    });
}

/// Up to kMostPixels different pixels near (x, y).
std::vector<Pixel> pixels(Feed& feed, const Pixel& middle, Image& image) {
    std::vector<Pixel> all;
    for (std::size_t left = static_cast<std::size_t>(feed.whole(0, kMostPixels)); left > 0;
         --left) {
        const int place = feed.whole(0, 255);
        const Pixel pixel{(middle.x + place % 16) % image.width_px(),
                          (middle.y + place / 16) % image.height_px()};
        if (image.at(pixel.x, pixel.y) != 0) continue;
        image.at(pixel.x, pixel.y) = 1;
        all.push_back(pixel);
    }
    return all;
}

}  // namespace

void check_matching(Bytes bytes) {
    Feed feed(bytes);
    // Squares of distances between pixels, and one that is none.
    constexpr std::array kSquares{0.25, 1.0, 2.0, 4.0, 5.0, 6.25, 9.0, 16.0, 64.0};
    const double square = kSquares[static_cast<std::size_t>(feed.whole(0, kSquares.size() - 1))];
    const score::Disk disk(std::sqrt(square));
    const int width_px = feed.whole(1, 200);  // words that are cut, and one between others
    const int height_px = feed.whole(1, 20);
    const Pixel middle{feed.whole(0, 199), feed.whole(0, 19)};
    Image left_image(width_px, height_px);
    std::vector<Pixel> left = pixels(feed, middle, left_image);
    score::BitMatcher matcher(width_px, height_px, disk);
    // One side is replaced, twice, and the other loses a pixel: a BitMatcher goes on from the pairs
    // that it found before.
    for (int round = 0; round < 3; ++round) {
        Image right_image(width_px, height_px);
        const std::vector<Pixel> right = pixels(feed, middle, right_image);
        const score::PixelList a(left_image), b(right_image);
        const std::int64_t k = most_pairs(left, right, square);
        const std::int64_t from_left = reached(left, right, square);
        const std::int64_t from_right = reached(right, left, square);
        const score::MatchCounts counts = score::match_pixels(a, b, disk);
        expect(counts.k == k, "match_pixels finds the most pairs");
        expect(counts.left_reached == from_left, "it counts left pixels in reach");
        expect(counts.right_reached == from_right, "it counts right pixels in reach");
        expect(score::match_pixels(b, a, disk).k == k, "it is symmetric");
        edge::BitMask left_bits(left_image);
        matcher.set_left(left_bits.words());
        matcher.set_right(b);
        expect(matcher.match() == k, "a BitMatcher finds the most pairs");
        expect(matcher.left_reached() == from_left, "it counts left pixels in reach");
        expect(matcher.right_reached() == from_right, "it counts right pixels in reach");
        if (round == 1 && !left.empty()) {
            left_image.at(left.back().x, left.back().y) = 0;
            left.pop_back();
        }
    }
}

}  // namespace ink::fuzz
