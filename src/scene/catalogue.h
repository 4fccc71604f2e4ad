#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace ink::scene {

/// One built-in scene: made by code, the same on every machine, with its own views and its split.
struct CatalogueEntry {
    std::string name;  ///< what `--scenes` and the rows call it
    Split split;
    std::string summary;  ///< one line: what it is and what it tries
    Scene (*make)();      ///< checked, named, cameras fitted (16:9), lights set
};

/// All built-in scenes in a fixed order; names are unique.
[[nodiscard]] const std::vector<CatalogueEntry>& catalogue();

/// The scene called `name`. Throws Error that lists the known names if there is none.
[[nodiscard]] Scene make_catalogue_scene(const std::string& name);

}  // namespace ink::scene
