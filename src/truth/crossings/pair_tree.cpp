#include "truth/crossings/pair_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ink::truth {
namespace {

constexpr int kBitsPerAxis = 21;
constexpr int kDigitBits = 11;
constexpr std::uint32_t kTaskNodes = 1024;  ///< depth at which the search is cut into tasks

/// Puts two zero bits between the lowest 21 bits.
std::uint64_t spread(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffffULL;
    x = (x | x << 16) & 0x1f0000ff0000ffULL;
    x = (x | x << 8) & 0x100f00f00f00f00fULL;
    x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
    return (x | x << 2) & 0x1249249249249249ULL;
}

struct Keyed {
    std::uint64_t key = 0;
    std::uint32_t index = 0;
};

/// Sorts by key, equal keys in their old order: one counting pass a digit, lowest digit first.
void sort_by_key(std::vector<Keyed>& items) {
    std::vector<Keyed> other(items.size());
    for (int shift = 0; shift < 3 * kBitsPerAxis; shift += kDigitBits) {
        std::array<std::uint32_t, (1U << kDigitBits) + 1> first{};
        const auto digit = [&](const Keyed& k) {
            return static_cast<std::size_t>(k.key >> shift) & ((1U << kDigitBits) - 1);
        };
        for (const Keyed& k : items)
            ++first[digit(k) + 1];
        for (std::size_t d = 1; d < first.size(); ++d)
            first[d] += first[d - 1];
        for (const Keyed& k : items)
            other[first[digit(k)]++] = k;
        items.swap(other);
    }
}

std::vector<std::uint32_t> along_the_curve(const std::vector<scene::Box>& boxes) {
    scene::Box all;
    for (const scene::Box& box : boxes)
        all.add(0.5 * (box.low + box.high));
    const glm::dvec3 size = all.high - all.low;
    glm::dvec3 scale{0};
    for (int axis = 0; axis < 3; ++axis)
        if (size[axis] > 0) scale[axis] = ((1 << kBitsPerAxis) - 1) / size[axis];
    std::vector<Keyed> keyed(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const glm::dvec3 cell = (0.5 * (boxes[i].low + boxes[i].high) - all.low) * scale;
        keyed[i] = {spread(static_cast<std::uint64_t>(cell.x)) |
                        spread(static_cast<std::uint64_t>(cell.y)) << 1 |
                        spread(static_cast<std::uint64_t>(cell.z)) << 2,
                    i};
    }
    sort_by_key(keyed);
    std::vector<std::uint32_t> order(boxes.size());
    std::ranges::transform(keyed, order.begin(), [](const Keyed& k) { return k.index; });
    return order;
}

float rounded_down(double x) {
    // A whole ulp below the nearest float, or a little more; nextafter is a call.
    const auto f = static_cast<float>(x);
    return f - std::abs(f) * std::numeric_limits<float>::epsilon() -
           std::numeric_limits<float>::denorm_min();
}

}  // namespace

void PairTree::FloatBox::add(const FloatBox& o) {
    for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], o.low[i]);
        high[i] = std::max(high[i], o.high[i]);
    }
}

PairTree::FloatBox PairTree::rounded_outward(const scene::Box& box) {
    FloatBox result;
    for (int i = 0; i < 3; ++i) {
        result.low[static_cast<std::size_t>(i)] = rounded_down(box.low[i]);
        result.high[static_cast<std::size_t>(i)] = -rounded_down(-box.high[i]);
    }
    return result;
}

PairTree::PairTree(const std::vector<scene::Box>& boxes) : order_(along_the_curve(boxes)) {
    const auto leaves = static_cast<std::uint32_t>((boxes.size() + kLeafSize - 1) / kLeafSize);
    leaf_count_ = std::bit_ceil(std::max(1U, leaves));
    leaves_.resize(leaf_count_);
    nodes_.resize(2 * static_cast<std::size_t>(leaf_count_));
    for (std::size_t place = 0; place < std::size_t{leaf_count_} * kLeafSize; ++place) {
        const bool is_there = place < order_.size();
        const FloatBox box = is_there ? rounded_outward(boxes[order_[place]]) : FloatBox();
        Leaf& leaf = leaves_[place / kLeafSize];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            leaf.low[axis][place % kLeafSize] = box.low[axis];
            leaf.high[axis][place % kLeafSize] = box.high[axis];
        }
        nodes_[leaf_count_ + place / kLeafSize].add(box);
    }
    for (std::uint32_t node = leaf_count_ - 1; node > 0; --node) {
        nodes_[node] = nodes_[2 * node];
        nodes_[node].add(nodes_[2 * node + 1]);
    }
}

void PairTree::expand(std::uint32_t a, std::uint32_t b, std::vector<Task>& tasks) const {
    if (a != b && !nodes_[a].touches(nodes_[b])) return;
    if (a >= leaf_count_ || a >= kTaskNodes) {
        tasks.push_back({a, b});
        return;
    }
    expand(2 * a, 2 * b, tasks);
    expand(2 * a, 2 * b + 1, tasks);
    if (a != b) expand(2 * a + 1, 2 * b, tasks);
    expand(2 * a + 1, 2 * b + 1, tasks);
}

std::vector<PairTree::Task> PairTree::tasks() const {
    std::vector<Task> tasks;
    expand(1, 1, tasks);
    return tasks;
}

}  // namespace ink::truth
