#include "score/matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "edge/bit_mask.h"
#include "score/pixel_list.h"
#include "tests/score/images.h"
#include "tests/score/plain_matching.h"

namespace {

using ink::score::BitMatcher;
using ink::score::Disk;
using ink::score::DrawnMatcher;
using ink::score::match_pixels;
using ink::score::MatchCounts;
using ink::score::PixelList;
using ink::score::PlainMatching;
using ink::score::reach_of;
using ink::score::within_reach;

using Points = std::vector<std::pair<int, int>>;

Points points_of(const Image& image) {
    Points points;
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            if (image.at(x, y) != 0) points.emplace_back(x, y);
        }
    }
    return points;
}

int square_distance(std::pair<int, int> a, std::pair<int, int> b) {
    const int dx = a.first - b.first;
    const int dy = a.second - b.second;
    return dx * dx + dy * dy;
}

/// The best over every way to match left points from `i` on: tries them all.
int best_by_trying(
    const Points& left, const Points& right, std::size_t i, int limit, unsigned used) {
    if (i == left.size()) return 0;
    int best = best_by_trying(left, right, i + 1, limit, used);
    for (std::size_t j = 0; j < right.size(); ++j) {
        if ((used >> j & 1U) != 0 || square_distance(left[i], right[j]) > limit) continue;
        best = std::max(best, 1 + best_by_trying(left, right, i + 1, limit, used | 1U << j));
    }
    return best;
}

std::int64_t reached_by_trying(const Points& from, const Points& to, int limit) {
    return std::count_if(from.begin(), from.end(), [&](auto a) {
        return std::any_of(
            to.begin(), to.end(), [&](auto b) { return square_distance(a, b) <= limit; });
    });
}

MatchCounts match(const Image& left, const Image& right, double tolerance_px) {
    return match_pixels(PixelList(left), PixelList(right), Disk(tolerance_px));
}

TEST(Matching, EqualsTryingEverythingOnSmallSets) {
    std::mt19937 random(11);
    const std::array limits = {1, 2, 4, 9};
    for (int i = 0; i < 400; ++i) {
        const Image a = random_image(5, 4, 0.25, 255, random);
        const Image b = random_image(5, 4, 0.30, 255, random);
        const Points left = points_of(a);
        const Points right = points_of(b);
        const int limit = limits[static_cast<std::size_t>(i) % limits.size()];
        const MatchCounts counts = match(a, b, std::sqrt(limit));
        const int k = best_by_trying(left, right, 0, limit, 0);
        ASSERT_EQ(counts.k, k) << "pair " << i;
        ASSERT_EQ(PlainMatching(PixelList(a), PixelList(b), Disk(std::sqrt(limit))).size(), k);
        ASSERT_EQ(counts.left_reached, reached_by_trying(left, right, limit)) << "pair " << i;
        ASSERT_EQ(counts.right_reached, reached_by_trying(right, left, limit)) << "pair " << i;
    }
}

TEST(Matching, EqualsThePlainMatcherOnLargerSets) {
    std::mt19937 random(13);
    for (int i = 0; i < 40; ++i) {
        for (const double tolerance_px : {1.0, 1.5, 2.0, 3.0, 4.0, 8.0}) {
            const Image a = random_image(50, 40, 0.01 + 0.01 * i, 255, random);
            const Image b = random_image(50, 40, 0.41 - 0.01 * i, 255, random);
            const Disk disk(tolerance_px);
            ASSERT_EQ(match(a, b, tolerance_px).k,
                      PlainMatching(PixelList(a), PixelList(b), disk).size())
                << tolerance_px << " px, pair " << i;
        }
    }
}

TEST(Matching, CountsCompetitionOverManyCopies) {
    Image wanting(400, 9);
    Image wanted(400, 9);
    for (int x = 5; x < 400; x += 10) {
        wanting.at(x - 1, 4) = wanting.at(x + 1, 4) = 1;
        wanted.at(x, 4) = 1;
    }
    const MatchCounts counts = match(wanting, wanted, 1);
    EXPECT_EQ(counts.k, 40);
    EXPECT_EQ(counts.left_reached, 80);
    EXPECT_EQ(counts.right_reached, 40);
}

TEST(Matching, TakesALongChainWhole) {
    // Left pixels 0, 2, .., 998 and right pixels 1, 3, .., 999: only the pairing (0,1) (2,3) ..
    // takes all.
    Image left(1000, 1);
    Image right(1000, 1);
    for (int x = 0; x < 1000; x += 2) {
        left.at(x, 0) = 1;
        right.at(x + 1, 0) = 1;
    }
    EXPECT_EQ(match(left, right, 1).k, 500);
}

TEST(Matching, IsTheSameFromBothSidesAndTransposed) {
    std::mt19937 random(12);
    for (int i = 0; i < 60; ++i) {
        const Image a = random_image(40, 30, 0.05 + 0.01 * i, 255, random);
        const Image b = random_image(40, 30, 0.20, 255, random);
        for (const double tolerance_px : {1.0, 1.5, 2.0, 3.0}) {
            const MatchCounts there = match(a, b, tolerance_px);
            const MatchCounts back = match(b, a, tolerance_px);
            const MatchCounts turned = match(transposed(a), transposed(b), tolerance_px);
            ASSERT_EQ(there.k, back.k);
            ASSERT_EQ(there.left_reached, back.right_reached);
            ASSERT_EQ(there.right_reached, back.left_reached);
            ASSERT_EQ(there.k, turned.k);
            ASSERT_EQ(there.left_reached, turned.left_reached);
        }
    }
}

