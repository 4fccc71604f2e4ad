#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/import/dae_files.h"

// A scene with cameras and materials, as text that Assimp reads.

namespace ink::import {

/// Two triangles of two materials in one geometry, which two nodes have; a third node has a camera
/// with `optics`.
inline std::string dae_file(const std::string& optics) {
    const auto triangles = [](const char* material, const char* corners) {
        return fmt::format(
            "<triangles material=\"{}\" count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" "
            "offset=\"0\"/><p>{}</p></triangles>",
            material,
            corners);
    };
    const std::string geometry = dae_geometry(
        "g", "0 0 0 1 0 0 0 1 0 1 1 0", triangles("red", "0 1 2") + triangles("blue", "1 3 2"), 4);
    const auto effect = [](const char* name) {
        return fmt::format(
            "<effect id=\"{0}-e\"><profile_COMMON><technique sid=\"c\"><lambert><diffuse><color>1 "
            "0 "
            "0 1</color></diffuse></lambert></technique></profile_COMMON></effect>",
            name);
    };
    const auto material = [](const char* name) {
        return fmt::format("<material id=\"{0}\"><instance_effect url=\"#{0}-e\"/></material>",
                           name);
    };
    const auto use = [](const char* node, int x) {
        return fmt::format(
            "<node id=\"{}\"><translate>{} 0 0</translate><instance_geometry "
            "url=\"#g\"><bind_material>"
            "<technique_common><instance_material symbol=\"red\" "
            "target=\"#red\"/><instance_material "
            "symbol=\"blue\" target=\"#blue\"/></technique_common></bind_material>"
            "</instance_geometry></node>",
            node,
            x);
    };
    return dae_document(
        geometry,
        use("left", 0) + use("right", 5) +
            "<node id=\"eye\"><translate>0 1 10</translate><instance_camera url=\"#c\"/></node>",
        "<library_cameras><camera id=\"c\"><optics><technique_common>" + optics +
            "</technique_common></optics></camera></library_cameras><library_effects>" +
            effect("red") + effect("blue") + "</library_effects><library_materials>" +
            material("red") + material("blue") + "</library_materials>");
}

}  // namespace ink::import
