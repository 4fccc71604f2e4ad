#pragma once

#include <fmt/format.h>

#include <string>

// Small scenes in formats that Assimp reads, as text.

namespace ink::import {

/// A box of 1 x 2 x 3 from zero as FBX, with axes and a unit as GlobalSettings has them, and a
/// camera at (0, 1, 10) if `camera` is its CameraProjectionType.
struct FbxFile {
    int up = 1, up_sign = 1;
    int front = 2, front_sign = 1;
    int right = 0, right_sign = 1;
    double unit = 1;
    int camera = -1;
    double zoom = 1;

    [[nodiscard]] std::string text() const {
        const auto setting = [](const char* name, int value) {
            return fmt::format("P: \"{}\", \"int\", \"Integer\", \"\",{}\n", name, value);
        };
        return "; FBX 7.3.0 project file\nFBXHeaderExtension: {\nFBXHeaderVersion: 1003\n"
               "FBXVersion: 7300\nCreator: \"x\"\n}\nGlobalSettings: {\nVersion: 1000\n"
               "Properties70: {\n" +
               setting("UpAxis", up) + setting("UpAxisSign", up_sign) +
               setting("FrontAxis", front) + setting("FrontAxisSign", front_sign) +
               setting("CoordAxis", right) + setting("CoordAxisSign", right_sign) +
               fmt::format("P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",{}\n", unit) +
               "}\n}\nObjects: {\nGeometry: 100, \"Geometry::g\", \"Mesh\" {\nVertices: *24 {\n"
               "a: 0,0,0,0,0,3,0,2,0,0,2,3,1,0,0,1,0,3,1,2,0,1,2,3\n}\nPolygonVertexIndex: *24 {\n"
               "a: 0,1,3,-3,4,6,7,-6,0,4,5,-2,2,3,7,-7,0,2,6,-5,1,5,7,-4\n}\n"
               "GeometryVersion: 124\n}\nModel: 200, \"Model::box\", \"Mesh\" {\nVersion: 232\n"
               "Properties70: {\n}\n}\n" +
               (camera < 0 ? "" : camera_objects()) + "}\nConnections: {\nC: \"OO\",200,0\n" +
               (camera < 0 ? "" : "C: \"OO\",400,0\nC: \"OO\",300,400\n") +
               "C: \"OO\",100,200\n}\n";
    }

  private:
    [[nodiscard]] std::string camera_objects() const {
        return fmt::format(
            "NodeAttribute: 300, \"NodeAttribute::lens\", \"Camera\" {{\nProperties70: {{\n"
            "P: \"FieldOfView\", \"FieldOfView\", \"\", \"A\",40.0\n"
            "P: \"CameraProjectionType\", \"enum\", \"\", \"\",{}\n"
            "P: \"OrthoZoom\", \"double\", \"Number\", \"A\",{}\n}}\nTypeFlags: \"Camera\"\n"
            "GeometryVersion: 124\n}}\nModel: 400, \"Model::Eye\", \"Camera\" {{\nVersion: 232\n"
            "Properties70: {{\nP: \"Lcl Translation\", \"Lcl Translation\", \"\", "
            "\"A\",0,1,10\n}}\n"
            "}}\n",
            camera,
            zoom);
    }
};

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
    return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
           "version=\"1.4.1\"><asset><up_axis>Y_UP</up_axis></asset><library_cameras><camera "
           "id=\"c\"><optics><technique_common>" +
           optics + "</technique_common></optics></camera></library_cameras><library_effects>" +
           effect("red") + effect("blue") + "</library_effects><library_materials>" +
           material("red") + material("blue") +
           "</library_materials><library_geometries><geometry id=\"g\"><mesh><source id=\"p\">"
           "<float_array id=\"pa\" count=\"12\">0 0 0 1 0 0 0 1 0 1 1 0</float_array>"
           "<technique_common><accessor source=\"#pa\" count=\"4\" stride=\"3\"><param name=\"X\" "
           "type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/>"
           "</accessor></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" "
           "source=\"#p\"/></vertices>" +
           triangles("red", "0 1 2") + triangles("blue", "1 3 2") +
           "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">" +
           use("left", 0) + use("right", 5) +
           "<node id=\"eye\"><translate>0 1 10</translate><instance_camera url=\"#c\"/></node>"
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
           "url=\"#s\"/></scene>"
           "</COLLADA>\n";
}

}  // namespace ink::import
