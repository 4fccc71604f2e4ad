#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "catalogue/shapes.h"
#include "studies/stress/stress_cases.h"

namespace ink::studies {
namespace {

constexpr StressLook kThreeQuarter{{1.75, 2.25, 4}, {0, 0, 0}, 34};

/// A level square about the origin that faces up.
scene::Mesh square(double half) {
    return catalogue::make_sheet({-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0});
}

glm::dmat4 turned(double about_x_deg, double about_y_deg) {
    const glm::dmat4 m = glm::rotate(glm::dmat4(1), glm::radians(about_x_deg), glm::dvec3(1, 0, 0));
    return glm::rotate(m, glm::radians(about_y_deg), glm::dvec3(0, 1, 0));
}

/// Each triangle in three: one of them as flat as `aspect` says, on its first side.
scene::Mesh with_slivers(const scene::Mesh& mesh, double aspect) {
    scene::Mesh result;
    result.positions = mesh.positions;
    for (const scene::Triangle& t : mesh.triangles) {
        const glm::dvec3 a = mesh.positions[t[0]];
        const glm::dvec3 b = mesh.positions[t[1]];
        const glm::dvec3 c = mesh.positions[t[2]];
        const glm::dvec3 middle = (a + b) / 2.0;
        const glm::dvec3 center = (a + b + c) / 3.0;
        const double base = glm::distance(a, b);
        const double height = glm::length(glm::cross(b - a, center - a)) / base;
        const double share = std::min(1.0, base / (aspect * height));
        const auto p = static_cast<std::uint32_t>(result.positions.size());
        result.positions.emplace_back(middle + share * (center - middle));
        result.triangles.push_back({t[0], t[1], p});
        result.triangles.push_back({t[1], t[2], p});
        result.triangles.push_back({t[2], t[0], p});
    }
    return result;
}

scene::Scene needles(double aspect) {
    scene::Mesh needle;
    const auto half = static_cast<float>(0.5 / aspect);
    needle.positions = {{-half, 0, 0}, {half, 0, 0}, {0, 1, 0}};
    needle.triangles = {{0, 1, 2}};
    scene::Scene scene = scene_of("needles", square(1.75));
    for (int i = 0; i < 14; ++i)
        put(scene, needle, moved({-1.625 + 0.25 * i, 0.0625, 0.25 * (i % 5) - 0.5}));
    return scene;
}

/// A rolling sheet of n x n quads.
scene::Mesh hills(int n) {
    std::vector<catalogue::Ring> rows;
    for (int j = 0; j <= n; ++j) {
        catalogue::Ring row;
        for (int i = 0; i <= n; ++i) {
            const double x = 4.0 * j / n - 2;
            const double z = 3.0 * i / n - 1.5;
            row.emplace_back(x, 0.375 * std::sin(2.5 * x + 0.4) * std::cos(2.0 * z), z);
        }
        rows.push_back(std::move(row));
    }
    return catalogue::loft(rows, {.around = false});
}

int rounded(double x) {
    return static_cast<int>(std::lround(x));
}

std::vector<Case> gap_cases(const StressPoint& point) {
    const double gap = point.value;
    scene::Scene leaf = scene_of("leaf", square(1.25));
    put(leaf, square(0.75), moved({0, gap, 0}) * turned(0, 20));
    scene::Scene slits;
    slits.name = "slits";
    for (const double x : {-1.0, 0.0, 1.0}) {
        for (const double z : {-0.5, 0.5})
            put(slits, square(0.5), moved({x * (1 + gap), 0, z * (1 + gap)}));
    }
    const scene::Mesh box = catalogue::make_box({0, -0.5, -1}, {1, 0, 1});
    scene::Scene step = scene_of("step", box, moved({-1, 0, 0}));
    put(step, box, moved({0, gap, 0}));
    const scene::Scene plate = scene_of("plate",
                                        catalogue::make_box({-1.25, 0, -1}, {1.25, 1, 1}),
                                        glm::scale(glm::dmat4(1), glm::dvec3(1, gap, 1)));
    return make_cases(point, {leaf, slits, step, plate}, kThreeQuarter);
}

std::vector<Case> sliver_cases(const StressPoint& point) {
    const double width = 1 / point.value;
    const scene::Mesh ring = catalogue::make_torus({1.125, 0.5}, {48, 24});
    return make_cases(point,
                      {scene_of("cut_cube", cut_cube({-1, 0, width, 1.25}), turned(14, 33)),
                       scene_of("split_ring", with_slivers(ring, point.value), turned(30, 0)),
                       needles(point.value)},
                      kThreeQuarter);
}

std::vector<Case> facet_cases(const StressPoint& point) {
    const double facets = point.value;
    // 2 * segments * (stacks - 1) triangles with segments = 2 * stacks; 2 a b round a ring; 2 n n.
    const int stacks = std::max(2, rounded(std::sqrt(facets / 4 + 0.25) + 0.5));
    const int round_tube = std::max(3, rounded(std::sqrt(facets / 4)));
    const int round_ring = std::max(3, rounded(facets / 2 / round_tube));
    const int quads = std::max(2, rounded(std::sqrt(facets / 2)));
    const scene::Mesh ring = catalogue::make_torus({1.125, 0.5}, {round_ring, round_tube});
    return make_cases(point,
                      {scene_of("ball", catalogue::make_sphere(1.25, 2 * stacks, stacks)),
                       scene_of("ring", ring, turned(30, 0)),
                       scene_of("waves", hills(quads))},
                      kThreeQuarter);
}

}  // namespace

void add_shape_axes(std::vector<Axis>& axes) {
    axes.push_back(make_axis(
        {"gap", "distance between surfaces", "units"},
        {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1},
        "Coplanar things come apart by a gap: a sheet above another, slits between tiles, a step "
        "between two boxes, the thickness of a plate; each about 2 units wide, 5 units away.",
        gap_cases));
    axes.push_back(make_axis(
        {"sliver", "length over width of the thinnest triangles"},
        decades(0, 7),
        "A cube cut by thin strips, a ring each of whose triangles has one sliver, and free "
        "needles.",
        sliver_cases));
    axes.push_back(make_axis(
        {"facets", "triangles"},
        {8, 32, 128, 512, 2048, 8192, 32768, 131072, 1048576},
        "A ball, a ring and a rolling sheet from a handful of triangles to a million, far below a "
        "pixel.",
        facet_cases));
}

}  // namespace ink::studies
