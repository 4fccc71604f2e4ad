#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"

namespace ink::catalogue {
namespace {

/// A level square about the origin that faces up.
scene::Mesh square(double half) {
    return make_sheet({-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0});
}

/// -1, 0 or 1, different for each corner and axis: MurmurHash3's finaliser, so no generator to
/// seed.
double jitter(std::uint32_t n) {
    n = (n ^ (n >> 16)) * 0x85ebca6bU;
    n = (n ^ (n >> 13)) * 0xc2b2ae35U;
    return static_cast<double>((n ^ (n >> 16)) % 3) - 1;
}

/// `mesh` with three vertices of its own for each triangle, each off by at most one grid step an
/// axis.
scene::Mesh shattered(const scene::Mesh& mesh) {
    constexpr double kStep = 1.0 / (1 << 20);
    scene::Mesh result;
    std::uint32_t n = 0;
    for (const scene::Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) {
            const glm::dvec3 off{jitter(n), jitter(n + 1), jitter(n + 2)};
            result.positions.emplace_back(snapped(glm::dvec3(mesh.positions[v]) + off * kStep));
            n += 3;
        }
        const auto end = static_cast<std::uint32_t>(result.positions.size());
        result.triangles.push_back({end - 3, end - 2, end - 1});
    }
    return result;
}

/// One of the twenty faces of a finely cut icosahedron, moved out by `gap`.
scene::Mesh ball_piece(const scene::Mesh& ball, std::size_t piece, double gap) {
    const std::size_t size = ball.triangles.size() / 20;
    scene::Mesh result;
    glm::dvec3 middle{0};
    std::vector<std::uint32_t> place(ball.positions.size(), ~0U);
    for (std::size_t t = piece * size; t < (piece + 1) * size; ++t) {
        scene::Triangle triangle{};
        for (int i = 0; i < 3; ++i) {
            auto& at = place[ball.triangles[t][i]];
            if (at == ~0U) {
                at = static_cast<std::uint32_t>(result.positions.size());
                result.positions.push_back(ball.positions[ball.triangles[t][i]]);
                middle += glm::dvec3(result.positions.back());
            }
            triangle[i] = at;
        }
        result.triangles.push_back(triangle);
    }
    const Pose out{middle * (gap / double(result.positions.size()))};
    return moved(result, placed(out));
}

/// The straight bar from `a` to `b`, round: twelve sides bend less than a crease.
scene::Mesh bar(const glm::dvec3& a, const glm::dvec3& b, double radius) {
    const TubeNode ends[] = {{a, radius}, {b, radius}};
    return make_tube(ends, 12);
}

/// A space frame: two square grids of balls, the lower half a step aside, joined by bars. Every bar
/// ends inside its two balls and touches no other bar.
class SpaceFrame {
  public:
    SpaceFrame(Stage& stage, glm::ivec2 size) : stage_(stage), size_(size) {}

    void build() {
        const glm::ivec2 low = size_ - 1;
        place_layer(size_, upper(0, 0));
        place_layer(low, lower(0, 0));
        for (int j = 0; j < low.y; ++j) {
            for (int i = 0; i < low.x; ++i) {
                for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
                    join("brace", lower(i, j), upper(i + di, j + dj), 0.0035);
            }
        }
    }

  private:
    [[nodiscard]] glm::dvec3 upper(int i, int j) const {
        return {i - 0.5 * (size_.x - 1), 0, j - 0.5 * (size_.y - 1)};
    }
    [[nodiscard]] glm::dvec3 lower(int i, int j) const {
        return upper(i, j) + glm::dvec3(0.5, -0.75, 0.5);
    }

    void place_layer(glm::ivec2 count, const glm::dvec3& first) {
        for (int j = 0; j < count.y; ++j) {
            for (int i = 0; i < count.x; ++i) {
                const glm::dvec3 at = first + glm::dvec3(i, 0, j);
                stage_.place(ball_, "ball", Pose{at});
                if (i + 1 < count.x) join("chord", at, at + glm::dvec3(1, 0, 0), 0.006);
                if (j + 1 < count.y) join("chord", at, at + glm::dvec3(0, 0, 1), 0.006);
            }
        }
    }

