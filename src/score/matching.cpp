#include "score/matching.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "score/bit_matcher.h"

namespace ink::score {
namespace {

constexpr std::uint32_t kNobody = 0xffffffffU;
constexpr std::size_t kMaxPairs = 250'000'000;

/// A matching under construction.
class Matcher {
  public:
    explicit Matcher(const CandidateGraph& graph);
    void start();
    void augment();
    [[nodiscard]] std::int64_t size() const { return size_; }

  private:
    [[nodiscard]] bool is_free(std::uint32_t v) const { return mate_[v] == kNobody; }
    [[nodiscard]] std::uint32_t scarcest_neighbour(std::uint32_t v) const;
    void join(std::uint32_t a, std::uint32_t b);
    void leave(std::uint32_t v);
    void match_singles();
    [[nodiscard]] std::uint32_t search(std::uint32_t root);
    void flip(std::uint32_t right);

    const CandidateGraph& graph_;
    std::vector<std::uint32_t> mate_;
    std::int64_t size_ = 0;

    // The start: how many free neighbours a free vertex has, and who has just one.
    std::vector<std::uint32_t> free_degree_;
    std::vector<std::uint32_t> singles_;

    // The searches: right vertices already reached, and from whom.
    std::vector<std::uint8_t> is_closed_;
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint32_t> queue_;
    std::vector<std::uint32_t> reached_;
};

Matcher::Matcher(const CandidateGraph& graph)
    : graph_(graph), mate_(graph.n_left + graph.n_right, kNobody), free_degree_(mate_.size()) {
    for (std::uint32_t v = 0; v < mate_.size(); ++v) {
        free_degree_[v] = graph.degree(v);
        if (free_degree_[v] == 1) singles_.push_back(v);
    }
}

/// The free neighbour that has the fewest free neighbours itself, or nobody.
std::uint32_t Matcher::scarcest_neighbour(std::uint32_t v) const {
    std::uint32_t best = kNobody;
    for (std::uint32_t e = graph_.begin[v]; e < graph_.begin[v + 1]; ++e) {
        const std::uint32_t u = graph_.neighbours[e];
        if (is_free(u) && (best == kNobody || free_degree_[u] < free_degree_[best])) best = u;
    }
    return best;
}

/// The neighbours of a vertex that was matched have one free neighbour less.
void Matcher::leave(std::uint32_t v) {
    for (std::uint32_t e = graph_.begin[v]; e < graph_.begin[v + 1]; ++e) {
        const std::uint32_t u = graph_.neighbours[e];
        if (--free_degree_[u] == 1 && is_free(u)) singles_.push_back(u);
    }
}

void Matcher::join(std::uint32_t a, std::uint32_t b) {
    mate_[a] = b;
    mate_[b] = a;
    ++size_;
    leave(a);
    leave(b);
}

void Matcher::match_singles() {
    while (!singles_.empty()) {
        const std::uint32_t v = singles_.back();
        singles_.pop_back();
        if (!is_free(v)) continue;
        const std::uint32_t u = scarcest_neighbour(v);
        if (u != kNobody) join(v, u);
    }
}

void Matcher::start() {
    match_singles();
    for (std::uint32_t v = 0; v < graph_.n_left; ++v) {
        if (!is_free(v) || free_degree_[v] == 0) continue;
        join(v, scarcest_neighbour(v));
        match_singles();
    }
}

/// Breadth first from a free left vertex to a free right one along alternating edges.
///
/// Right vertices of a search that failed stay closed for good: no later augmenting path leads
/// through them. Those of a search that succeeded are opened again. Returns the end, or nobody.
std::uint32_t Matcher::search(std::uint32_t root) {
    queue_.assign(1, root);
    reached_.clear();
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        const std::uint32_t v = queue_[head];
        for (std::uint32_t e = graph_.begin[v]; e < graph_.begin[v + 1]; ++e) {
            const std::uint32_t right = graph_.neighbours[e];
            const std::size_t r = right - graph_.n_left;
            if (is_closed_[r] != 0) continue;
            is_closed_[r] = 1;
            reached_.push_back(right);
            parent_[r] = v;
            if (is_free(right)) return right;
            queue_.push_back(mate_[right]);
        }
    }
    return kNobody;
}

/// Swaps matched and unmatched edges on the path that ends at `right`.
void Matcher::flip(std::uint32_t right) {
    while (right != kNobody) {
        const std::uint32_t left = parent_[right - graph_.n_left];
        const std::uint32_t next = mate_[left];  // nobody at the root
        mate_[left] = right;
        mate_[right] = left;
        right = next;
    }
}

void Matcher::augment() {
    is_closed_.assign(graph_.n_right, 0);
    parent_.assign(graph_.n_right, kNobody);
    for (std::uint32_t v = 0; v < graph_.n_left; ++v) {
        if (!is_free(v)) continue;
        const std::uint32_t end = search(v);
        if (end == kNobody) continue;
        for (const std::uint32_t right : reached_)
            is_closed_[right - graph_.n_left] = 0;
        flip(end);
        ++size_;
    }
}

/// Counts before anything is stored, so that too many are a message and not a machine out of
/// memory.
void check_pairs(const PixelList& left, const PixelList& right, const Disk& disk) {
    const auto reach = static_cast<std::size_t>(2 * disk.radius_px() + 1);
    if (left.size() * reach * reach <= kMaxPairs) return;
    std::size_t pairs = 0;
    visit_reach(left, right, disk, [&](std::size_t, std::size_t first, std::size_t last) {
        pairs += last - first;
        if (pairs > kMaxPairs) {
            throw core::Error("score",
                              "more than 250 million pairs of pixels lie within the tolerance",
                              "a smaller tolerance or thinner lines");
        }
    });
}

/// Appends the right side's lists: the left side's, turned round.
void append_transposed(CandidateGraph& graph) {
    const std::size_t n_pairs = graph.neighbours.size();
    const std::size_t n_all = graph.n_left + graph.n_right;
    graph.begin.resize(n_all + 1, 0);
    for (std::size_t e = 0; e < n_pairs; ++e)
        ++graph.begin[graph.neighbours[e] + 1];
    for (std::size_t v = graph.n_left; v < n_all; ++v)
        graph.begin[v + 1] += graph.begin[v];
    graph.neighbours.resize(2 * n_pairs);
    std::vector<std::uint32_t> next(graph.begin.begin() + static_cast<std::ptrdiff_t>(graph.n_left),
                                    graph.begin.end() - 1);
    for (std::uint32_t v = 0; v < graph.n_left; ++v) {
        for (std::uint32_t e = graph.begin[v]; e < graph.begin[v + 1]; ++e) {
            graph.neighbours[next[graph.neighbours[e] - graph.n_left]++] = v;
        }
    }
}

}  // namespace

