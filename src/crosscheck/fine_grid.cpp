#include "crosscheck/fine_grid.h"

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
            sample.sight = rays_.look(sample.p_px);
        }
    }
    counts.rays += samples_.size();
}

void FineGrid::add_points(std::vector<CellPoint>& points) {
    for (int y = 0; y < k_; ++y) {
        for (int x = 0; x < k_; ++x) {
            add_between(at(x, y), at(x + 1, y), points);
            add_between(at(x, y), at(x, y + 1), points);
        }
    }
}

bool FineGrid::is_crossed(glm::ivec2 begin, glm::ivec2 step) {
    for (int i = 0; i < k_; ++i) {
        const glm::ivec2 a = begin + step * i, b = a + step;
        if (!is_plain(at(a.x, a.y), at(b.x, b.y))) return true;
    }
    return false;
}

bool FineGrid::is_plain(const Sample& a, const Sample& b) {
    if (known_ != nullptr) return known_->explain(a, b, counts.rays);
    return is_joined(rays_.mesh(), a, b);
}

void FineGrid::add_between(const Sample& a, const Sample& b, std::vector<CellPoint>& points) {
    if (is_plain(a, b)) return;
    found_.clear();
    Crossings found{found_, counts};
    add_crossings(rays_, a, b, cell_, 1.0 / k_, found);
    for (const CellPoint& p : found_) {
        const bool is_known =
            known_ != nullptr &&
            known_->has_near({p.point.x_px, p.point.y_px}, p.point.line_class, kSame_px);
        if (!is_known) points.push_back(p);
    }
}

}  // namespace ink::crosscheck
