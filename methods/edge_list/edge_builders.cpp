// CoRgi's comic renderer: "obtaining the edge-information from a triangle description".

#include "methods/edge_list/edge_builders.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/hash.h"

namespace ink::methods {
namespace {

/// One side of a triangle.
struct FaceSide {
    std::uint32_t a = 0;  ///< a < b
    std::uint32_t b = 0;
    std::uint32_t face = 0;

    [[nodiscard]] bool is_same_edge(const FaceSide& other) const {
        return a == other.a && b == other.b;
    }
};

std::vector<FaceSide> sides_of(std::span<const scene::Triangle> triangles) {
    std::vector<FaceSide> sides;
    sides.reserve(triangles.size() * 3);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
            sides.push_back({a, b, t});
        }
    }
    return sides;
}

ListedEdge boundary(const FaceSide& side) {
    return {side.a, side.b, {side.face, kNoFace}};
}

ListedEdge joined(const FaceSide& first, const FaceSide& second) {
    return {first.a, first.b, {first.face, second.face}};
}

void all_pairs(const std::vector<FaceSide>& sides, EdgeListing& listing) {
    std::vector<bool> has_mate(sides.size(), false);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        std::size_t mate = sides.size();
        for (std::size_t j = i + 1; j < sides.size(); ++j) {
            ++listing.counts.comparisons;
            if (mate == sides.size() && sides[i].is_same_edge(sides[j]) && !has_mate[j]) mate = j;
        }
        if (has_mate[i]) continue;
        if (mate == sides.size()) {
            listing.edges.push_back(boundary(sides[i]));
        } else {
            has_mate[mate] = true;
            listing.edges.push_back(joined(sides[i], sides[mate]));
        }
    }
    listing.counts.longest = sides.size();
}

void temp_list(const std::vector<FaceSide>& sides, EdgeListing& listing) {
    std::vector<FaceSide> waiting;
    for (const FaceSide& side : sides) {
        std::size_t i = waiting.size();
        while (i > 0) {
            ++listing.counts.comparisons;
            if (waiting[i - 1].is_same_edge(side)) break;
            --i;
        }
        if (i > 0) {
            listing.edges.push_back(joined(waiting[i - 1], side));
            waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(i - 1));
        } else {
            waiting.push_back(side);
            listing.counts.longest =
                std::max<std::uint64_t>(listing.counts.longest, waiting.size());
        }
    }
    for (const FaceSide& side : waiting)
        listing.edges.push_back(boundary(side));
}

void hash(const std::vector<FaceSide>& sides, EdgeListing& listing) {
    constexpr std::uint32_t kFree = 0xffffffffU;
    struct Slot {
        std::uint32_t last = kFree;  ///< the latest side of this edge
        bool is_waiting = false;
    };
    std::vector<Slot> slots(std::bit_ceil(std::max<std::size_t>(16, sides.size() * 2)));
    const std::size_t mask = slots.size() - 1;
    std::uint64_t waiting = 0;
    for (std::uint32_t i = 0; i < sides.size(); ++i) {
        const FaceSide& side = sides[i];
        const auto key = static_cast<std::uint64_t>(side.a) << 32 | side.b;
        std::size_t at = core::Hasher().value(key).result() & mask;
        while (slots[at].last != kFree) {
            ++listing.counts.comparisons;
            if (sides[slots[at].last].is_same_edge(side)) break;
            at = (at + 1) & mask;
        }
        if (slots[at].is_waiting) {
            listing.edges.push_back(joined(sides[slots[at].last], side));
            --waiting;
        } else {
            listing.counts.longest = std::max(listing.counts.longest, ++waiting);
        }
        slots[at] = {i, !slots[at].is_waiting};
    }
    for (const Slot& slot : slots) {
        if (slot.is_waiting) listing.edges.push_back(boundary(sides[slot.last]));
    }
}

}  // namespace

EdgeListing list_edges(std::span<const scene::Triangle> triangles, EdgeBuilder builder) {
    const std::vector<FaceSide> sides = sides_of(triangles);
    EdgeListing listing;
    listing.counts.lookups = sides.size();
    constexpr std::array kBuilders = {all_pairs, temp_list, hash};
    kBuilders.at(static_cast<std::size_t>(builder))(sides, listing);
    return listing;
}

}  // namespace ink::methods
