#pragma once

#include <string>
#include <vector>

#include "catalogue/catalogue.h"

/// The built-in scenes for tests that do much with each: all but `globe` and `scan`, whose many
/// triangles every method would have to make ready again and again. Tests that do so once take
/// `scan` too; what `globe` must hold is in tests of its own.
inline std::vector<std::string> light_scene_names() {
    std::vector<std::string> names;
    for (const ink::catalogue::CatalogueEntry& entry : ink::catalogue::catalogue()) {
        if (entry.name != "globe" && entry.name != "scan") names.push_back(entry.name);
    }
    return names;
}

inline std::vector<std::string> light_scene_names_and_scan() {
    std::vector<std::string> names = light_scene_names();
    names.emplace_back("scan");
    return names;
}
