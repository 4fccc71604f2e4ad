#pragma once

#include "scene/scene.h"

// The makers behind `catalogue()`: each returns its scene with cameras and lights, not yet named.

namespace ink::catalogue {

// Solids: catalogue_solids.cpp
[[nodiscard]] scene::Scene make_sphere_scene();
[[nodiscard]] scene::Scene make_globe_scene();
[[nodiscard]] scene::Scene make_balls_scene();
[[nodiscard]] scene::Scene make_torus_scene();
[[nodiscard]] scene::Scene make_cube_scene();
[[nodiscard]] scene::Scene make_cylinder_scene();
[[nodiscard]] scene::Scene make_cone_scene();
[[nodiscard]] scene::Scene make_blocks_scene();
[[nodiscard]] scene::Scene make_gem_scene();
[[nodiscard]] scene::Scene make_crystals_scene();

// Open surfaces: catalogue_sheets.cpp
[[nodiscard]] scene::Scene make_tiles_scene();
[[nodiscard]] scene::Scene make_layers_scene();
[[nodiscard]] scene::Scene make_hills_scene();
[[nodiscard]] scene::Scene make_soup_scene();
[[nodiscard]] scene::Scene make_flag_scene();
[[nodiscard]] scene::Scene make_drapery_scene();

// Made things: catalogue_things.cpp
[[nodiscard]] scene::Scene make_gear_scene();
[[nodiscard]] scene::Scene make_teapot_scene();
[[nodiscard]] scene::Scene make_rocket_scene();
[[nodiscard]] scene::Scene make_letters_scene();
[[nodiscard]] scene::Scene make_knot_scene();
[[nodiscard]] scene::Scene make_chess_scene();

// Grown things: catalogue_grown.cpp
[[nodiscard]] scene::Scene make_figure_scene();
[[nodiscard]] scene::Scene make_tree_scene();
[[nodiscard]] scene::Scene make_bush_scene();

// Smooth bodies: catalogue_bodies.cpp
[[nodiscard]] scene::Scene make_octopus_scene();
[[nodiscard]] scene::Scene make_hand_scene();
[[nodiscard]] scene::Scene make_scan_scene();

// Machined parts: catalogue_parts.cpp
[[nodiscard]] scene::Scene make_bracket_scene();

// Thin things: catalogue_sheets.cpp
[[nodiscard]] scene::Scene make_truss_scene();
[[nodiscard]] scene::Scene make_bars_scene();

// Places: catalogue_places.cpp
[[nodiscard]] scene::Scene make_horizon_scene();
[[nodiscard]] scene::Scene make_staircase_scene();
[[nodiscard]] scene::Scene make_spiral_scene();
[[nodiscard]] scene::Scene make_fence_scene();
[[nodiscard]] scene::Scene make_room_scene();

}  // namespace ink::catalogue
