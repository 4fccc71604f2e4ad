#include "catalogue/catalogue.h"

#include <algorithm>

#include "catalogue/catalogue_scenes.h"
#include "core/error.h"
#include "core/param.h"
#include "scene/animation.h"

namespace ink::catalogue {
namespace {

struct Made {
    const char* name;
    const char* kind;
    const char* summary;
    scene::Scene (*build)();
};

// Both splits hold smooth, creased, cluttered and interpenetrating scenes and open surfaces; scenes
// that look alike (two heaps of cubes, two stairs) stand on the same side.
constexpr Made kTraining[] = {
    {"sphere", "shape", "one ball: its outline is one closed contour", make_sphere_scene},
    {"balls",
     "shape",
     "a pile of balls that do not touch: contours behind contours",
     make_balls_scene},
    {"torus", "shape", "one ring: contours that end inside the surface", make_torus_scene},
    {"cube", "shape", "one cube on its face, its edge and its corner", make_cube_scene},
    {"cylinder",
     "shape",
     "cylinders, a prism and a washer: creases beside smooth sides",
     make_cylinder_scene},
    {"cone", "shape", "cones, a pyramid and a frustum: tips and slanted sides", make_cone_scene},
    {"blocks", "shape", "five boxes driven through each other", make_blocks_scene},
    {"horizon",
     "shape",
     "rows of cubes that shrink below a pixel towards the horizon",
     make_horizon_scene},
    {"tiles",
     "shape",
     "coplanar tiles that abut exactly (seams), some missing, some raised",
     make_tiles_scene},
    {"layers", "shape", "pairs of parallel sheets from 1/8 down to 8e-6 apart", make_layers_scene},
    {"hills", "shape", "a rolling open surface that hides parts of itself", make_hills_scene},
    {"soup",
     "prop",
     "a ring of unwelded triangles with hairline cracks, and a ball in pieces",
     make_soup_scene},
    {"gear",
     "assembly",
     "two gears in mesh that turn, hub, shafts and bolts: many short creases",
     make_gear_scene},
    {"figure",
     "character",
     "a person of ellipsoids and mirrored limbs, hands sunk into the hips",
     make_figure_scene},
    {"octopus",
     "character",
     "a smooth body whose eight arms pass before it and each other",
     make_octopus_scene},
    {"scan",
     "scan",
     "a toy bear as a scanner sees it: noise, holes, triangles of a pixel",
     make_scan_scene},
    {"truss", "thin", "a space frame of bars a few pixels wide", make_truss_scene},
    {"bracket",
     "part",
     "machined parts with fillets: smooth bends between few creases",
     make_bracket_scene},
};
constexpr Made kHeldOut[] = {
    {"teapot",
     "furniture",
     "Newell's 32 patches: smooth, open at rim, lid and spout",
     make_teapot_scene},
    {"rocket",
     "vehicle",
     "eight-sided, three fins: 150 edges, as in the old demos",
     make_rocket_scene},
    {"gem",
     "shape",
     "cut stones: edges just below and just above the crease angle",
     make_gem_scene},
    {"crystals", "shape", "six-sided crystals that grow through each other", make_crystals_scene},
    {"letters",
     "shape",
     "three thick letters: creases, flat faces, concave corners",
     make_letters_scene},
    {"knot", "shape", "a trefoil tube that passes behind itself", make_knot_scene},
    {"chess",
     "furniture",
     "turned pieces on a board of blocks: curves before clutter",
     make_chess_scene},
    {"flag",
     "shape",
     "an open cloth in waves: boundaries and contours on both sides",
     make_flag_scene},
    {"tree", "foliage", "branches that pierce the trunk and come out behind it", make_tree_scene},
    {"staircase",
     "architecture",
     "a flight, a landing and a parapet: parallel creases at grazing angles",
     make_staircase_scene},
    {"spiral",
     "architecture",
     "a spiral stair: steps let into a column, rods, a handrail",
     make_spiral_scene},
    {"fence", "thin", "a picket fence: thin things before thin things", make_fence_scene},
    {"room",
     "architecture",
     "a room and what its window shows: lines from 0.2 to 16 000 away",
     make_room_scene},
    {"hand", "character", "a hand that points, fingers before the palm", make_hand_scene},
    {"drapery",
     "shape",
     "a cloth over a round table, in folds that hide themselves",
     make_drapery_scene},
    {"globe", "shape", "a ball of a million triangles, most below a pixel", make_globe_scene},
    {"bush",
     "foliage",
     "two hundred leaves on twigs: open sheets before each other",
     make_bush_scene},
    {"bars", "thin", "bars .05 to .2 px wide before a panel", make_bars_scene},
};

}  // namespace

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
    static const std::vector<CatalogueEntry> entries = [] {
        std::vector<CatalogueEntry> all;
        for (const Made& made : kTraining)
            all.push_back({made.name, scene::Split::train, made.kind, made.summary, made.build});
        for (const Made& made : kHeldOut)
            all.push_back({made.name, scene::Split::heldout, made.kind, made.summary, made.build});
        return all;
    }();
    return entries;
}

scene::Scene make_catalogue_scene(const std::string& name) {
    const auto& entries = catalogue();
    const auto found = std::ranges::find(entries, name, &CatalogueEntry::name);
    if (found != entries.end()) return found->make();
    std::vector<std::string> names;
    for (const auto& entry : entries)
        names.push_back(entry.name);
    throw core::Error(
        "scene", "there is none called '" + name + "'", core::known_names(names, name));
}

}  // namespace ink::catalogue
