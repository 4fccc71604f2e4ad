#include "catalogue/catalogue.h"

#include "core/error.h"
#include "core/named.h"
#include "core/param.h"
#include "scene/animation.h"

// A line for each scene: its name, of what kind of thing it is, and a summary. Its maker is
// make_NAME_scene(), which gives it cameras and lights. Both splits hold smooth, creased, cluttered
// and interpenetrating scenes and open surfaces; scenes that look alike (two heaps of cubes, two
// stairs) stand on the same side.
// clang-format off
#define INK_TRAINING(X) \
    X(sphere, "shape", "one ball: its outline is one closed contour") \
    X(balls, "shape", "a pile of balls that do not touch: contours behind contours") \
    X(torus, "shape", "one ring: contours that end inside the surface") \
    X(cube, "shape", "one cube on its face, its edge and its corner") \
    X(cylinder, "shape", "cylinders, a prism and a washer: creases beside smooth sides") \
    X(cone, "shape", "cones, a pyramid and a frustum: tips and slanted sides") \
    X(blocks, "shape", "five boxes driven through each other") \
    X(horizon, "shape", "rows of cubes that shrink below a pixel towards the horizon") \
    X(tiles, "shape", "coplanar tiles that abut exactly (seams), some missing, some raised") \
    X(layers, "shape", "pairs of parallel sheets from 1/8 down to 8e-6 apart") \
    X(hills, "shape", "a rolling open surface that hides parts of itself") \
    X(soup, "prop", "a ring of unwelded triangles with hairline cracks, and a ball in pieces") \
    X(gear, "assembly", "two gears in mesh that turn, hub, shafts and bolts: many short creases") \
    X(figure, "character", "a person of ellipsoids and mirrored limbs, hands sunk into the hips") \
    X(octopus, "character", "a smooth body whose eight arms pass before it and each other") \
    X(scan, "scan", "a toy bear as a scanner sees it: noise, holes, triangles of a pixel") \
    X(truss, "thin", "a space frame of bars a few pixels wide") \
    X(bracket, "part", "machined parts with fillets: smooth bends between few creases")
#define INK_HELD_OUT(X) \
    X(teapot, "furniture", "Newell's 32 patches: smooth, open at rim, lid and spout") \
    X(rocket, "vehicle", "eight-sided, three fins: 150 edges, as in the old demos") \
    X(gem, "shape", "cut stones: edges just below and just above the crease angle") \
    X(crystals, "shape", "six-sided crystals that grow through each other") \
    X(letters, "shape", "three thick letters: creases, flat faces, concave corners") \
    X(knot, "shape", "a trefoil tube that passes behind itself") \
    X(chess, "furniture", "turned pieces on a board of blocks: curves before clutter") \
    X(flag, "shape", "an open cloth in waves: boundaries and contours on both sides") \
    X(tree, "foliage", "branches that pierce the trunk and come out behind it") \
    X(staircase, "architecture", \
      "a flight, a landing and a parapet: parallel creases at grazing angles") \
    X(spiral, "architecture", "a spiral stair: steps let into a column, rods, a handrail") \
    X(fence, "thin", "a picket fence: thin things before thin things") \
    X(room, "architecture", "a room and what its window shows: lines from 0.2 to 16 000 away") \
    X(hand, "character", "a hand that points, fingers before the palm") \
    X(drapery, "shape", "a cloth over a round table, in folds that hide themselves") \
    X(globe, "shape", "a ball of a million triangles, most below a pixel") \
    X(bush, "foliage", "two hundred leaves on twigs: open sheets before each other") \
    X(bars, "thin", "bars .05 to .2 px wide before a panel")
// clang-format on

namespace ink::catalogue {

#define INK_DECLARE(name, kind, summary) scene::Scene make_##name##_scene();
INK_TRAINING(INK_DECLARE)
INK_HELD_OUT(INK_DECLARE)
#undef INK_DECLARE

scene::Scene CatalogueEntry::make() const {
    scene::Scene scene = build();
    scene.name = name;
    scene.split = split;
    scene.kind = kind;
    scene::check_scene(scene);
    if (scene.animation) scene::check_animation(scene, *scene.animation);
    return scene;
}

const std::vector<CatalogueEntry>& catalogue() {
    using enum scene::Split;
#define INK_TRAIN(name, kind, summary) {#name, train, kind, summary, make_##name##_scene},
#define INK_HOLD_OUT(name, kind, summary) {#name, heldout, kind, summary, make_##name##_scene},
    static const std::vector<CatalogueEntry> entries = {INK_TRAINING(INK_TRAIN)
                                                            INK_HELD_OUT(INK_HOLD_OUT)};
    return entries;
#undef INK_TRAIN
#undef INK_HOLD_OUT
}

scene::Scene make_catalogue_scene(const std::string& name) {
    const auto& entries = catalogue();
    if (const CatalogueEntry* found = core::find_named(entries, name)) return found->make();
    throw core::Error("scene",
                      "there is none called '" + name + "'",
                      core::known_names(core::names_of(entries), name));
}

}  // namespace ink::catalogue
