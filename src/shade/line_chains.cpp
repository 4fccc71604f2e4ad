#include "shade/line_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace ink::shade {
namespace {

/// Neighbours counter-clockwise from the right; odd ones at corners. i and i ^ 4 are opposite.
constexpr std::array<std::array<int, 2>, 8> kSteps = {
    {{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// The joints of a mask, taken one by one.
class ChainTracer {
  public:
    explicit ChainTracer(const core::Image<std::uint8_t>& mask)
        : mask_(mask),
          degree_(mask.width_px(), mask.height_px()),
          left_(mask.width_px(), mask.height_px()) {
        for (int y = 0; y < mask.height_px(); ++y) {
            for (int x = 0; x < mask.width_px(); ++x) {
                if (mask.at(x, y) == 0) continue;
                const unsigned joints = find_joints(x, y);
                left_.at(x, y) = static_cast<std::uint8_t>(joints);
                for (std::size_t i = 0; i < kSteps.size(); ++i)
                    if (((joints >> i) & 1U) != 0) ++degree_.at(x, y);
            }
        }
    }
    std::vector<LineChain> run() {
        std::vector<LineChain> chains;
        for (const bool wants_rings : {false, true}) {
            for (int y = 0; y < mask_.height_px(); ++y) {
                for (int x = 0; x < mask_.width_px(); ++x) {
                    if (!wants_rings && degree_.at(x, y) == 2) continue;
                    for (std::size_t i = 0; i < kSteps.size(); ++i) {
                        if ((left_.at(x, y) >> i) & 1U) chains.push_back(follow(x, y, i));
                    }
                }
            }
        }
        return chains;
    }

  private:
    [[nodiscard]] bool is_set(int x, int y) const {
        return mask_.contains(x, y) && mask_.at(x, y) != 0;
    }
    [[nodiscard]] unsigned find_joints(int x, int y) const {
        unsigned joints = 0;
        for (std::size_t i = 0; i < kSteps.size(); ++i) {
            const auto [dx, dy] = kSteps[i];
            if (!is_set(x + dx, y + dy)) continue;
            const bool is_corner = i % 2 == 1;
            if (is_corner && (is_set(x + dx, y) || is_set(x, y + dy))) continue;
            joints |= 1U << i;
        }
        return joints;
    }
    LineChain follow(int x, int y, std::size_t step) {
        LineChain chain;
        const int x_first = x;
        const int y_first = y;
        chain.points_px.emplace_back(x + 0.5, y + 0.5);
        while (true) {
            left_.at(x, y) &= static_cast<std::uint8_t>(~(1U << step));
            x += kSteps[step][0];
            y += kSteps[step][1];
            left_.at(x, y) &= static_cast<std::uint8_t>(~(1U << (step ^ 4U)));
            if (x == x_first && y == y_first) {
                chain.is_closed = true;
                return chain;
            }
            chain.points_px.emplace_back(x + 0.5, y + 0.5);
            if (degree_.at(x, y) != 2) return chain;
            step = 0;
            while (((left_.at(x, y) >> step) & 1U) == 0)
                ++step;
        }
    }

    const core::Image<std::uint8_t>& mask_;
    core::Image<std::uint8_t> degree_;
    core::Image<std::uint8_t> left_;  ///< joints not yet taken, one bit a step
};

/// Cosine of the turn at a point; 1 (straight) near the ends of an open chain.
double turn_cosine(const LineChain& chain, std::size_t i, std::size_t reach) {
    const auto& p = chain.points_px;
    const std::size_t n = p.size();
    if (!chain.is_closed && (i < reach || i + reach >= n)) return 1;
    const glm::dvec2 before = p[i] - p[(i + n - reach) % n];
    const glm::dvec2 after = p[(i + reach) % n] - p[i];
    const double product = glm::length(before) * glm::length(after);
    return product > 0 ? glm::dot(before, after) / product : 1;
}

/// The sharpest point of every run of points that turn too much, in the order of points.
std::vector<std::size_t> find_corners(const LineChain& chain,
                                      double most_cosine,
                                      std::size_t reach) {
    const std::size_t n = chain.points_px.size();
    // From a point that is straight, so that no run of a ring is met twice.
    std::size_t start = 0;
    while (start + 1 < n && turn_cosine(chain, start, reach) < most_cosine)
        ++start;
    std::vector<std::size_t> corners;
    double sharpest = most_cosine;  // of the run; most_cosine outside runs
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = (start + k) % n;
        const double cosine = turn_cosine(chain, i, reach);
        if (cosine >= most_cosine) {
            sharpest = most_cosine;
        } else if (sharpest == most_cosine) {
            corners.push_back(i);
            sharpest = cosine;
        } else if (cosine < sharpest) {
            corners.back() = i;
            sharpest = cosine;
        }
    }
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// The ring as an open chain that starts and ends at point `start`.
LineChain open_ring(const LineChain& ring, std::size_t start) {
    LineChain chain = ring;
    chain.is_closed = false;
    auto& p = chain.points_px;
    std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(start), p.end());
    p.push_back(p.front());
    return chain;
}

void add_pieces(const LineChain& chain,
                const std::vector<std::size_t>& corners,
                std::vector<LineChain>& pieces) {
    auto from = chain.points_px.begin();
    for (const std::size_t corner : corners) {
        const auto at = chain.points_px.begin() + static_cast<std::ptrdiff_t>(corner);
        if (at - from >= 1) pieces.push_back({{from, at + 1}, false});
        from = at;
    }
    if (chain.points_px.end() - from >= 2) pieces.push_back({{from, chain.points_px.end()}, false});
}

}  // namespace

std::vector<LineChain> trace_chains(const core::Image<std::uint8_t>& thinned) {
    return ChainTracer(thinned).run();
}

std::vector<LineChain> cut_at_corners(const std::vector<LineChain>& chains,
                                      double corner_rad,
                                      int reach_px) {
    std::vector<LineChain> pieces;
    // Rasters turn by exactly 45 degrees and the like: a tie must not depend on the last bit of
    // cos.
    const double most_cosine = std::cos(corner_rad) - 1e-9;
    const auto reach = static_cast<std::size_t>(reach_px);
    for (const LineChain& chain : chains) {
        const bool is_short = chain.points_px.size() <= 2 * reach;
        auto corners =
            is_short ? std::vector<std::size_t>{} : find_corners(chain, most_cosine, reach);
        if (corners.empty()) {
            pieces.push_back(chain);
        } else if (chain.is_closed) {
            const std::size_t start = corners.front();
            for (std::size_t& corner : corners)
                corner -= start;
            add_pieces(open_ring(chain, start), corners, pieces);
        } else {
            add_pieces(chain, corners, pieces);
        }
    }
    return pieces;
}

void smooth(LineChain& chain, double sigma_px) {
    auto& p = chain.points_px;
    const std::size_t n = p.size();
    if (n < 3) return;
    // A step of (1 2 1)/4 has the variance 1/2.
    const auto steps = static_cast<int>(std::lround(2 * sigma_px * sigma_px));
    std::vector<glm::dvec2> next = p;
    for (int step = 0; step < steps; ++step) {
        const std::size_t first = chain.is_closed ? 0 : 1;
        const std::size_t last = chain.is_closed ? n : n - 1;
        for (std::size_t i = first; i < last; ++i)
            next[i] =
                0.25 * p[i == 0 ? n - 1 : i - 1] + 0.5 * p[i] + 0.25 * p[i + 1 == n ? 0 : i + 1];
        p.swap(next);
        if (!chain.is_closed) {
            p.front() = next.front();
            p.back() = next.back();
        }
    }
}

}  // namespace ink::shade
