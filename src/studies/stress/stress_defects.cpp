#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "catalogue/shapes.h"
#include "studies/stress/stress_cases.h"

namespace ink::studies {
namespace {

/// MurmurHash3's finaliser: no generator to seed, and the same triangles on every machine.
std::uint32_t mixed(std::uint32_t n) {
    n = (n ^ (n >> 16)) * 0x85ebca6bU;
    n = (n ^ (n >> 13)) * 0xc2b2ae35U;
    return n ^ (n >> 16);
}

/// Which triangles are hit: those of a smaller share are among those of a larger one.
class Chosen {
  public:
    explicit Chosen(double percent) : below_(percent / 100 * 4294967296.0) {}
    [[nodiscard]] bool has(std::size_t triangle) const {
        return mixed(static_cast<std::uint32_t>(triangle) + 1) < below_;
    }

  private:
    double below_;
};

/// Makes of a mesh what the axis is about.
using Spoil = scene::Mesh (*)(scene::Mesh mesh, const Chosen& chosen);

/// Closed solids with even triangles: smooth, creased, and both.
std::vector<Case> spoiled(const StressPoint& point, Spoil spoil) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(1, 0.25, 0));
    const StressLook look{{1.75, 2.25, 4}, {0, 0, 0}, 34};
    const Chosen chosen(point.value);
    std::vector<std::pair<std::string, scene::Mesh>> solids;
    solids.emplace_back("ring", catalogue::make_torus({1.125, 0.5}, {40, 20}));
    solids.emplace_back("cube", cut_cube({-1, -0.625, -0.25, 0.25, 0.625, 1}));
    scene::Mesh drum = catalogue::make_cylinder(0.875, 1.75, 32);
    for (glm::vec3& p : drum.positions)
        p.y -= 0.875F;
    solids.emplace_back("drum", std::move(drum));
    std::vector<scene::Scene> scenes;
    for (auto& [name, mesh] : solids)
        scenes.push_back(scene_of(name, spoil(mesh, chosen), turn));
    return make_cases(point, std::move(scenes), look);
}

/// The triangle with three vertices of its own.
scene::Triangle with_own_vertices(scene::Mesh& mesh, const scene::Triangle& triangle) {
    scene::Triangle own{};
    for (std::size_t i = 0; i < 3; ++i) {
        own[i] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(glm::vec3(mesh.positions[triangle[i]]));
    }
    return own;
}

scene::Mesh duplicated(scene::Mesh mesh, const Chosen& chosen) {
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
        if (chosen.has(t)) mesh.triangles.push_back(scene::Triangle(mesh.triangles[t]));
    }
    return mesh;
}

scene::Mesh cut_at_edges(scene::Mesh mesh, const Chosen& chosen) {
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
        if (!chosen.has(t)) continue;
        const auto [a, b, c] = mesh.triangles[t];
        const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5F);
        mesh.triangles[t] = {a, middle, c};
        mesh.triangles.push_back({middle, b, c});
    }
    return mesh;
}

scene::Mesh cracked(scene::Mesh mesh, const Chosen& chosen) {
    constexpr float kStep = 1.0F / (1 << 20);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
        if (!chosen.has(t)) continue;
        mesh.triangles[t] = with_own_vertices(mesh, mesh.triangles[t]);
        for (const std::uint32_t v : mesh.triangles[t]) {
            for (int axis = 0; axis < 3; ++axis) {
                const std::uint32_t chance = mixed(3 * v + static_cast<std::uint32_t>(axis));
                mesh.positions[v][axis] += (static_cast<float>(chance % 3) - 1) * kStep;
            }
        }
    }
    return mesh;
}

scene::Mesh turned_over(scene::Mesh mesh, const Chosen& chosen) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (chosen.has(t)) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    return mesh;
}

scene::Mesh scattered(scene::Mesh mesh, const Chosen& chosen) {
    std::vector<scene::Triangle> kept;
    std::vector<std::pair<std::uint32_t, scene::Triangle>> loose;
    const std::vector<scene::Triangle> triangles = mesh.triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (chosen.has(t)) {
            loose.emplace_back(mixed(static_cast<std::uint32_t>(t) + 0x5eedU),
                               with_own_vertices(mesh, triangles[t]));
        } else {
            kept.push_back(triangles[t]);
        }
    }
    std::sort(loose.begin(), loose.end());
    mesh.triangles = std::move(kept);
    for (const auto& [order, triangle] : loose)
        mesh.triangles.push_back(triangle);
    return mesh;
}

}  // namespace

void add_defect_axes(std::vector<Axis>& axes) {
    const auto defect = [&](std::string name, std::string what, std::string sentence, Spoil spoil) {
        axes.push_back(make_axis(
            {std::move(name), "share of triangles " + std::move(what), "%", AxisScale::linear},
            {0, 1, 2, 5, 10, 20, 40, 70, 100},
            std::move(sentence),
            [spoil](const StressPoint& point) { return spoiled(point, spoil); }));
    };
    defect("duplicates",
           "that are there twice",
           "Some triangles of a ring, a cube and a drum are listed twice.",
           duplicated);
    defect("t_junctions",
           "that are cut at an edge their neighbour does not share",
           "Some triangles of a ring, a cube and a drum are halved at the middle of a side. Their "
           "neighbours do not share that vertex.",
           cut_at_edges);
    defect("cracks",
           "that are separated by a hairline",
           "Some triangles get vertices of their own, each off by up to a millionth of a unit: "
           "less than the truth's weld tolerance, so the truth has no line there.",
           cracked);
    defect("orientation",
           "that are turned inside out",
           "Some triangles run the other way round; the truth does not depend on this.",
           turned_over);
    defect("soup",
           "without shared vertices",
           "Some triangles get vertices of their own at the same places, and a place of their own "
           "in the list.",
           scattered);
}

}  // namespace ink::studies
