#pragma once

#include "scene/scene.h"

// The makers behind `catalogue()`: each returns its scene with cameras and lights, not yet named.

namespace ink::scene {

// Solids: catalogue_solids.cpp
[[nodiscard]] Scene make_sphere_scene();
[[nodiscard]] Scene make_balls_scene();
[[nodiscard]] Scene make_torus_scene();
[[nodiscard]] Scene make_cube_scene();
[[nodiscard]] Scene make_cylinder_scene();
[[nodiscard]] Scene make_cone_scene();
[[nodiscard]] Scene make_blocks_scene();
[[nodiscard]] Scene make_gem_scene();
[[nodiscard]] Scene make_crystals_scene();

// Open surfaces: catalogue_sheets.cpp
[[nodiscard]] Scene make_tiles_scene();
[[nodiscard]] Scene make_layers_scene();
[[nodiscard]] Scene make_hills_scene();
[[nodiscard]] Scene make_soup_scene();
[[nodiscard]] Scene make_flag_scene();

// Made things: catalogue_things.cpp
[[nodiscard]] Scene make_gear_scene();
[[nodiscard]] Scene make_teapot_scene();
[[nodiscard]] Scene make_rocket_scene();
[[nodiscard]] Scene make_letters_scene();
[[nodiscard]] Scene make_knot_scene();
[[nodiscard]] Scene make_chess_scene();

// Grown things: catalogue_grown.cpp
[[nodiscard]] Scene make_figure_scene();
[[nodiscard]] Scene make_tree_scene();

// Places: catalogue_places.cpp
[[nodiscard]] Scene make_horizon_scene();
[[nodiscard]] Scene make_staircase_scene();
[[nodiscard]] Scene make_spiral_scene();
[[nodiscard]] Scene make_fence_scene();
[[nodiscard]] Scene make_room_scene();

}  // namespace ink::scene
