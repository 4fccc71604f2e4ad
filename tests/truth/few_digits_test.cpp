// Parts that were made to touch and were written with few decimal digits are the same in every
// pose: what the digits leave open, and the image cannot show, counts as touching.

#include <glm/gtc/quaternion.hpp>
#include <random>

#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

/// Corners in double: a part as its maker meant it.
using Quad = std::array<glm::dvec3, 4>;
using Part = std::vector<Quad>;

glm::dmat3 random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::mat3_cast(
        glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random))));
}

/// The part turned, and written with so many decimals.
scene::Mesh written(const Part& part, const glm::dmat3& rotation, int decimals) {
    const double scale = std::pow(10.0, decimals);
    scene::Mesh mesh;
    for (const Quad& quad : part) {
        std::array<glm::vec3, 4> p;
        for (std::size_t i = 0; i < 4; ++i)
            p[i] = glm::vec3(glm::round(rotation * quad[i] * scale) / scale);
        add_quad(mesh, p[0], p[1], p[2], p[3]);
    }
    return mesh;
}

struct Written {
    scene::Scene scene;
    scene::View view;
};

Written written(const std::vector<Part>& parts,
                const scene::View& view,
                const glm::dmat3& rotation,
                int decimals) {
    std::vector<scene::Mesh> meshes;
    for (const Part& part : parts)
        meshes.push_back(written(part, rotation, decimals));
    Written result{scene_of(std::move(meshes)), view};
    result.view.camera.eye_world = rotation * view.camera.eye_world;
    result.view.camera.view_from_world = view.camera.view_from_world * glm::transpose(rotation);
    return result;
}

/// Expects in ten poses, each written with so many decimals, what the parts show as they are meant.
void expect_as_meant(const std::vector<Part>& parts, const scene::View& view, int decimals) {
    // Nine decimals are more than floats have.
    const Written meant = written(parts, view, glm::dmat3(1), 9);
    const auto expected = lengths(trace(meant.scene, meant.view));
    std::mt19937 random(5);
    for (int i = 0; i < 10; ++i) {
        const Written posed = written(parts, view, random_rotation(random), decimals);
        auto found = lengths(trace(posed.scene, posed.view));
        for (const LineClass c : kLineClasses) {
            const auto at = expected.find(c);
            const double length = at == expected.end() ? 0 : at->second;
            EXPECT_NEAR(found[c], length, 1 + 1e-3 * length) << name(c) << ", pose " << i;
        }
    }
}

Quad quad(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
    return {a, b, c, d};
}

Part box_part(glm::dvec3 low, glm::dvec3 high) {
    const auto p = [&](int x, int y, int z) {
        return glm::dvec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    return {quad(p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)),
            quad(p(1, 0, 0), p(0, 0, 0), p(0, 1, 0), p(1, 1, 0)),
            quad(p(1, 0, 1), p(1, 0, 0), p(1, 1, 0), p(1, 1, 1)),
            quad(p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0)),
            quad(p(0, 1, 1), p(1, 1, 1), p(1, 1, 0), p(0, 1, 0)),
            quad(p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1))};
}

Part turned(Part part, double angle_rad) {
    for (Quad& q : part) {
        for (glm::dvec3& p : q)
            p = {p.x * std::cos(angle_rad) + p.z * std::sin(angle_rad),
                 p.y,
                 p.z * std::cos(angle_rad) - p.x * std::sin(angle_rad)};
    }
    return part;
}

const Part kPlate = {quad({-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0})};
const Part kDecal = {quad({-0.7, -0.4, 0}, {0.9, -0.3, 0}, {0.7, 0.5, 0}, {-0.9, 0.2, 0})};

