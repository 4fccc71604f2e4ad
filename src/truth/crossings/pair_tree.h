#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "scene/box.h"

namespace ink::truth {

/// A balanced tree of boxes that finds which of them touch each other.
///
/// Boxes are rounded outward to float, ordered along a Morton curve (Lauterbach et al. 2009, "Fast
/// BVH construction on GPUs", section 4) and halved again and again by number, so the tree needs no
/// pointers and both sides of a comparison always stand at the same depth. Numbers that the
/// caller's visitor gets are *places* on the curve; `order()[place]` is the box's own index.
class PairTree {
  public:
    /// Two nodes of equal depth whose boxes touch; the same node twice for the pairs within it.
    struct Task {
        std::uint32_t first = 0;
        std::uint32_t second = 0;
    };

    explicit PairTree(const std::vector<scene::Box>& boxes);

    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

    /// The whole search as independent parts, in an order that only the boxes decide.
    [[nodiscard]] std::vector<Task> tasks() const;

    /// Calls `visit(place, place)` once for each pair of touching boxes in one part, and stops as
    /// soon as it says false. Boxes that only touch in float, not in double, are visited too.
    template <class Visit>
    void for_each(const Task& task, Visit&& visit) const {
        (void)descend(task.first, task.second, visit);
    }

    /// Calls `visit(i)` for the index of each box that touches `box`, in an order that only the
    /// boxes decide; as above, some that do not touch it in double are visited, too.
    template <class Visit>
    void for_each_near(const scene::Box& box, Visit&& visit) const {
        descend_near(1, rounded_outward(box), visit);
    }

  private:
    static constexpr std::uint32_t kLeafSize = 4;
    static constexpr float kFar = std::numeric_limits<float>::infinity();

    struct FloatBox {
        std::array<float, 3> low{kFar, kFar, kFar};
        std::array<float, 3> high{-kFar, -kFar, -kFar};

        [[nodiscard]] bool touches(const FloatBox& o) const {
            // One branch instead of six: which of the tests fails cannot be foreseen.
            return (low[0] <= o.high[0]) & (o.low[0] <= high[0]) & (low[1] <= o.high[1]) &
                   (o.low[1] <= high[1]) & (low[2] <= o.high[2]) & (o.low[2] <= high[2]);
        }
        void add(const FloatBox& o);
    };

    /// The boxes of one leaf, each coordinate side by side: one box is compared with all of them at
    /// once.
    struct Leaf {
        std::array<std::array<float, kLeafSize>, 3> low;
        std::array<std::array<float, kLeafSize>, 3> high;

        using Hits = std::array<std::int32_t, kLeafSize>;
        [[nodiscard]] Hits touching(const FloatBox& o) const {
            Hits hits;
            for (std::size_t j = 0; j < kLeafSize; ++j) {
                hits[j] = (low[0][j] <= o.high[0]) & (o.low[0] <= high[0][j]) &
                          (low[1][j] <= o.high[1]) & (o.low[1] <= high[1][j]) &
                          (low[2][j] <= o.high[2]) & (o.low[2] <= high[2][j]);
            }
            return hits;
        }
        [[nodiscard]] FloatBox box(std::size_t j) const {
            return {{low[0][j], low[1][j], low[2][j]}, {high[0][j], high[1][j], high[2][j]}};
        }
    };

    [[nodiscard]] static FloatBox rounded_outward(const scene::Box& box);
    void expand(std::uint32_t a, std::uint32_t b, std::vector<Task>& tasks) const;

    template <class Visit>
    bool descend(std::uint32_t a, std::uint32_t b, Visit& visit) const {
        if (a >= leaf_count_) return compare_leaves(a - leaf_count_, b - leaf_count_, visit);
        if (a == b) {
            return descend(2 * a, 2 * a, visit) && descend(2 * a + 1, 2 * a + 1, visit) &&
                   enter(2 * a, 2 * a + 1, visit);
        }
        return enter(2 * a, 2 * b, visit) && enter(2 * a, 2 * b + 1, visit) &&
               enter(2 * a + 1, 2 * b, visit) && enter(2 * a + 1, 2 * b + 1, visit);
    }
    template <class Visit>
    bool enter(std::uint32_t a, std::uint32_t b, Visit& visit) const {
        return !nodes_[a].touches(nodes_[b]) || descend(a, b, visit);
    }
    template <class Visit>
    bool compare_leaves(std::uint32_t leaf0, std::uint32_t leaf1, Visit& visit) const {
        const FloatBox& other = nodes_[leaf_count_ + leaf1];
        for (std::uint32_t i = 0; i < kLeafSize; ++i) {
            const FloatBox box = leaves_[leaf0].box(i);
            if (!box.touches(other)) continue;
            const auto hits = leaves_[leaf1].touching(box);
            for (std::uint32_t j = leaf0 == leaf1 ? i + 1 : 0; j < kLeafSize; ++j) {
                if (hits[j] != 0 && !visit(leaf0 * kLeafSize + i, leaf1 * kLeafSize + j)) {
                    return false;
                }
            }
        }
        return true;
    }

    template <class Visit>
    void descend_near(std::uint32_t node, const FloatBox& box, Visit& visit) const {
        if (!nodes_[node].touches(box)) return;
        if (node < leaf_count_) {
            descend_near(2 * node, box, visit);
            descend_near(2 * node + 1, box, visit);
            return;
        }
        const auto hits = leaves_[node - leaf_count_].touching(box);
        for (std::uint32_t j = 0; j < kLeafSize; ++j)
            if (hits[j] != 0) visit(order_[(node - leaf_count_) * kLeafSize + j]);
    }

    std::vector<std::uint32_t> order_;  ///< per place the box's index
    std::vector<Leaf> leaves_;          ///< empty boxes fill the last ones
    std::vector<FloatBox> nodes_;       ///< a heap: the root is 1, node i has children 2i and 2i+1
    std::uint32_t leaf_count_ = 1;      ///< a power of two
};

}  // namespace ink::truth
