#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>
#include <vector>

namespace ink::truth {

/// An axis-aligned box; the default one is empty.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void add(const Box& box) {
        low = glm::min(low, box.low);
        high = glm::max(high, box.high);
    }
    [[nodiscard]] bool touches(const Box& o) const {
        return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y &&
               low.z <= o.high.z && o.low.z <= high.z;
    }
};

/// A binary tree of boxes, halved at the median of the longest axis: finds what touches a box.
///
/// Small and plain, for the few things that must be found in double and by position rather than
/// along a ray. Boxes keep the numbers they were given in.
class BoxTree {
  public:
    explicit BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
        std::iota(order_.begin(), order_.end(), 0U);
        if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
    }

    /// Calls `visit(i)` for each box that touches `query`, in an order that only the boxes decide.
    template <class Visit>
    void for_each(const Box& query, Visit&& visit) const {
        if (!nodes_.empty()) descend(0, query, visit);
    }

  private:
    static constexpr std::uint32_t kLeafSize = 4;
    struct Node {
        Box box;
        std::uint32_t begin = 0;  ///< into order_
        std::uint32_t end = 0;
        std::uint32_t right = 0;  ///< the left child follows its parent; 0 in leaves
    };

    std::uint32_t build(std::uint32_t begin, std::uint32_t end) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({});
        Box box;
        for (std::uint32_t i = begin; i < end; ++i)
            box.add(boxes_[order_[i]]);
        std::uint32_t right = 0;
        if (end - begin > kLeafSize) {
            const std::uint32_t middle = split(box, begin, end);
            build(begin, middle);
            right = build(middle, end);
        }
        nodes_[index] = {box, begin, end, right};
        return index;
    }

    std::uint32_t split(const Box& box, std::uint32_t begin, std::uint32_t end) {
        const glm::dvec3 size = box.high - box.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t middle = begin + (end - begin) / 2;
        const auto key = [&](std::uint32_t i) {
            return boxes_[i].low[axis] + boxes_[i].high[axis];
        };
        std::nth_element(order_.begin() + begin,
                         order_.begin() + middle,
                         order_.begin() + end,
                         [&](std::uint32_t i, std::uint32_t j) {
                             return key(i) != key(j) ? key(i) < key(j) : i < j;
                         });
        return middle;
    }

    template <class Visit>
    void descend(std::uint32_t index, const Box& query, Visit& visit) const {
        const Node& node = nodes_[index];
        if (!node.box.touches(query)) return;
        if (node.right != 0) {
            descend(index + 1, query, visit);
            descend(node.right, query, visit);
            return;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            if (boxes_[order_[i]].touches(query)) visit(order_[i]);
        }
    }

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace ink::truth
