#include "catalogue/catalogue.h"

#include <algorithm>

#include "catalogue/catalogue_scenes.h"
#include "core/error.h"
#include "core/param.h"
#include "scene/animation.h"

namespace ink::catalogue {

scene::Scene CatalogueEntry::make() const {
    scene::Scene scene = build();
    scene.name = name;
    scene.split = split;
    scene::check_scene(scene);
    if (scene.animation) scene::check_animation(scene, *scene.animation);
    return scene;
}

// Both splits hold smooth, creased, cluttered and interpenetrating scenes and open surfaces; scenes
// that look alike (two heaps of cubes, two stairs) stand on the same side.
const std::vector<CatalogueEntry>& catalogue() {
    using enum scene::Split;
    static const std::vector<CatalogueEntry> entries = {
        {"sphere", train, "one ball: its outline is one closed contour", make_sphere_scene},
        {"balls",
         train,
         "a pile of balls that do not touch: contours behind contours",
         make_balls_scene},
        {"torus", train, "one ring: contours that end inside the surface", make_torus_scene},
        {"cube", train, "one cube on its face, its edge and its corner", make_cube_scene},
        {"cylinder",
         train,
         "cylinders, a prism and a washer: creases beside smooth sides",
         make_cylinder_scene},
        {"cone", train, "cones, a pyramid and a frustum: tips and slanted sides", make_cone_scene},
        {"blocks", train, "five boxes driven through each other", make_blocks_scene},
        {"horizon",
         train,
         "rows of cubes that shrink below a pixel towards the horizon",
         make_horizon_scene},
        {"tiles",
         train,
         "coplanar tiles that abut exactly (seams), some missing, some raised",
         make_tiles_scene},
        {"layers",
         train,
         "pairs of parallel sheets from 1/8 down to 8e-6 apart",
         make_layers_scene},
        {"hills", train, "a rolling open surface that hides parts of itself", make_hills_scene},
        {"soup",
         train,
         "a ring of unwelded triangles with hairline cracks, and a ball in pieces",
         make_soup_scene},
        {"gear",
         train,
         "two gears in mesh that turn, hub, shafts and bolts: many short creases",
         make_gear_scene},
        {"figure",
         train,
         "a person of ellipsoids and mirrored limbs, hands sunk into the hips",
         make_figure_scene},
        {"octopus",
         train,
         "a smooth body whose eight arms pass before it and each other",
         make_octopus_scene},
        {"scan",
         train,
         "a toy bear as a scanner sees it: noise, holes, triangles of a pixel",
         make_scan_scene},
        {"truss", train, "a space frame of bars a few pixels wide", make_truss_scene},
        {"bracket",
         train,
         "machined parts with fillets: smooth bends between few creases",
         make_bracket_scene},
        {"teapot",
         heldout,
         "Newell's 32 patches: smooth, open at rim, lid and spout",
         make_teapot_scene},
        {"rocket",
         heldout,
         "eight-sided, three fins: 150 edges, as in the old demos",
         make_rocket_scene},
        {"gem",
         heldout,
         "cut stones: edges just below and just above the crease angle",
         make_gem_scene},
        {"crystals",
         heldout,
         "six-sided crystals that grow through each other",
         make_crystals_scene},
        {"letters",
         heldout,
         "three thick letters: creases, flat faces, concave corners",
         make_letters_scene},
        {"knot", heldout, "a trefoil tube that passes behind itself", make_knot_scene},
        {"chess",
         heldout,
         "turned pieces on a board of blocks: curves before clutter",
         make_chess_scene},
        {"flag",
         heldout,
         "an open cloth in waves: boundaries and contours on both sides",
         make_flag_scene},
        {"tree", heldout, "branches that pierce the trunk and come out behind it", make_tree_scene},
        {"staircase",
         heldout,
         "a flight, a landing and a parapet: parallel creases at grazing angles",
         make_staircase_scene},
        {"spiral",
         heldout,
         "a spiral stair: steps let into a column, rods, a handrail",
         make_spiral_scene},
        {"fence", heldout, "a picket fence: thin things before thin things", make_fence_scene},
        {"room",
         heldout,
         "a room and what its window shows: lines from 0.2 to 16 000 away",
         make_room_scene},
        {"hand", heldout, "a hand that points, fingers before the palm", make_hand_scene},
        {"drapery",
         heldout,
         "a cloth over a round table, in folds that hide themselves",
         make_drapery_scene},
        {"globe", heldout, "a ball of a million triangles, most below a pixel", make_globe_scene},
        {"bush",
         heldout,
         "two hundred leaves on twigs: open sheets before each other",
         make_bush_scene},
        {"bars", heldout, "bars .05 to .2 px wide before a panel", make_bars_scene},
    };
    return entries;
}

scene::Scene make_catalogue_scene(const std::string& name) {
    const auto& entries = catalogue();
    const auto found = std::find_if(
        entries.begin(), entries.end(), [&](const auto& entry) { return entry.name == name; });
    if (found != entries.end()) return found->make();
    std::vector<std::string> names;
    for (const auto& entry : entries)
        names.push_back(entry.name);
    throw core::Error(
        "scene", "there is none called '" + name + "'", core::known_names(names, name));
}

}  // namespace ink::catalogue
