#include "bake/flat_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/error.h"

namespace ink::bake {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

/// A vertex and a code that triangles at it have: a need, which is met by a vertex in the result,
/// or dropped where each of these triangles has its code from its other two corners.
struct Need {
    std::uint32_t vertex = 0;
    std::uint32_t first_corner = 0;  ///< into Needs::corners
    std::uint32_t last_corner = 0;   ///< one beyond
    std::uint32_t blocked_by = 0;    ///< how often another need in its triangles may be dropped
    bool may_drop = true;
    bool is_dropped = false;
};

struct Needs {
    std::vector<Need> list;              ///< by vertex, then code
    std::vector<std::uint32_t> corners;  ///< 3 * triangle + i, by need
    std::vector<std::uint32_t> of_corner;
    std::vector<std::uint32_t> open_at;  ///< per vertex: its needs that are not dropped
};

Needs list_needs(std::span<const std::uint32_t> indices,
                 std::size_t vertex_count,
                 std::span<const std::uint64_t> codes) {
    std::vector<std::uint32_t> first(vertex_count + 1, 0);
    for (const std::uint32_t vertex : indices)
        ++first[vertex + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());

    Needs needs;
    needs.corners.resize(indices.size());
    needs.of_corner.resize(indices.size());
    needs.open_at.resize(vertex_count, 0);
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t corner = 0; corner < indices.size(); ++corner)
        needs.corners[next[indices[corner]]++] = corner;
    for (std::uint32_t vertex = 0; vertex < vertex_count; ++vertex) {
        std::sort(needs.corners.begin() + first[vertex],
                  needs.corners.begin() + first[vertex + 1],
                  [&](std::uint32_t a, std::uint32_t b) {
                      return std::pair(codes[a / 3], a) < std::pair(codes[b / 3], b);
                  });
        for (std::uint32_t i = first[vertex]; i < first[vertex + 1]; ++i) {
            const std::uint32_t corner = needs.corners[i];
            if (i == first[vertex] || codes[needs.corners[i - 1] / 3] != codes[corner / 3]) {
                needs.list.push_back({.vertex = vertex, .first_corner = i});
                ++needs.open_at[vertex];
            }
            needs.list.back().last_corner = i + 1;
            needs.of_corner[corner] = static_cast<std::uint32_t>(needs.list.size() - 1);
        }
    }
    return needs;
}

/// Drops needs, the least blocked first: the greedy choice of an independent set, in which two
/// needs are neighbours if they are two corners of one triangle.
class Dropping {
  public:
    explicit Dropping(Needs& needs) : needs_(needs) {
        for (std::uint32_t i = 0; i < needs_.list.size(); ++i) {
            // The last need of a vertex costs nothing: the vertex is there. A triangle that has a
            // vertex twice would lose two of its corners.
            if (needs_.open_at[needs_.list[i].vertex] < 2 || has_corner_twice(i))
                needs_.list[i].may_drop = false;
        }
        for (std::uint32_t i = 0; i < needs_.list.size(); ++i) {
            if (!needs_.list[i].may_drop) continue;
            for_each_beside(
                i, [&](std::uint32_t other) { needs_.list[i].blocked_by += may_drop(other); });
            put(i);
        }
    }

    void run() {
        for (std::size_t level = 0; level < by_level_.size();) {
            // First in, first out: needs that are equal fall in the order of the mesh.
            if (taken_[level] == by_level_[level].size()) {
                ++level;
                continue;
            }
            const std::uint32_t need = by_level_[level][taken_[level]++];
            if (!may_drop(need) || needs_.list[need].blocked_by != level) continue;
            drop(need);
            level = std::min(level, lowest_put_);
            lowest_put_ = by_level_.size();
        }
    }

  private:
    [[nodiscard]] bool may_drop(std::uint32_t need) const { return needs_.list[need].may_drop; }

    [[nodiscard]] bool has_corner_twice(std::uint32_t need) const {
        bool is_twice = false;
        for_each_beside(need, [&](std::uint32_t other) { is_twice |= other == need; });
        return is_twice;
    }

    template <class Visit>
    void for_each_beside(std::uint32_t need, Visit visit) const {
        for (std::uint32_t i = needs_.list[need].first_corner; i < needs_.list[need].last_corner;
             ++i) {
            const std::uint32_t corner = needs_.corners[i];
            const std::uint32_t triangle = corner / 3;
            visit(needs_.of_corner[3 * triangle + (corner + 1) % 3]);
            visit(needs_.of_corner[3 * triangle + (corner + 2) % 3]);
        }
    }

