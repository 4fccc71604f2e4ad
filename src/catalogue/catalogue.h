#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace ink::catalogue {

/// One built-in scene: made by code, the same on every machine, with its own views and its split.
struct CatalogueEntry {
    std::string name;  ///< what `--scenes` and the rows call it
    scene::Split split;
    std::string kind;         ///< of thing, in the words of experiments/models.toml, or "shape"
    std::string summary;      ///< one line: what it is and what it tries
    scene::Scene (*build)();  ///< without name, split and check: call `make`

    /// The scene: checked, named, in its split, 16:9 cameras fitted, lights set.
    [[nodiscard]] scene::Scene make() const;
};

/// All built-in scenes in a fixed order, training scenes first; names are unique.
[[nodiscard]] const std::vector<CatalogueEntry>& catalogue();

/// The scene called `name`. Throws Error that lists the known names if there is none.
[[nodiscard]] scene::Scene make_catalogue_scene(const std::string& name);

}  // namespace ink::catalogue
