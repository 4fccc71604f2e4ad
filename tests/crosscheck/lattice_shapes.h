#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "tests/truth/shapes.h"

namespace ink::crosscheck {

/// Parts of assemblies, with corners on a lattice of 1/8 that come to lie on each other, in one
/// plane and in one line as often as not.
class LatticeShapes {
  public:
    explicit LatticeShapes(std::mt19937_64& random) : random_(random) {}

    /// A whole number from `low` to `high`.
    int number(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }
    glm::vec3 place(int low, int high) {
        const int x = number(low, high), y = number(low, high);
        return {x, y, number(low, high)};
    }

    scene::Mesh any_box() {
        const glm::vec3 low = place(-3, 2);
        return truth::box(low, low + place(1, 3));
    }

    /// A solid: mostly boxes; dovetails, cylinders, plates of many triangles.
    scene::Mesh any_solid() {
        switch (number(0, 5)) {
            case 0:
                return dovetail();
            case 1:
                return cylinder();
            case 2:
                return plate();
            default:
                return any_box();
        }
    }

    /// Triangles between a few points: edges of one face, and of three and more.
    scene::Mesh soup() {
        scene::Mesh mesh;
        const int points = number(4, 8);
        for (int i = 0; i < points; ++i)
            mesh.positions.push_back(place(-2, 2));
        const auto vertex = [&] { return static_cast<std::uint32_t>(number(0, points - 1)); };
        for (int i = number(3, 14); i > 0; --i) {
            const std::uint32_t a = vertex(), b = vertex(), c = vertex();
            const auto& p = mesh.positions;
            if (glm::length(glm::cross(p[b] - p[a], p[c] - p[a])) > 0)
                mesh.triangles.push_back({a, b, c});
        }
        return mesh;
    }

  private:
    /// Along z, wider or narrower at its top.
    scene::Mesh dovetail() {
        const glm::vec3 low = place(-3, 1);
        const int width = number(3, 4), height = number(1, 2), length = number(1, 4);
        const int wider = number(-1, 1);
        const auto corner = [&](int x, int y, int z) {
            return low + glm::vec3(x * width + y * (2 * x - 1) * wider, y * height, z * length);
        };
        return hexahedron(corner);
    }

    /// Upright, of 8 or 16 sides.
    scene::Mesh cylinder() {
        scene::Mesh mesh;
        const int sides = number(0, 1) == 0 ? 8 : 16;
        const int radius = number(1, 2);
        const glm::vec3 base = place(-2, 1), top = base + glm::vec3(0, number(1, 3), 0);
        const auto rim = [&](int i) {
            const double angle = 2 * std::numbers::pi * (i % sides) / sides;
            return glm::vec3(std::round(8 * radius * std::cos(angle)) / 8,
                             0,
                             std::round(8 * radius * std::sin(angle)) / 8);
        };
        for (int i = 0; i < sides; ++i) {
            const glm::vec3 a = rim(i), b = rim(i + 1);
            truth::add_quad(mesh, base + a, top + a, top + b, base + b);
            truth::add_triangle(mesh, base, base + a, base + b);
            truth::add_triangle(mesh, top, top + b, top + a);
        }
        return mesh;
    }

    /// A box whose sides are grids: beside another its edges end in T-junctions.
    scene::Mesh plate() {
        scene::Mesh mesh;
        const glm::vec3 low = place(-3, 1);
        const glm::vec3 x{number(2, 4), 0, 0}, y{0, 1, 0}, z{0, 0, number(2, 4)};
        const int across = 1 << number(1, 3), along = 1 << number(1, 3);
        const auto side = [&](glm::vec3 at, glm::vec3 u, int nu, glm::vec3 v, int nv) {
            const auto point = [&](int i, int j) {
                return at + u * (static_cast<float>(i) / static_cast<float>(nu)) +
                       v * (static_cast<float>(j) / static_cast<float>(nv));
            };
            for (int i = 0; i < nu; ++i) {
                for (int j = 0; j < nv; ++j)
                    truth::add_quad(
                        mesh, point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
            }
        };
        side(low + y, z, along, x, across);
        side(low, x, across, z, along);
        side(low, z, along, y, 1);
        side(low + x, y, 1, z, along);
        side(low, y, 1, x, across);
        side(low + z, x, across, y, 1);
        return mesh;
    }

    template <class Corner>
    static scene::Mesh hexahedron(const Corner& p) {
        scene::Mesh mesh;
        truth::add_quad(mesh, p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1));
        truth::add_quad(mesh, p(1, 0, 0), p(0, 0, 0), p(0, 1, 0), p(1, 1, 0));
        truth::add_quad(mesh, p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1));
        truth::add_quad(mesh, p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0));
        truth::add_quad(mesh, p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1));
        truth::add_quad(mesh, p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0));
        return mesh;
    }

    std::mt19937_64& random_;
};

}  // namespace ink::crosscheck
