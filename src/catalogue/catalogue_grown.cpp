
#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"

namespace ink::catalogue {
namespace {

scene::Mesh limb(std::span<const TubeNode> nodes, int cuts, int segments) {
    return make_tube(smoothed(nodes, cuts), segments);
}

/// A branch along +x that starts 1 behind the origin, so that it comes out of the trunk's far side.
scene::Mesh branch(double length, double rise) {
    const auto at = [&](double share, double sway) {
        const double out = (length + 1) * share;
        return glm::dvec3(out - 1, rise * share * share - 0.15, sway);
    };
    const std::vector<TubeNode> bough{{at(0, 0.1), 0.015},
                                      {at(0.15, 0.04), 0.07},
                                      {at(0.35, 0), 0.115},
                                      {at(0.65, -0.06), 0.075},
                                      {at(1, 0.05), 0.02}};
    scene::Mesh whole = make_tube(smoothed(bough, 5), 12);
    for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 from = at(0.68 + 0.1 * side, -0.04);
        const std::vector<TubeNode> twig{{from - glm::dvec3(0.08, 0.05, 0.1 * side), 0.04},
                                         {from + glm::dvec3(0.3, 0.25, 0.25 * side), 0.03},
                                         {from + glm::dvec3(0.55, 0.6, 0.45 * side), 0.012}};
        append(whole, make_tube(smoothed(twig, 5), 8));
    }
    return whole;
}

/// A leaf of one sheet in the plane of x and z that points along +z, 0.28 long, hollow along its
/// rib and bent down by `droop` at its tip.
scene::Mesh leaf(double droop) {
    std::vector<Ring> rows{{{0, 0, 0}}};
    for (const auto& [along, half] : {std::pair{.06, .035}, {.12, .06}, {.18, .055}, {.24, .028}}) {
        const double height = -droop * along * along / 0.28;
        rows.push_back({{-half, height + 0.2 * half, along},
                        {0, height, along},
                        {half, height + 0.2 * half, along}});
    }
    rows.push_back({{0, -droop * 0.28, 0.28}});
    return loft(rows, {.around = false});
}

/// One person, looking along +z, feet on y = 0, 1.9 tall with the hat.
class Person {
  public:
    explicit Person(Stage& stage)
        : stage_(stage),
          ball_(stage.mesh("ball", make_sphere(1, 24, 14))),
          neck_(stage.mesh("neck", limb(kNeck, 2, 16))),
          nose_(stage.mesh("nose", make_cone(0.035, 0.1, 10))),
          hat_(stage.mesh("hat", revolve(kHat, 32))),
          arm_(stage.mesh("arm", limb(kArm, 6, 16))),
          leg_(stage.mesh("leg", limb(kLeg, 6, 18))) {}

    void stand(const glm::dmat4& world_from_person) {
        const auto place = [&](std::uint32_t mesh, const char* name, const Pose& pose = {}) {
            stage_.place(mesh, name, world_from_person * placed(pose));
        };
        place(ball_, "chest", {{0, 1.24, 0}, {}, {0.24, 0.26, 0.15}});
        place(ball_, "hips", {{0, 0.92, 0}, {}, {0.2, 0.19, 0.14}});
        place(ball_, "head", {{0, 1.72, 0.02}, {}, {0.125, 0.16, 0.14}});
        place(neck_, "neck");
        place(nose_, "nose", {{0, 1.7, 0.145}, {80, 0, 0}});
        place(hat_, "hat", {{0, 1.8, 0.01}, {-8, 0, 0}});
        for (const double side : {1.0, -1.0}) {
            place(arm_, "arm", {{}, {}, {side, 1, 1}});
            place(leg_, "leg", {{}, {}, {side, 1, 1}});
            // The hand rests half inside the hip.
            place(ball_, "hand", {{0.17 * side, 0.97, 0.1}, {}, {side * 0.07, 0.045, 0.05}});
            place(ball_, "foot", {{0.15 * side, 0.045, 0.06}, {}, {side * 0.06, 0.045, 0.14}});
        }
    }

  private:
    static constexpr glm::dvec2 kHat[] = {
        {0, 0}, {.26, -.02}, {.27, 0}, {.14, .035}, {.12, .2}, {.1, .22}, {0, .23}};
    static constexpr TubeNode kNeck[] = {{{0, 1.4, 0}, 0.07}, {{0, 1.62, 0}, 0.065}};
    static constexpr TubeNode kArm[] = {{{0.16, 1.38, 0}, 0.07},
                                        {{0.27, 1.34, -0.01}, 0.075},
                                        {{0.5, 1.1, -0.06}, 0.055},
                                        {{0.3, 0.98, 0.07}, 0.04},
                                        {{0.2, 0.97, 0.09}, 0.035}};
    static constexpr TubeNode kLeg[] = {
        {{0.09, 0.9, 0}, 0.11}, {{0.12, 0.5, 0.03}, 0.075}, {{0.14, 0.06, 0}, 0.05}};

