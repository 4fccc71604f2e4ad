#include <array>

#include "catalogue/shapes.h"

// Newell's control points (M. Newell, "The utilization of procedure models in digital image
// synthesis", University of Utah 1975), shortened by their symmetries: body, rim, lid and bottom
// are one quarter turned four times; handle and spout are one half and its mirror image. His z is
// up; ours is y.

namespace ink::catalogue {
namespace {

using Row = std::array<glm::dvec3, 4>;  ///< four control points across a patch, Newell's axes

/// A row of a quarter: (r, 0), (r, k), (k, r), (0, r) at height z. He took k = 0.56 r, once 0.5625
/// r.
struct Quarter {
    double r;
    double k;
    double z;
};

/// A row of a half: (x0, z0), twice out to the side by `width`, (x1, z1).
struct Half {
    double x0;
    double z0;
    double width;
    double x1;
    double z1;
};

constexpr Quarter kBody[] = {
    {0, 0, 0},
    {1.425, .798, 0},
    {1.5, .84, .075},  // bottom
    {1.5, .84, .15},
    {1.5, .84, .225},
    {2, 1.12, .45},  // lower body
    {2, 1.12, .9},
    {2, 1.12, 1.35},
    {1.75, .98, 1.875},  // upper body
    {1.5, .84, 2.4},
    {1.4375, .805, 2.53125},
    {1.3375, .749, 2.53125},  // rim
    {1.4, .784, 2.4},
};
constexpr Quarter kLid[] = {
    {1.3, .728, 2.4},
    {1.3, .728, 2.55},
    {.4, .224, 2.55},
    {.2, .112, 2.7},
    {0, 0, 2.85},
    {.8, .45, 3.15},
    {0, 0, 3.15},
};
constexpr Half kHandle[] = {
    {-1.6, 2.025, .3, -1.5, 2.25},
    {-2.3, 2.025, .3, -2.5, 2.25},
    {-2.7, 2.025, .3, -3, 2.25},
    {-2.7, 1.8, .3, -3, 1.8},
    {-2.7, 1.575, .3, -3, 1.35},
    {-2.5, 1.125, .3, -2.65, .9375},
    {-2, .9, .3, -1.9, .6},
};
constexpr Half kSpout[] = {
    {1.7, 1.425, .66, 1.7, .6},
    {2.6, 1.425, .66, 3.1, .825},
    {2.3, 2.1, .25, 2.4, 2.025},
    {2.7, 2.4, .25, 3.3, 2.4},
    {2.8, 2.475, .25, 3.525, 2.49375},
    {2.9, 2.475, .15, 3.45, 2.5125},
    {2.8, 2.4, .15, 3.2, 2.4},
};

Row control_row(const Quarter& q) {
    return {glm::dvec3(q.r, 0, q.z), {q.r, q.k, q.z}, {q.k, q.r, q.z}, {0, q.r, q.z}};
}

Row control_row(const Half& h) {
    return {
        glm::dvec3(h.x0, 0, h.z0), {h.x0, -h.width, h.z0}, {h.x1, -h.width, h.z1}, {h.x1, 0, h.z1}};
}

glm::dvec3 bezier(const Row& p, double t) {
    const double s = 1 - t;
    return p[0] * (s * s * s) + p[1] * (3 * s * s * t) + p[2] * (3 * s * t * t) +
           p[3] * (t * t * t);
}

glm::dvec3 y_up(const glm::dvec3& p) {
    return {p.x, p.z, -p.y};
}

/// All the way round: the quarter and its three turns.
Ring ring_of(const Quarter&, const Row& row, int cuts) {
    Ring ring;
    for (int turns = 0; turns < 4; ++turns) {
        for (int i = 0; i < cuts; ++i) {
            glm::dvec3 p = bezier(row, double(i) / cuts);
            for (int k = 0; k < turns; ++k)
                p = {-p.y, p.x, p.z};
            ring.push_back(y_up(p));
        }
    }
    if (row[0].x == 0) ring.resize(1);
    return ring;
}

/// There on one side, and back on the other; counter-clockwise seen from the end of the tube.
Ring ring_of(const Half&, const Row& row, int cuts) {
    Ring ring;
    for (int i = 0; i < cuts; ++i)
        ring.push_back(y_up(bezier(row, double(i) / cuts)));
    for (int i = cuts; i > 0; --i) {
        const glm::dvec3 p = bezier(row, double(i) / cuts);
        ring.push_back(y_up({p.x, 0.0 - p.y, p.z}));
    }
    return ring;
}

template <class Control>
scene::Mesh tessellate(std::span<const Control> controls, int cuts) {
    std::vector<Ring> rings;
    for (std::size_t patch = 0; patch + 3 < controls.size(); patch += 3) {
        const bool is_last = patch + 4 == controls.size();
        for (int i = 0; i < cuts + (is_last ? 1 : 0); ++i) {
            Row row;
            for (std::size_t across = 0; across < 4; ++across) {
                Row along;
                for (std::size_t k = 0; k < 4; ++k) {
                    along[k] = control_row(controls[patch + k])[across];
                }
                row[across] = bezier(along, double(i) / cuts);
            }
            rings.push_back(ring_of(controls[patch], row, cuts));
        }
    }
    return loft(rings);
}

}  // namespace

Teapot make_teapot(int cuts) {
    return {tessellate<Quarter>(kBody, cuts),
            tessellate<Quarter>(kLid, cuts),
            tessellate<Half>(kHandle, cuts),
            tessellate<Half>(kSpout, cuts)};
}

}  // namespace ink::catalogue
