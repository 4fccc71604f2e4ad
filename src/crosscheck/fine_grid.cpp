#include "crosscheck/fine_grid.h"

#include <algorithm>

#include "crosscheck/explanation.h"

namespace ink::crosscheck {
namespace {

constexpr double kSame_px = 0.125;  ///< a point this near a known one is of the same line

}  // namespace

FineGrid::FineGrid(const SightRays& rays, const KnownLines* known, int k)
    : rays_(rays), known_(known), k_(k), samples_((k + 1) * (k + 1)) {}

void FineGrid::look(const glm::ivec2& cell, const glm::dvec2& corner_px) {
    cell_ = cell;
    ++counts.refined_px;
    for (int y = 0; y <= k_; ++y) {
        for (int x = 0; x <= k_; ++x) {
            Sample& sample = at(x, y);
            sample.p_px = corner_px + glm::dvec2(x, y) / static_cast<double>(k_);
        }
    }
    look_at_all(rays_, samples_);
    counts.rays += samples_.size();
}

void FineGrid::add_points(std::vector<CellPoint>& points) {
    std::vector<Way> ways;
    for (int y = 0; y < k_; ++y) {
        for (int x = 0; x < k_; ++x) {
            ways.push_back({at(x, y), at(x + 1, y)});
            ways.push_back({at(x, y), at(x, y + 1)});
        }
    }
    const std::vector<char> is_plain = judge(ways);
    std::vector<CellWay> open;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        if (is_plain[i] == 0) open.push_back({ways[i], cell_});
    }
    std::vector<CellPoint> all;
    Crossings found{all, counts};
    add_crossings(rays_, open, 1.0 / k_, found);
    for (const CellPoint& p : all) {
        const bool is_known =
            known_ != nullptr &&
            known_->has_near({p.point.x_px, p.point.y_px}, p.point.line_class, kSame_px);
        if (!is_known) points.push_back(p);
    }
}

bool FineGrid::is_crossed(glm::ivec2 begin, glm::ivec2 step) {
    std::vector<Way> ways;
    for (int i = 0; i < k_; ++i) {
        const glm::ivec2 a = begin + step * i, b = a + step;
        ways.push_back({at(a.x, a.y), at(b.x, b.y)});
    }
    const std::vector<char> is_plain = judge(ways);
    return std::find(is_plain.begin(), is_plain.end(), 0) != is_plain.end();
}

std::vector<char> FineGrid::judge(std::span<const Way> ways) {
    if (known_ != nullptr)
        return explain_all(*known_, rays_, ways, Explanation::Reach::whole, counts.rays);
    std::vector<char> is_plain(ways.size());
    std::transform(ways.begin(), ways.end(), is_plain.begin(), [&](const Way& way) {
        return is_joined(rays_.mesh(), way.from, way.to);
    });
    return is_plain;
}

}  // namespace ink::crosscheck
