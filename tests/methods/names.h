#pragma once

#include <string>
#include <vector>

#include "methods/registry.h"
#include "scene/catalogue.h"

/// What tests over every method or every scene are named by.
namespace ink::methods {

inline std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const MethodInfo& info : registry())
        names.push_back(info.name);
    return names;
}

inline std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const scene::CatalogueEntry& entry : scene::catalogue())
        names.push_back(entry.name);
    return names;
}

}  // namespace ink::methods