    Stage& stage_;
    std::uint32_t ball_;
    std::uint32_t neck_;
    std::uint32_t nose_;
    std::uint32_t hat_;
    std::uint32_t arm_;
    std::uint32_t leg_;
};

}  // namespace

scene::Scene make_figure_scene() {
    Stage stage;
    Person person(stage);
    person.stand(placed({{-1.1875, 0, -0.125}, {0, 34, 0}}));
    person.stand(placed({{0, 0, 0.125}, {0, -8, 0}}));
    person.stand(placed({{1.1875, 0, -0.125}, {0, -62, 0}}));
    return stage.finish({{"front", 0, 2}, {"three_quarter", 24, 14}},
                        {{"close", {0.5625, 1.4375, 1.875}, {0, 1.25, 0}, 44}});
}

scene::Scene make_tree_scene() {
    Stage stage;
    const TubeNode trunk[] = {{{0, 0, 0}, 0.5},
                              {{0.02, 0.5, 0}, 0.3},
                              {{0.1, 1.25, 0.05}, 0.25},
                              {{-0.05, 2.2, -0.05}, 0.19},
                              {{0.1, 3.2, 0}, 0.11},
                              {{0.05, 4, 0.08}, 0.03}};
    stage.add("trunk", limb(trunk, 8, 24));
    const std::uint32_t meshes[] = {stage.mesh("long", branch(3, 0.8)),
                                    stage.mesh("middle", branch(2.3, 1)),
                                    stage.mesh("short", branch(1.4, 0.8))};
    for (int i = 0; i < 15; ++i) {
        const Pose pose{{0.02, 1.2 + 0.16 * i, 0}, {0, 137.508 * i + 8, 8.0 - 1.5 * (i % 4)}};
        stage.place(meshes[i / 5], "branch", pose);
    }
    const TubeNode root[] = {
        {{0, 0.35, 0}, 0.16}, {{0.45, 0.12, 0.03}, 0.11}, {{0.95, -0.02, -0.04}, 0.03}};
    const auto root_mesh = stage.mesh("root", limb(root, 5, 10));
    for (int i = 0; i < 6; ++i) {
        stage.place(root_mesh, "root", Pose{{}, {0, 60.0 * i + 11, 0}});
    }
    return stage.finish({{"front", 0, 2}, {"three_quarter", 40, 20}},
                        {{"trunk", {1.75, 1.125, 3.25}, {0, 1.75, 0}, 50}});
}

scene::Scene make_bush_scene() {
    Stage stage;
    const std::uint32_t leaves[] = {stage.mesh("leaf", leaf(0.16)), stage.mesh("leaf", leaf(0.3))};
    const TubeNode stem[] = {
        {{0, -0.3, 0}, .05}, {{.02, .1, 0}, .04}, {{-.02, .7, .03}, .025}, {{0, 1.15, 0}, .01}};
    stage.add("stem", limb(stem, 5, 12));
    for (int i = 0; i < 16; ++i) {
        // Twigs leave the stem on the golden angle, the lower ones longer and flatter.
        const double share = i / 15.0;
        const double reach = 1.05 - 0.65 * share;
        const TubeNode twig[] = {{{0, 0, 0}, .02},
                                 {{reach * .4, .1, .05}, .016},
                                 {{reach * .8, .32, -.04}, .012},
                                 {{reach, .55, 0}, .005}};
        const std::vector<TubeNode> path = smoothed(twig, 6);
        const glm::dmat4 at = placed({{0, 0.1 + 0.9 * share, 0}, {0, 137.508 * i, 18 * share}});
        stage.add_at(at, "twig", make_tube(path, 8));
        int k = i;
        for (std::size_t node = 5; node < path.size(); node += 2) {
            for (const double side : {-1.0, 1.0}) {
                const Pose pose{
                    path[node].center,
                    {side * (50 + 7 * (k % 5)), 20.0 * side * (k % 3) - 15, 12.0 * (k % 4) - 10},
                    glm::dvec3(0.75 + 0.08 * (k % 4))};
                stage.place(leaves[k % 2], "leaf", at * placed(pose));
                ++k;
            }
        }
    }
    return stage.finish({{"three_quarter", 40, 30}},
                        {{"close", {1.125, 1.25, 2}, {0.125, 0.75, 0}, 44}});
}

}  // namespace ink::catalogue