CandidateGraph candidate_graph(const PixelList& left, const PixelList& right, const Disk& disk) {
    check_pairs(left, right, disk);
    CandidateGraph graph;
    graph.n_left = left.size();
    graph.n_right = right.size();
    graph.begin.assign(graph.n_left + 1, 0);
    graph.neighbours.reserve(16 * graph.n_left);
    visit_reach(left, right, disk, [&](std::size_t i, std::size_t first, std::size_t last) {
        for (std::size_t j = first; j < last; ++j) {
            graph.neighbours.push_back(static_cast<std::uint32_t>(graph.n_left + j));
        }
        graph.begin[i + 1] = static_cast<std::uint32_t>(graph.neighbours.size());
    });
    // Pixels out of reach were not visited: their lists are empty.
    for (std::size_t i = 0; i < graph.n_left; ++i) {
        graph.begin[i + 1] = std::max(graph.begin[i], graph.begin[i + 1]);
    }
    append_transposed(graph);
    return graph;
}

std::int64_t maximum_matching(const CandidateGraph& graph) {
    Matcher matcher(graph);
    matcher.start();
    matcher.augment();
    return matcher.size();
}

std::int64_t count_pairs(const PixelList& left, const PixelList& right, const Disk& disk) {
    if (BitMatcher::takes(disk)) return count_pairs_in_bits(left, right, disk);
    return match_pixels(left, right, disk).k;
}

MatchCounts match_pixels(const PixelList& left, const PixelList& right, const Disk& disk) {
    if (BitMatcher::takes(disk)) return match_bits(left, right, disk);
    if (left.size() > right.size()) {
        MatchCounts counts = match_pixels(right, left, disk);
        std::swap(counts.left_reached, counts.right_reached);
        return counts;
    }
    const CandidateGraph graph = candidate_graph(left, right, disk);
    MatchCounts counts{.k = maximum_matching(graph)};
    for (std::size_t v = 0; v < graph.n_left; ++v)
        counts.left_reached += graph.degree(v) > 0;
    for (std::size_t v = graph.n_left; v < graph.n_left + graph.n_right; ++v) {
        counts.right_reached += graph.degree(v) > 0;
    }
    return counts;
}

}  // namespace ink::score
