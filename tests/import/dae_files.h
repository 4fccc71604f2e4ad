#pragma once

#include <string>

// COLLADA documents as text, put together from parts.

namespace ink::import {

/// A source of vectors called `id`.
inline std::string dae_source(const std::string& id, const std::string& numbers, int count) {
    return "<source id=\"" + id + "\"><float_array id=\"" + id + "a\" count=\"" +
           std::to_string(3 * count) + "\">" + numbers +
           "</float_array><technique_common><accessor source=\"#" + id + "a\" count=\"" +
           std::to_string(count) +
           "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
           "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>";
}

inline const std::string kDaeBoxCorners = "0 0 0 0 0 3 0 2 0 0 2 3 1 0 0 1 0 3 1 2 0 1 2 3";
inline const std::string kDaeBoxFaces =
    "<polylist count=\"6\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
    "<vcount>4 4 4 4 4 4</vcount><p>0 1 3 2 4 6 7 5 0 4 5 1 2 3 7 6 0 2 6 4 1 5 7 3</p></polylist>";

/// A geometry of one source of positions, `id` before the ids in it but that of its vertices: "v".
inline std::string dae_geometry(const std::string& id,
                                const std::string& corners = kDaeBoxCorners,
                                std::string faces = kDaeBoxFaces,
                                int count = 8) {
    const std::string vertices = id == "g" ? "v" : id + "v";
    for (std::size_t at = faces.find("\"#v\""); at != faces.npos; at = faces.find("\"#v\"", at + 1))
        faces.replace(at, 4, "\"#" + vertices + '"');
    return "<geometry id=\"" + id + "\"><mesh>" + dae_source(id + "p", corners, count) +
           "<vertices id=\"" + vertices + "\"><input semantic=\"POSITION\" source=\"#" + id +
           "p\"/></vertices>" + faces + "</mesh></geometry>";
}

/// A document of these geometries, controllers and so on, and nodes.
inline std::string dae_document(const std::string& geometries,
                                const std::string& nodes,
                                const std::string& more = "",
                                const std::string& asset = "<up_axis>Y_UP</up_axis>") {
    return "<?xml version=\"1.0\"?><COLLADA "
           "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset>" +
           asset + "</asset><library_geometries>" + geometries + "</library_geometries>" + more +
           "<library_visual_scenes><visual_scene id=\"s\">" + nodes +
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
           "url=\"#s\"/></scene></COLLADA>\n";
}

/// A node that has the geometry "g".
inline std::string dae_node(const std::string& transforms, const std::string& id = "n") {
    return "<node id=\"" + id + "\">" + transforms + "<instance_geometry url=\"#g\"/></node>";
}

}  // namespace ink::import