    /// The bar ends 0.015 short of the balls' middles.
    void join(const char* name, const glm::dvec3& a, const glm::dvec3& b, double radius) {
        const glm::dvec3 short_by = glm::normalize(b - a) * 0.015;
        stage_.add(name, bar(a + short_by, b - short_by, radius));
    }

    Stage& stage_;
    glm::ivec2 size_;
    std::uint32_t ball_ = stage_.mesh("ball", make_icosphere(0.03, 2));
};

}  // namespace

scene::Scene make_tiles_scene() {
    // Rows from the back to the front; '.' lies level, 'o' is missing, '^' is raised.
    constexpr std::array<const char*, 5> kPlan = {
        ".......", ".^^..o.", "..^....", ".o...^.", "...o..."};
    Stage stage;
    const auto tile = stage.mesh("tile", square(0.5));
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 7; ++column) {
            const char kind = kPlan[row][column];
            if (kind == 'o') continue;
            const double height = kind == '^' ? 0.25 : 0.0;
            stage.place(tile, "tile", Pose{{column - 3.0, height, row - 2.0}});
        }
    }
    return stage.finish({{"three_quarter", 28, 38}, {"above", 0, 84}},
                        {{"grazing", {-2.75, 0.75, 4}, {0.125, -0.25, 0}, 40}});
}

scene::Scene make_layers_scene() {
    Stage stage;
    const auto low = stage.mesh("low", square(0.5));
    const auto high = stage.mesh("high", square(0.375));
    for (int i = 0; i < 8; ++i) {
        // From an eighth of a unit apart down to 8e-6.
        const double gap = std::ldexp(1.0, -3 - 2 * i);
        const glm::dvec3 at{1.25 * (i % 4) - 1.875, 0, 1.25 * (i / 4) - 0.625};
        stage.place(low, "low", Pose{at});
        stage.place(high, "high", Pose{at + glm::dvec3(0, gap, 0), {0, 9.0 + 10 * i, 0}});
    }
    return stage.finish({{"three_quarter", 24, 40}, {"above", 0, 76}},
                        {{"grazing", {-1.75, 0.5, 2.5}, {-0.125, -0.125, 0}, 42}});
}

scene::Scene make_hills_scene() {
    Stage stage;
    const auto height = [](double x, double z) {
        const double bump = (x - 1.2) * (x - 1.2) + (z + 1.5) * (z + 1.5);
        return 0.8 * std::sin(0.9 * x + 0.4) * std::cos(0.8 * z) +
               0.45 * std::sin(1.7 * z - 0.6 * x) + 1.25 * std::exp(-0.5 * bump);
    };
    stage.add("hills", make_sheet({96, 128}, [&](double u, double v) {
                  const double x = 10 * v - 5;
                  const double z = 7 * u - 3.5;
                  return glm::dvec3(x, height(x, z), z);
              }));
    return stage.finish({{"three_quarter", 22, 26}, {"grazing", -24, 12}},
                        {{"valley", {-1.5, 1.625, 2.875}, {0.75, 0.25, -1.5}, 60}});
}

scene::Scene make_soup_scene() {
    Stage stage;
    stage.add(
        "cracked", shattered(make_torus({1.25, 0.5}, {64, 32})), {{-1.75, 0, 0}, {58, 20, 0}});
    const scene::Mesh ball = make_icosphere(1.375, 4);
    for (std::size_t piece = 0; piece < 20; ++piece) {
        stage.add("piece", ball_piece(ball, piece, 0.125), {{1.75, 0, 0}, {14, 9, 0}});
    }
    return stage.finish({{"front", 0, 5}, {"three_quarter", 26, 28}, {"behind", 160, -18}});
}

scene::Scene make_flag_scene() {
    Stage stage;
    stage.add("pole", make_cylinder(0.0625, 3, 24), {{0, -0.75, 0}});
    stage.add("parameter", make_icosphere(0.14, 2), {{0, 2.3, 0}});
    const auto cloth = [](double u, double v) {
        const double phase = 8 * u - 1.3 * v;
        const double wave = u * (0.4 * std::sin(phase) + 0.1 * std::sin(13 * u + 2 * v));
        const double back = 0.25 * u * std::sin(2 * phase + 0.7);  // folds lean over
        return glm::dvec3(0.1 + 3.25 * u + back, 2 * v - 0.35 * u * u, wave);
    };
    stage.add("cloth", make_sheet({160, 40}, cloth));
    return stage.finish({{"front", 0, 3}, {"three_quarter", 36, 18}, {"below", -48, -20}});
}