Part joined(Part a, const Part& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// At a distance of 6 a pixel is .01 wide, and 1/64 px twice what four decimals move a vertex by.
const scene::View kBefore = view_from({1, -2, 6}, {0, 0, 0});

TEST(FewDigits, ASheetThatStandsOnAPlate) {
    const Part sheet = {quad({-1, 0.3, 0}, {1, 0.4, 0}, {1, 0.4, 1}, {-1, 0.3, 1})};
    expect_as_meant({kPlate, sheet}, kBefore, 4);
    expect_as_meant({joined(kPlate, sheet)}, kBefore, 4);
}

TEST(FewDigits, ASheetBehindAPlateIsNotSeenThroughIt) {
    const Part sheet = {quad({-1, 0.3, 0}, {1, 0.4, 0}, {1, 0.4, -1}, {-1, 0.3, -1})};
    expect_as_meant({kPlate, sheet}, kBefore, 4);
    expect_as_meant({joined(kPlate, sheet)}, kBefore, 4);
}

TEST(FewDigits, ADecal) {
    expect_as_meant({kDecal, kPlate}, kBefore, 4);
    expect_as_meant({kPlate, kDecal}, kBefore, 4);
    expect_as_meant({joined(kPlate, kDecal)}, kBefore, 4);
}

TEST(FewDigits, StackedSheets) {
    const auto sheet = [](double level, double angle_rad) {
        return turned(box_part({-1.6, level, -1.1}, {1.6, level + 0.05, 1.1}), angle_rad);
    };
    expect_as_meant(
        {sheet(0, 0), sheet(0.05, 0.25), sheet(0.1, 0.55)}, view_from({1, 4, 5}, {0, 0, 0}), 4);
}

TEST(FewDigits, StackedBoxes) {
    const std::vector<Part> boxes = {box_part({-3, -1.1, -2}, {3, -0.7, 2}),
                                     box_part({-1.3, -0.7, -0.6}, {0.1, 0.4, 0.7}),
                                     box_part({0.1, -0.7, -0.9}, {1.2, 0.7, 0.3}),
                                     box_part({-1.1, 0.4, -0.6}, {0.1, 0.9, 0.3})};
    expect_as_meant(boxes, view_from({3.3, 3, 6}, {0, 0, 0}), 4);
    expect_as_meant(boxes, view_from({-4, 1.2, 5}, {0, 0, 0}), 4);
}

/// A square sheet of cells through the origin that rises by `slope` along x.
Part sloping(double half, int cells, double slope) {
    Part part;
    const auto p = [&](int i, int j) {
        const double x = half * (2.0 * i / cells - 1), y = half * (2.0 * j / cells - 1);
        return glm::dvec3(x, y, slope * x);
    };
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j)
            part.push_back(quad(p(i, j), p(i + 1, j), p(i + 1, j + 1), p(i, j + 1)));
    }
    return part;
}

TEST(FewDigits, AShallowCrossingStays) {
    // They bend by .23 degrees, and part by 12 roundings on either side.
    expect_as_meant({sloping(1, 1, 2e-3), sloping(0.9, 1, -2e-3)}, kBefore, 4);
}

TEST(FewDigits, SoDoesOneOfCellsThatDigitsTakeForLevel) {
    // Two sheets part by 8 roundings on either side, but neighbouring cells by less than one. Where
    // exactly they cross the digits do not say: the line is ragged.
    const std::vector<Part> sheets = {sloping(1, 16, 5e-4), sloping(0.9, 15, -5e-4)};
    std::mt19937 random(5);
    for (const bool is_one : {false, true}) {
        const std::vector<Part> parts =
            is_one ? std::vector<Part>{joined(sheets[0], sheets[1])} : sheets;
        for (int i = 0; i < 10; ++i) {
            const Written posed = written(parts, kBefore, random_rotation(random), 4);
            EXPECT_GT(lengths(trace(posed.scene, posed.view))[LineClass::intersection], 140)
                << "of at least 1.8 * 600 / 6.4, pose " << i;
        }
    }
}

TEST(FewDigits, ASheetThatReachesThroughAPlateByMoreThanDigitsMay) {
    const Part sheet = {quad({-1, 0.3, -1e-3}, {1, 0.4, -1e-3}, {1, 0.4, 1}, {-1, 0.3, 1})};
    const auto seen = lengths(trace(
        scene_of({written(kPlate, glm::dmat3(1), 9), written(sheet, glm::dmat3(1), 9)}), kBefore));
    EXPECT_GT(seen.at(LineClass::intersection), 100);
    expect_as_meant({kPlate, sheet}, kBefore, 4);
}

TEST(FewDigits, AThinWedgeOnAPlate) {
    // From nothing to 2 px high.
    const glm::dvec3 a(-1.3, -0.3, 0), b(-1.3, 0.4, 0), c(0.7, 0.4, 0), d(0.7, -0.3, 0);
    const glm::dvec3 e(0.7, 0.4, 0.02), f(0.7, -0.3, 0.02);
    const Part wedge = {
        quad(a, b, c, d), quad(a, f, e, b), quad(d, c, e, f), quad(a, d, f, f), quad(b, e, c, c)};
    expect_as_meant({kPlate, wedge}, kBefore, 4);
}

TEST(FewDigits, WhatTheImageShowsIsDrawn) {
    // Four decimals each. The sheet reaches through the plate by one unit of the last.
    const scene::Mesh plate =
        written({quad({-2.0001, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0})}, glm::dmat3(1), 4);
    const scene::Mesh sheet = written(
        {quad({-1, 0.3, -1e-4}, {1, 0.3, -1e-4}, {1, 0.3, 1}, {-1, 0.3, 1})}, glm::dmat3(1), 4);
    const scene::Scene scene = scene_of({plate, sheet});
    const auto foot = [&](LineClass line_class, double distance) {
        const scene::View view = view_from({0, -distance, distance}, {0, 0.3, 0});
        auto seen = lengths(trace(scene, view));
        return seen[line_class];
    };
    EXPECT_EQ(foot(LineClass::intersection, 5), 0);
    EXPECT_GT(foot(LineClass::intersection, 1), 500) << "1/64 px is half of what digits may hide";
}

}  // namespace
}  // namespace ink::truth
