
#include "catalogue/catalogue_stage.h"
#include "catalogue/shapes.h"

// What stands on something keeps 1/64 of air below it (1/128 in the room): a foot in the very plane
// of its floor would leave the line there to rounding.

namespace ink::catalogue {
namespace {

/// A flight's profile: `steps` of `run` by `rise`, its underside a slope of its own.
std::vector<glm::dvec2> flight_outline(int steps, double run, double rise) {
    std::vector<glm::dvec2> outline{{0, 0}, {run, 0}, {steps * run, (steps - 1) * rise}};
    for (int i = steps; i > 0; --i) {
        outline.emplace_back(i * run, i * rise);
        outline.emplace_back((i - 1) * run, i * rise);
    }
    return outline;
}

/// A rectangle of the plane at `z`, counter-clockwise seen from +z: rings of it that go back show
/// their fronts inwards.
Ring rectangle(const glm::dvec2& low, const glm::dvec2& high, double z) {
    return {{low.x, low.y, z}, {high.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}};
}

/// A room seen from inside, 5 by 2.75 by 6, with a window in its far wall and the window's reveal.
scene::Mesh room_shell() {
    const glm::dvec2 window_low{-1.25, 0.875};
    const glm::dvec2 window_high{1.25, 2.25};
    const Ring rings[] = {{{0, 1.375, 3}},
                          rectangle({-2.5, 0}, {2.5, 2.75}, 3),
                          rectangle({-2.5, 0}, {2.5, 2.75}, -3),
                          rectangle(window_low, window_high, -3),
                          rectangle(window_low, window_high, -3.25)};
    return loft(rings);
}

void add_table(Stage& stage) {
    stage.add("table", make_box({-1, 0.75, -1.5}, {1, 0.8125, 0.25}));
    const auto leg =
        stage.mesh("table_leg", make_box({-0.04, 0.0078125, -0.04}, {0.04, 0.78, 0.04}));
    for (const auto& [x, z] : {std::pair{-0.9, -1.4}, {0.9, -1.4}, {-0.9, 0.15}, {0.9, 0.15}}) {
        stage.place(leg, "table_leg", Pose{{x, 0, z}});
    }
}

void add_chair(Stage& stage, const Pose& pose) {
    const glm::dmat4 world_from_chair = placed(pose);
    stage.add_at(world_from_chair, "seat", make_box({-0.23, 0.44, -0.23}, {0.23, 0.48, 0.23}));
    stage.add_at(world_from_chair, "back", make_box({-0.2, 0.7, 0.205}, {0.2, 1, 0.225}));
    for (const double x : {-0.21, 0.21}) {
        stage.add_at(world_from_chair,
                     "chair_leg",
                     make_box({x - 0.018, 0.0078125, -0.22}, {x + 0.018, 0.46, -0.184}));
        stage.add_at(world_from_chair,
                     "chair_post",
                     make_box({x - 0.018, 0.0078125, 0.194}, {x + 0.018, 1.02, 0.229}));
    }
}

/// Against the right wall: a back, four boards between two sides, books on each board.
void add_bookcase(Stage& stage) {
    const auto world_from_case = placed({{2.25, 0.0078125, 1.25}, {0, -90, 0}});
    stage.add_at(world_from_case, "case_back", make_box({-0.58, 0.02, -0.23}, {0.58, 1.88, -0.22}));
    stage.add_at(world_from_case, "case_side", make_box({-0.62, 0, -0.24}, {-0.59, 1.9, 0.08}));
    stage.add_at(world_from_case, "case_side", make_box({0.59, 0, -0.24}, {0.62, 1.9, 0.08}));
    for (int board = 0; board < 5; ++board) {
        const double y = 0.08 + 0.44 * board;
        stage.add_at(
            world_from_case, "case_board", make_box({-0.6, y, -0.21}, {0.6, y + 0.025, 0.07}));
        double x = -0.56;
        for (int i = 0; i < 9 && board < 4; ++i) {
            const int kind = (5 * i + 7 * board) % 4;
            const double height = 0.25 + 0.035 * kind;
            const double width = 0.06 + 0.02 * ((i + board) % 3);
            const double depth = 0.02 * ((2 * i + board) % 3);
            stage.add_at(world_from_case,
                         "book",
                         make_box({x, y + 0.03, -0.2}, {x + width, y + 0.03 + height, depth}));
            x += width + 0.012 + (kind == 3 ? 0.09 : 0.0);
        }
    }
}

/// What lies on the table, its top at 0.8125: a cup, a pencil, an orange.
void add_still_life(Stage& stage) {
    const glm::dvec2 cup[] = {{0, 0},
                              {.03, 0},
                              {.034, .006},
                              {.04, .05},
                              {.042, .1},
                              {.038, .1},
                              {.036, .05},
                              {.03, .01},
                              {0, .008}};
    const glm::dvec3 cup_at{0.2, 0.8203125, -0.45};
    stage.add("cup", revolve(cup, 40), {cup_at});
    const std::vector<TubeNode> ear{{{0.036, 0.085, 0}, 0.006},
                                    {{0.068, 0.08, 0}, 0.006},
                                    {{0.066, 0.045, 0}, 0.006},
                                    {{0.035, 0.03, 0}, 0.006}};
    stage.add("cup_ear", make_tube(smoothed(ear, 6), 12), {cup_at, {0, -25, 0}});
    const glm::dvec2 pencil[] = {{0, 0}, {.004, 0}, {.004, .15}, {0, .17}};
    stage.add("pencil", revolve(pencil, 6), {{-0.15, 0.826, -0.35}, {0, 40, 90}});
    const auto orange = stage.mesh("orange", make_icosphere(0.04, 3));
    stage.place(orange, "orange", Pose{{-0.5, 0.8625, -0.5}});
    stage.place(orange, "orange", Pose{{-0.41, 0.8625, -0.53}, {20, 40, 0}});
    stage.add("book",
              make_box({-0.09, 0, -0.13}, {0.09, 0.03, 0.13}),
              {{-0.05, 0.8203125, -0.6}, {0, 24, 0}});
    stage.add("book",
              make_box({-0.075, 0, -0.1}, {0.075, 0.02, 0.1}),
              {{-0.04, 0.859375, -0.61}, {0, -14, 0}});
}

/// Below and beyond the window, out to 20 000.
void add_landscape(Stage& stage) {
    stage.add("ground", make_sheet({-20000, -8, -4}, {40000, 0, 0}, {0, 0, -20000}));
    const auto tower = stage.mesh("tower", make_box({-0.5, 0, -0.5}, {0.5, 1, 0.5}));
    const glm::dvec3 places[] = {{-14, 0, -30},
                                 {9, 0, -55},
                                 {-30, 0, -140},
                                 {60, 0, -260},
                                 {-150, 0, -600},
                                 {40, 0, -900},
                                 {380, 0, -1500},
                                 {-700, 0, -2600},
                                 {-120, 0, -4200},
                                 {1500, 0, -6000}};
    int i = 0;
    for (const auto& at : places) {
        const double size = -0.12 * at.z * (1 + 0.2 * (i % 3));
        const Pose pose{{at.x, -7.5, at.z}, {0, 17.0 * i, 0}, {size * 0.4, size * 1.4, size * 0.4}};
        stage.place(tower, "tower", pose);
        ++i;
    }
    const auto mountain = stage.mesh("mountain", make_cone(1, 1, 7));
    for (int k = 0; k < 5; ++k) {
        const glm::dvec3 at{3600.0 * k - 7400, -20, -15500.0 + 900 * (k % 3)};
        const double height = 1600.0 + 500 * (k % 2);
        stage.place(mountain, "mountain", Pose{at, {0, 31.0 * k, 0}, {2600, height, 2600}});
    }
}

}  // namespace

scene::Scene make_horizon_scene() {
    Stage stage;
    stage.add("ground", make_box({-64, -1, -420}, {64, -0.015625, 24}));
    const auto cube = stage.mesh("cube", make_box({-0.5, 0, -0.5}, {0.5, 1, 0.5}));
    for (int row = 0; row < 64; ++row) {
        for (int column = -6; column <= 6; ++column) {
            stage.place(cube, "cube", Pose{{2.5 * column, 0, -2.5 * row}});
        }
    }
    return stage.finish({},
                        {{"front", {1.25, 1.75, 5}, {1.25, 1, 0}, 50},
                         {"three_quarter", {12, 7, 10}, {-2, 0, -12}, 45},
                         {"grazing", {3.125, 0.625, 4.5}, {-1, 0.5, -12}, 50}});
}

scene::Scene make_staircase_scene() {
    Stage stage;
    stage.add("flight", extrude(flight_outline(12, 0.375, 0.25), {-1, 1}));
    stage.add("landing", make_box({4.515625, 2.75, -1}, {6.5, 3, 1}));
    stage.add("pillar", make_box({5.25, 0, -0.375}, {5.75, 2.734375, 0.375}));
    const glm::dvec2 parapet[] = {{0, 0}, {0.375, 0}, {4.5, 2.75}, {4.5, 3.75}, {0, 0.75}};
    stage.add("parapet", extrude(parapet, {-1.265625, -1.015625}));
    // From this height some treads are seen edge-on, those below from above, those above not at
    // all.
    return stage.finish({{"front", -72, 18}, {"three_quarter", -42, 24}},
                        {{"grazing", {-3, 1.5, 4.5}, {2.625, 1.625, -0.5}, 42}});
}

scene::Scene make_spiral_scene() {
    Stage stage;
    stage.add("column", make_cylinder(0.25, 3.5, 24));
    const glm::dvec2 wedge[] = {{0.2, -0.06}, {2.25, -0.45}, {2.25, 0.45}, {0.2, 0.06}};
    const scene::Mesh step = moved(extrude(wedge, {0, 0.1}), placed({{}, {-90, 0, 0}}));
    const auto step_mesh = stage.mesh("step", step);
    const auto rod_mesh = stage.mesh("rod", make_cylinder(0.03, 0.8, 12));
    std::vector<TubeNode> rail;
    for (int i = 0; i < 14; ++i) {
        const glm::dmat4 pose = placed({{0, 0.15 + 0.2 * i, 0}, {0, 24.0 * i - 100, 0}});
        stage.place(step_mesh, "step", pose);
        stage.place(rod_mesh, "rod", pose * placed({{2.1, 0.05, 0}}));
        rail.push_back({glm::dvec3(pose * glm::dvec4(2.1, 0.85, 0, 1)), 0.05});
    }
    stage.add("rail", make_tube(smoothed(rail, 4), 12));
    return stage.finish({{"front", 0, 6}, {"three_quarter", 50, 28}},
                        {{"below", {3.25, 0.5, 2.75}, {0, 1.75, 0}, 58}});
}

scene::Scene make_fence_scene() {
    Stage stage;
    const glm::dvec2 outline[] = {{-.06, 0}, {.06, 0}, {.06, 1.05}, {0, 1.2}, {-.06, 1.05}};
    const auto picket = stage.mesh("picket", extrude(outline, {0, 0.03}));
    const auto post = stage.mesh("post", make_box({-.06, -.1, -.16}, {.06, 1.1, -.05}));
    const auto rail = stage.mesh("rail", make_box({-2.2, -.05, -.04}, {2.2, .05, -.015625}));
    // Two runs that meet at a corner; the rails hang 1/64 behind the pickets.
    for (const auto& run : {placed({{-2.25, 0, 0}}), placed({{0.1, 0, -2.2}, {0, 90, 0}})}) {
        for (int i = 0; i < 21; ++i) {
            stage.place(picket, "picket", run * placed({{0.21 * i - 2.1, 0, 0}}));
        }
        for (const double y : {0.3, 0.85})
            stage.place(rail, "rail", run * placed({{0, y, 0}}));
        for (const double x : {-2.0, 0.0, 2.0})
            stage.place(post, "post", run * placed({{x, 0, 0}}));
    }
    return stage.finish({{"front", -8, 6}, {"three_quarter", 42, 16}},
                        {{"grazing", {-4.75, 1, 1.125}, {-1.25, 0.625, -0.25}, 46}});
}

scene::Scene make_room_scene() {
    Stage stage;
    stage.add("shell", room_shell());
    add_table(stage);
    add_chair(stage, {{-0.35, 0, 0.75}, {0, 24, 0}});
    add_chair(stage, {{1.4, 0, -0.7}, {0, 98, 0}});
    add_still_life(stage);
    const glm::dvec2 shade[] = {{0.3, 1.75}, {0.08, 2}, {0, 2}};
    stage.add("shade", revolve(shade, 32), {{0, 0, -0.6}});
    stage.add("cord", make_cylinder(0.008, 0.75, 8), {{0, 1.98, -0.6}});
    stage.add("image", make_box({-2.4921875, 1.2, -1.8}, {-2.453125, 2, -0.6}));
    stage.add("image", make_box({1.25, 1.1, 2.953125}, {2.1, 2.1, 2.9921875}));
    add_bookcase(stage);
    add_landscape(stage);
    stage.light({{0, 1.7, -0.6}, {1, 0.9375F, 0.75F}, 8});
    stage.light({{-3000, 9000, -1000}, glm::vec3(0.75F), 0});
    // The nearest line lies a hand's breadth from the eye, the farthest 16 km away.
    return stage.finish(
        {},
        {{"window", {-0.1875, 0.984375, 0.0625}, {0.015625, 0.984375, -1.5}, 56, 0.01},
         {"inside", {1.375, 1.75, 2.25}, {-0.4375, 0.9375, -1.25}, 62, 0.01},
         {"corner", {-2, 1.75, -2.25}, {0.5, 0.75, 0.25}, 62, 0.01}});
}

}  // namespace ink::catalogue