scene::Scene make_drapery_scene() {
    // A round cloth on a round table: flat inside the unit circle, then over the edge and down in
    // folds that double back, so that each hides a part of itself.
    constexpr double kEdge = 0.15;  // radius of the bend at the table's edge
    constexpr double kBend = kEdge * std::numbers::pi / 2;
    constexpr double kLength = 2.3;  // from the middle to the hem
    constexpr double kFolds = 13;
    const auto cloth = [](double turn_rad, double way) {
        const double bent_rad = std::clamp((way - 1) / kEdge, 0.0, std::numbers::pi / 2);
        const double drop = std::max(way - 1 - kBend, 0.0);
        const double grown = drop / (drop + 0.45);
        const double phase =
            kFolds * turn_rad + 0.8 * std::sin(2 * turn_rad) + 0.5 * std::sin(3 * turn_rad + 1);
        const double depth = grown * (0.26 + 0.05 * std::sin(5 * turn_rad));
        const double back_rad = grown * 0.09 * std::sin(2 * phase) + turn_rad;
        const double out = std::min(way, 1.0) + kEdge * std::sin(bent_rad) + 0.12 * drop +
                           depth * (1 + std::cos(phase)) * 0.75;
        const double height = -kEdge * (1 - std::cos(bent_rad)) - 0.94 * drop;
        return glm::dvec3(out * std::cos(back_rad), height, -out * std::sin(back_rad));
    };
    std::vector<double> ways;  // most rings where the cloth bends
    for (int i = 1; i <= 5; ++i)
        ways.push_back(i / 5.0);
    for (int i = 1; i <= 10; ++i)
        ways.push_back(1 + kBend * i / 10);
    for (int i = 1; i <= 32; ++i)
        ways.push_back(1 + kBend + (kLength - 1 - kBend) * i / 32);
    constexpr int kAround = 624;
    std::vector<Ring> rings;  // from the hem to the middle
    for (auto way = ways.rbegin(); way != ways.rend(); ++way) {
        Ring ring;
        for (int i = 0; i < kAround; ++i)
            ring.push_back(cloth(2 * std::numbers::pi * i / kAround, *way));
        rings.push_back(std::move(ring));
    }
    rings.push_back({{0, 0, 0}});
    Stage stage;
    stage.add("cloth", loft(rings));
    return stage.finish({{"front", 0, 12}, {"three_quarter", 28, 36}},
                        {{"close", {0.875, 0.125, 3.5}, {0.25, -0.5, 0.75}, 34}});
}

scene::Scene make_truss_scene() {
    Stage stage;
    SpaceFrame(stage, {4, 3}).build();
    return stage.finish({{"three_quarter", 34, 34}},
                        {{"below", {-2.5, -1.75, 2.5}, {0, -0.375, 0}, 42}});
}

scene::Scene make_bars_scene() {
    // In the view "front" at 1280 x 720 a unit of the bars' fronts is 64 px, so a bar of w / 64
    // units is w px wide. It is as deep as it is wide: its sides add at most a fifth to that.
    constexpr double kUnit_px = 64;
    constexpr double kDistance = 45;
    constexpr double kFov_deg = 14.250032697803595;  // twice the arc tangent of 360 / 64 / 45
    Stage stage;
    stage.add("panel", make_sheet({-9.5, -5.25, -0.25}, {19, 0, 0}, {0, 10.5, 0}));
    for (int i = 0; i < 16; ++i) {
        const double width = (0.05 + 0.01 * i) / kUnit_px;
        // Each bar lies elsewhere within its pixel than its neighbour.
        const double x = 1.0 * i - 7.5 + 0.0071 * i;
        stage.add("upright", make_box({x, 0.5, -width}, {x + width, 4.5, 0}));
        const double left = 4.0 * (i % 4) - 7.5;
        const double y = -0.75 - 1.0 * (i / 4) + 0.0037 * i;
        stage.add("level", make_box({left, y, -width}, {left + 3, y + width, 0}));
    }
    stage.view(EyeShot{"front", {0, 0, kDistance}, {0, 0, 0}, kFov_deg});
    return stage.finish({{"three_quarter", 24, 14}});
}

}  // namespace ink::catalogue