TEST(Matching, OfNothingIsNothing) {
    const Image empty(8, 8);
    Image dot(8, 8);
    dot.at(3, 3) = 1;
    EXPECT_EQ(match(empty, empty, 2).k, 0);
    EXPECT_EQ(match(dot, empty, 2).k, 0);
    EXPECT_EQ(match(empty, dot, 2).right_reached, 0);
    EXPECT_EQ(match(Image(), Image(), 2).k, 0);
}

TEST(BitMatcher, EqualsThePlainMatcherAsSetsChange) {
    std::mt19937 random(14);
    constexpr int kWidth_px = 150, kHeight_px = 40;  // words that are cut, and one between others
    for (const double tolerance_px : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 8.0}) {
        const Disk disk(tolerance_px);
        BitMatcher matcher(kWidth_px, kHeight_px, disk);
        Image left(kWidth_px, kHeight_px), right(kWidth_px, kHeight_px);
        for (int round = 0; round < 30; ++round) {
            Image& changed = round % 5 == 4 ? right : left;
            const Image flips = random_image(kWidth_px, kHeight_px, 0.04, 1, random);
            for (std::size_t i = 0; i < flips.size(); ++i)
                changed.data()[i] ^= flips.data()[i];
            const PixelList a(left), b(right);
            ink::edge::BitMask left_bits(left);
            matcher.set_left(left_bits.words());
            matcher.set_right(b);
            ASSERT_EQ(matcher.match(), PlainMatching(a, b, disk).size())
                << tolerance_px << " px, round " << round;
            const auto reached = [](const std::vector<std::uint8_t>& is_reached) {
                return std::count(is_reached.begin(), is_reached.end(), 1);
            };
            ASSERT_EQ(matcher.left_reached(), reached(within_reach(a, b, disk)));
            ASSERT_EQ(matcher.right_reached(), reached(within_reach(b, a, disk)));
        }
    }
}

TEST(DrawnMatcher, MatchesOneSetAfterTheOtherAsEachAlone) {
    std::mt19937 random(7);
    for (const double tolerance_px : {0.5, 1.0, 2.0, 4.0, 8.0}) {
        const Disk disk(tolerance_px);
        for (const double drawn_share : {0.05, 0.0}) {
            const PixelList drawn(random_image(150, 40, drawn_share, 1, random));
            DrawnMatcher matcher(drawn, disk);
            for (const double share : {0.03, 0.0, 0.0002, 0.007, 0.15, 0.03}) {
                const PixelList truth(random_image(150, 40, share, 1, random));
                EXPECT_EQ(matcher.match(truth), match_pixels(drawn, truth, disk).k)
                    << tolerance_px << " px, " << share;
            }
        }
    }
}

TEST(ReachOf, HoldsThePixelsThatHaveOneInReach) {
    std::mt19937 random(3);
    const Image everywhere(150, 40, 1);
    for (const double tolerance_px : {1.0, 2.0, 3.0}) {
        for (const double share : {0.0, 0.001, 0.02, 0.3}) {
            const PixelList pixels(random_image(150, 40, share, 1, random));
            const Disk disk(tolerance_px);
            const auto reach = reach_of(pixels, disk).bytes();
            const auto expected = within_reach(PixelList(everywhere), pixels, disk);
            ASSERT_TRUE(std::equal(expected.begin(), expected.end(), reach.data()));
        }
    }
}

TEST(DiskOfTolerance, HoldsTheOffsetsWithinIt) {
    // Squared: 1, 2.25, 4, 9, 16.
    EXPECT_EQ(Disk(1).radius_px(), 1);
    EXPECT_EQ(Disk(1).half_width_px(1), 0);
    EXPECT_EQ(Disk(1.5).radius_px(), 1);
    EXPECT_EQ(Disk(1.5).half_width_px(-1), 1);
    EXPECT_EQ(Disk(2).half_width_px(1), 1);
    EXPECT_EQ(Disk(3).half_width_px(2), 2);
    EXPECT_EQ(Disk(4).half_width_px(0), 4);
    EXPECT_EQ(Disk(0.5).radius_px(), 0);
}

TEST(DiskOfTolerance, SnapsASquareThatIsNearlyWhole) {
    const double root = std::sqrt(13.0);
    ASSERT_LT(root * root, 13.0);  // or the test shows nothing
    EXPECT_EQ(Disk(root).half_width_px(2), 3);
    EXPECT_EQ(Disk(root).half_width_px(3), 2);
    EXPECT_EQ(Disk(root - 1e-5).half_width_px(3), 1);
}

TEST(PixelListOfAnImage, DropsPixelsAndKeepsRows) {
    PixelList list(image_of({"1.2", "...", ".12"}));
    ASSERT_EQ(list.size(), 4U);
    list.drop({0, 1, 1, 0});
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(list.row_begin(1), 1U);
    EXPECT_EQ(list.row_begin(2), 1U);
    EXPECT_EQ(list.row_begin(3), 2U);
    EXPECT_EQ(list.x(0), 0);
    EXPECT_EQ(list.x(1), 2);
}

TEST(PixelListOfAnImage, TakesOneLabel) {
    const PixelList twos(image_of({"1.2", "...", ".12"}), 2);
    ASSERT_EQ(twos.size(), 2U);
    EXPECT_EQ(twos.x(0), 2);
    EXPECT_EQ(twos.row_begin(2), 1U);
}

}  // namespace