    void put(std::uint32_t need) {
        const std::size_t level = needs_.list[need].blocked_by;
        if (level >= by_level_.size()) {
            by_level_.resize(level + 1);
            taken_.resize(level + 1, 0);
        }
        by_level_[level].push_back(need);
        lowest_put_ = std::min(lowest_put_, level);
    }

    void keep(std::uint32_t need) {
        if (!may_drop(need)) return;
        needs_.list[need].may_drop = false;
        for_each_beside(need, [&](std::uint32_t other) {
            if (!may_drop(other)) return;
            --needs_.list[other].blocked_by;
            put(other);
        });
    }

    void drop(std::uint32_t need) {
        needs_.list[need].may_drop = false;
        needs_.list[need].is_dropped = true;
        const std::uint32_t vertex = needs_.list[need].vertex;
        for_each_beside(need, [&](std::uint32_t other) { keep(other); });
        if (--needs_.open_at[vertex] > 1) return;
        // Needs of one vertex are side by side in the list.
        std::uint32_t i = need;
        while (i > 0 && needs_.list[i - 1].vertex == vertex)
            --i;
        for (; i < needs_.list.size() && needs_.list[i].vertex == vertex; ++i)
            if (!needs_.list[i].is_dropped) keep(i);
    }

    Needs& needs_;
    std::vector<std::vector<std::uint32_t>> by_level_;
    std::vector<std::size_t> taken_;  ///< per level, from its front
    std::size_t lowest_put_ = 0;
};

void check(std::span<const std::uint32_t> indices,
           std::size_t vertex_count,
           std::span<const std::uint64_t> codes) {
    const auto outside = std::ranges::find_if(indices, [&](auto i) { return i >= vertex_count; });
    if (outside != indices.end())
        throw core::Error("triangles",
                          fmt::format("vertex {}", *outside),
                          fmt::format("less than {}", vertex_count));
    if (vertex_count + indices.size() >= kNone)
        throw core::Error("triangles",
                          fmt::format("{} vertices and {} corners", vertex_count, indices.size()),
                          fmt::format("less than {} together", kNone));
    if (indices.size() != 3 * codes.size())
        throw core::Error("triangles",
                          fmt::format("{} corners", indices.size()),
                          fmt::format("{}, 3 for each code", 3 * codes.size()));
}

}  // namespace

FlatCodes flat_codes(std::span<const std::uint32_t> indices,
                     std::size_t vertex_count,
                     std::span<const std::uint64_t> codes) {
    check(indices, vertex_count, codes);
    Needs needs = list_needs(indices, vertex_count, codes);
    Dropping(needs).run();

    FlatCodes flat{.indices = std::vector(indices.begin(), indices.end()),
                   .source_vertex = std::vector<std::uint32_t>(vertex_count),
                   .codes = std::vector<std::uint64_t>(vertex_count, 0)};
    std::iota(flat.source_vertex.begin(), flat.source_vertex.end(), 0U);
    std::vector<std::uint32_t> vertex_of(needs.list.size(), kNone);
    std::vector<std::uint8_t> is_taken(vertex_count, 0);
    for (std::size_t i = 0; i < needs.list.size(); ++i) {
        const Need& need = needs.list[i];
        if (need.is_dropped) continue;
        vertex_of[i] = need.vertex;
        const std::uint64_t code = codes[needs.corners[need.first_corner] / 3];
        if (is_taken[need.vertex] == 0) {
            is_taken[need.vertex] = 1;
            flat.codes[need.vertex] = code;
            continue;
        }
        vertex_of[i] = static_cast<std::uint32_t>(flat.source_vertex.size());
        flat.source_vertex.push_back(need.vertex);
        flat.codes.push_back(code);
    }
    for (std::size_t triangle = 0; triangle < codes.size(); ++triangle) {
        const auto corners = flat.indices.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
        int without = 1;  // the corner that comes to lie in the middle: as it is, if all have one
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t vertex = vertex_of[needs.of_corner[3 * triangle + i]];
            if (vertex == kNone)
                without = i;
            else
                corners[i] = vertex;
        }
        std::rotate(corners, corners + (without + 2) % 3, corners + 3);
    }
    return flat;
}

}  // namespace ink::bake
