#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "catalogue/cage.h"
#include "catalogue/catalogue_stage.h"

// Smooth bodies of one piece whose limbs pass in front of them. A tube of four corners shrinks to
// two thirds of its radius when it is subdivided; the radii below allow for it.

namespace ink::catalogue {
namespace {

/// A ring of eight points whose faces look along +z, +x and between; `scale` is (x, z).
Ring octagon(const glm::dvec3& centre, const glm::dvec2& scale) {
    constexpr double kCos = 0.92387953251128674;  // of 22.5 degrees
    constexpr double kSin = 0.38268343236508977;
    constexpr std::array<glm::dvec2, 8> kCorners{{{kCos, kSin},
                                                  {kCos, -kSin},
                                                  {kSin, -kCos},
                                                  {-kSin, -kCos},
                                                  {-kCos, -kSin},
                                                  {-kCos, kSin},
                                                  {-kSin, kCos},
                                                  {kSin, kCos}}};
    Ring ring;
    for (const glm::dvec2& corner : kCorners)
        ring.push_back(centre + glm::dvec3(corner.x * scale.x, 0, corner.y * scale.y));
    return ring;
}

/// Which face of a band of octagons looks to the viewer's side.
enum Side : std::size_t {
    right,
    back_right,
    back,
    back_left,
    left,
    front_left,
    front,
    front_right
};

/// The face between the octagons `band` and `band` + 1 that looks to `side`.
constexpr std::size_t face_at(std::size_t band, Side side) {
    return 8 * band + side;
}

/// Stations of an arm: how far out of the body's axis, how far round it, how high; its radius.
using Arm = std::array<glm::dvec4, 8>;

std::vector<TubeNode> arm_at(const Arm& arm, Side side) {
    const double angle_rad = std::numbers::pi / 4 * static_cast<double>(side);
    const glm::dvec3 out{std::cos(angle_rad), 0, -std::sin(angle_rad)};
    const glm::dvec3 round{-std::sin(angle_rad), 0, -std::cos(angle_rad)};
    std::vector<TubeNode> nodes;
    for (const glm::dvec4& at : arm) {
        const glm::dvec3 p = out * at.x + round * at.y + glm::dvec3(0, at.z, 0);
        nodes.push_back({p, at.w});
    }
    return nodes;
}

constexpr Arm kLyingArm{{{.78, 0, 0, .25},
                         {1.05, .1, -.12, .22},
                         {1.35, .3, -.14, .19},
                         {1.65, .3, -.12, .16},
                         {1.95, .1, -.1, .13},
                         {2.2, -.05, 0, .1},
                         {2.3, .08, .2, .075},
                         {2.15, .2, .34, .05}}};
constexpr Arm kRaisedArm{{{.8, 0, .1, .25},
                          {1.1, 0, .22, .22},
                          {1.32, .08, .5, .19},
                          {1.36, .22, .85, .16},
                          {1.24, .36, 1.15, .13},
                          {1.02, .42, 1.26, .1},
                          {.9, .34, 1.12, .075},
                          {.98, .26, .98, .05}}};
/// Reaches over its neighbour, which must lie.
constexpr Arm kCrossingArm{{{.78, 0, .05, .25},
                            {1.05, .1, .14, .22},
                            {1.25, .4, .34, .19},
                            {1.3, .8, .46, .16},
                            {1.2, 1.2, .48, .13},
                            {1.2, 1.5, .42, .1},
                            {1.28, 1.75, .32, .075},
                            {1.4, 1.92, .34, .05}}};

Cage octopus_cage() {
    const Ring rings[] = {octagon({0, -.05, 0}, {.5, .5}),
                          octagon({0, .3, 0}, {.62, .62}),
                          octagon({0, .55, 0}, {.42, .42}),
                          octagon({0, .85, -.05}, {.6, .58}),
                          octagon({0, 1.35, -.15}, {.82, .8}),
                          octagon({0, 1.85, -.32}, {.66, .66}),
                          octagon({0, 2.1, -.45}, {.28, .28})};
    Cage cage = cage_of_rings(rings);
    const Arm* const arms[] = {&kLyingArm,
                               &kRaisedArm,
                               &kLyingArm,
                               &kCrossingArm,
                               &kLyingArm,
                               &kRaisedArm,
                               &kCrossingArm,
                               &kLyingArm};
    for (std::size_t i = 0; i < 8; ++i) {
        const Side side{i};
        pull(cage, face_at(0, side), arm_at(*arms[i], side));
    }
    return cage;
}

/// A ring of ten points round a slab: five along its front from -x to +x, five back.
Ring slab(double height, double half_width, double half_depth, double forward) {
    Ring ring;
    for (int i = 0; i < 5; ++i)
        ring.emplace_back(half_width * (i - 2) / 2, height, forward + half_depth);
    for (int i = 4; i >= 0; --i)
        ring.emplace_back(half_width * (i - 2) / 2, height, forward - half_depth);
    return ring;
}

Cage hand_cage() {
    const Ring rings[] = {slab(-1.75, .32, .25, -.08),
                          slab(-1.2, .3, .21, -.03),
                          slab(-.95, .33, .2, 0),
                          slab(-.72, .46, .22, .02),
                          slab(-.3, .54, .19, 0),
                          slab(.1, .54, .16, 0)};
    Cage cage = cage_of_rings(rings);
    cage.faces.pop_back();  // the polygon over the knuckles becomes four faces
    const std::size_t first_finger = cage.faces.size();
    const auto end = static_cast<std::uint32_t>(cage.points.size()) - 10;
    for (std::uint32_t i = 0; i < 4; ++i)
        cage.faces.push_back({end + i, end + i + 1, end + 8 - i, end + 9 - i});
    // Little, ring and middle finger bend to the palm, the first points up.
    const std::vector<TubeNode> little{{{-.45, .27, .02}, .19},
                                       {{-.48, .44, .1}, .18},
                                       {{-.48, .52, .3}, .17},
                                       {{-.46, .42, .47}, .165},
                                       {{-.44, .24, .5}, .155},
                                       {{-.43, .12, .45}, .13}};
    const std::vector<TubeNode> ring{{{-.15, .32, .02}, .2},
                                     {{-.16, .54, .09}, .19},
                                     {{-.16, .65, .31}, .18},
                                     {{-.155, .54, .53}, .175},
                                     {{-.15, .33, .57}, .165},
                                     {{-.145, .18, .51}, .135}};
    const std::vector<TubeNode> middle{{{.145, .34, .01}, .2},
                                       {{.15, .62, .06}, .19},
                                       {{.15, .79, .23}, .18},
                                       {{.15, .8, .46}, .175},
                                       {{.15, .63, .62}, .165},
                                       {{.15, .46, .62}, .135}};
    const std::vector<TubeNode> first{{{.42, .32, 0}, .2},
                                      {{.45, .58, 0}, .19},
                                      {{.47, .8, .01}, .18},
                                      {{.485, .98, .04}, .17},
                                      {{.495, 1.13, .08}, .16},
                                      {{.5, 1.24, .12}, .12}};
    const std::vector<TubeNode> thumb{{{.62, -.46, .1}, .28},
                                      {{.74, -.28, .24}, .25},
                                      {{.74, -.08, .42}, .22},
                                      {{.62, .06, .58}, .2},
                                      {{.44, .12, .7}, .18},
                                      {{.32, .12, .76}, .13}};
    pull(cage, first_finger, little);
    pull(cage, first_finger + 1, ring);
    pull(cage, first_finger + 2, middle);
    pull(cage, first_finger + 3, first);
    pull(cage, 3 * 10 + 4, thumb);  // the side of the palm at +x
    return cage;
}

/// A toy bear that sits: arms before the belly, legs before the body.
Cage bear_cage() {
    const Ring rings[] = {octagon({0, 0, 0}, {.6, .56}),
                          octagon({0, .4, 0}, {.8, .72}),
                          octagon({0, .9, 0}, {.72, .62}),
                          octagon({0, 1.22, 0}, {.44, .42}),
                          octagon({0, 1.42, .04}, {.64, .58}),
                          octagon({0, 1.82, .06}, {.7, .64}),
                          octagon({0, 2.14, .02}, {.52, .48}),
                          octagon({0, 2.3, 0}, {.2, .2})};
    Cage cage = cage_of_rings(rings);
    for (const double side : {-1.0, 1.0}) {
        const auto at = [&](double x, double y, double z) { return glm::dvec3(side * x, y, z); };
        const std::vector<TubeNode> leg{{at(.6, .26, .7), .34},
                                        {at(.68, .2, 1), .32},
                                        {at(.7, .22, 1.25), .34},
                                        {at(.7, .4, 1.36), .26}};
        const std::vector<TubeNode> arm{{at(.76, 1, .42), .27},
                                        {at(.86, .86, .66), .25},
                                        {at(.66, .78, .9), .24},
                                        {at(.38, .8, .98), .2}};
        const std::vector<TubeNode> ear{
            {at(.62, 2.12, 0), .24}, {at(.72, 2.26, 0), .33}, {at(.76, 2.34, 0), .26}};
        pull(cage, face_at(0, side < 0 ? front_left : front_right), leg);
        pull(cage, face_at(2, side < 0 ? front_left : front_right), arm);
        pull(cage, face_at(5, side < 0 ? left : right), ear);
    }
    const std::vector<TubeNode> snout{{{0, 1.58, .74}, .3}, {{0, 1.56, .88}, .24}};
    pull(cage, face_at(4, front), snout);
    return cage;
}

/// -1..1, another number for each `n`: MurmurHash3's finaliser, so no generator to seed.
double noise(std::uint32_t n) {
    n = (n ^ (n >> 16)) * 0x85ebca6bU;
    n = (n ^ (n >> 13)) * 0xc2b2ae35U;
    return static_cast<double>(n ^ (n >> 16)) / 0x7fffffff - 1;
}

/// Smooth noise of one unit between its nodes: trilinear, eased so that its slope goes on.
double smooth_noise(const glm::dvec3& p) {
    const glm::dvec3 low = glm::floor(p);
    const glm::dvec3 t = p - low;
    const glm::dvec3 ease = t * t * (3.0 - 2.0 * t);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step{corner & 1, corner >> 1 & 1, corner >> 2 & 1};
        const glm::dvec3 share = glm::mix(1.0 - ease, ease, glm::dvec3(step));
        const glm::uvec3 node(glm::ivec3(low) + step);  // products wrap
        const std::uint32_t key = node.x * 73856093U ^ node.y * 19349663U ^ node.z * 83492791U;
        sum += share.x * share.y * share.z * noise(key);
    }
    return sum;
}

/// `mesh` as a scanner sees it: worn and lumpy, every vertex a little off along its normal, holes
/// where the scanner did not look.
scene::Mesh scanned(scene::Mesh mesh) {
    std::vector<glm::dvec3> normals(mesh.positions.size(), glm::dvec3(0));
    for (const scene::Triangle& triangle : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[triangle[0]]);
        const glm::dvec3 b(mesh.positions[triangle[1]]);
        const glm::dvec3 c(mesh.positions[triangle[2]]);
        for (const auto corner : triangle)
            normals[corner] += glm::cross(b - a, c - a);
    }
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p(mesh.positions[i]);
        const double off = 0.012 * smooth_noise(p * 9.0) + 0.006 * smooth_noise(p * 27.0) +
                           0.0007 * noise(i) + 0.0006 * noise(i + 0x9e3779b9U);
        mesh.positions[i] = snapped(p + glm::normalize(normals[i]) * off);
    }
    // Under the body and in the folds behind the arms.
    constexpr std::array<glm::dvec4, 4> kHoles{
        {{0, 0, 0, .4}, {.7, .62, .48, .12}, {-.7, .64, .46, .13}, {-.5, 2.1, -.25, .08}}};
    std::erase_if(mesh.triangles, [&](const scene::Triangle& triangle) {
        const glm::dvec3 p(mesh.positions[triangle[0]]);
        for (const glm::dvec4& hole : kHoles) {
            if (glm::distance(p, glm::dvec3(hole)) < hole.w) return true;
        }
        return false;
    });
    return mesh;
}

}  // namespace

scene::Scene make_octopus_scene() {
    Stage stage;
    stage.add("octopus", subdivided(octopus_cage(), 3));
    const auto eye = stage.mesh("eye", make_sphere(0.11, 24, 14));
    for (const double side : {-1.0, 1.0})
        stage.place(eye, "eye", Pose{{side * 0.24, 0.72, 0.36}, {0, 24 * side, 0}, {1, 1.25, .8}});
    return stage.finish({{"front", 0, 10}, {"three_quarter", 34, 28}},
                        {{"close", {2.25, 0.75, 2.75}, {0, 0.625, 0}, 40}});
}

scene::Scene make_hand_scene() {
    Stage stage;
    stage.add("hand", subdivided(hand_cage(), 3));
    return stage.finish({{"front", 8, 4}, {"three_quarter", 46, 16}, {"above", -30, 58}});
}

scene::Scene make_scan_scene() {
    Stage stage;
    stage.add("bear", scanned(subdivided(bear_cage(), 5)));
    return stage.finish({{"front", 0, 8}, {"three_quarter", 40, 18}, {"behind", -128, 30}});
}

}  // namespace ink::catalogue
