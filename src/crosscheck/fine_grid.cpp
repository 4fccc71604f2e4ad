#include "crosscheck/fine_grid.h"

#include <glm/geometric.hpp>

namespace ink::crosscheck {
namespace {

constexpr double kFinest_px = 1.0 / 512;

}  // namespace

FineGrid::FineGrid(const SightRays& rays, int k)
    : rays_(rays), mesh_(rays.mesh()), k_(k), samples_((k + 1) * (k + 1)) {}

void FineGrid::look(const glm::ivec2& cell,
                    const glm::dvec2& corner_px,
                    const std::array<Sight, 4>& corners) {
    cell_ = cell;
    ++counts.refined_px;
    for (int y = 0; y <= k_; ++y) {
        for (int x = 0; x <= k_; ++x) {
            Sample& sample = at(x, y);
            sample.p_px = corner_px + glm::dvec2(x, y) / static_cast<double>(k_);
            const bool is_corner = x % k_ == 0 && y % k_ == 0;
            sample.sight = is_corner ? corners[(y / k_) * 2 + x / k_] : look_at(sample.p_px);
        }
    }
}

void FineGrid::add_points(std::vector<CellPoint>& points) {
    for (int y = 0; y < k_; ++y) {
        for (int x = 0; x < k_; ++x) {
            add_between(at(x, y), at(x + 1, y), points);
            add_between(at(x, y), at(x, y + 1), points);
        }
    }
}

bool FineGrid::is_crossed(glm::ivec2 begin, glm::ivec2 step) const {
    for (int i = 0; i < k_; ++i) {
        const glm::ivec2 a = begin + step * i, b = a + step;
        if (!is_joined(mesh_, at(a.x, a.y), at(b.x, b.y))) return true;
    }
    return false;
}

Sight FineGrid::look_at(const glm::dvec2& p_px) {
    ++counts.rays;
    return rays_.look(p_px);
}

void FineGrid::add_between(const Sample& a, const Sample& b, std::vector<CellPoint>& points) {
    if (is_joined(mesh_, a, b)) return;
    if (glm::length(b.p_px - a.p_px) <= kFinest_px) {
        add_leaf(a, b, points);
        return;
    }
    Sample middle;
    middle.p_px = 0.5 * (a.p_px + b.p_px);
    middle.sight = look_at(middle.p_px);
    add_between(a, middle, points);
    add_between(middle, b, points);
}

void FineGrid::add_leaf(const Sample& a, const Sample& b, std::vector<CellPoint>& points) {
    const Between between = name_between(rays_, a, b);
    counts.defects += between.is_defect;
    counts.near_cuts += between.is_near_cut;
    counts.unexplained += !between.is_explained;
    const glm::dvec2 p = 0.5 * (a.p_px + b.p_px);
    const scene::View& view = mesh_.view();
    if (p.x < 0 || p.y < 0 || p.x >= view.width_px || p.y >= view.height_px) return;
    for (int i = 0; i < between.count; ++i) {
        const NamedLine& line = between.lines[i];
        points.push_back({cell_, {p.x, p.y, line.line_class, 1.0 / (k_ * line.slant)}});
    }
}

}  // namespace ink::crosscheck
