#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/suite/suite.h"

namespace ink::cli {

/// Says on stderr which axis is up in the views by name of a scene, unless that is y.
void print_up(const std::string& scene, harness::UpAxis up);

/// That, where views are by name, and what of a model's file does not count here.
void print_notes(const harness::SceneViews& scene_views);

/// Says on stderr, in one line, what of a model's file does not count here; nothing if all does.
void print_not_heeded(const std::string& scene, const std::vector<std::string>& notes);

/// Where a scene with at least one triangle is and from where it is seen, so that a user can place
/// a camera: a line for its box and the sphere that views are fitted to, then one for each view,
/// `name  --eye X,Y,Z --target ...`, with a target as far away as the centre is; animations, and
/// what of the file does not count here.
///
/// All coordinates are the file's own (Scene::origin), to nine digits, or fifteen for a scene that
/// is far out.
[[nodiscard]] std::string place_text(const harness::SceneViews& scene_views);

/// The same as `box`, `centre`, `radius`, ..., and `cameras` by name.
[[nodiscard]] nlohmann::ordered_json place_json(const harness::SceneViews& scene_views);

}  // namespace ink::cli
