#include "import/other_formats.h"

#include <algorithm>
#include <string>

#include "import/model_bytes.h"

namespace ink::import {
namespace {

using Words = std::string_view;

constexpr Words kMaker = "glTF, STL, OBJ or PLY, exported by the program that made it";
constexpr Words kBlender = "glTF of it by Blender, which imports it";
constexpr Words kTessellate = "glTF of it by experiments/brep/tessellate";
constexpr Words kMotion = "glTF of the model that it moves";

// Assimp reads most of them, and leaves out what it does not know without a word.
constexpr std::array kOtherFormats{
    OtherFormat{"an IFC file",
                ".ifc .ifczip .ifcxml",
                {},
                "glTF of it by assimp export, as experiments/models.toml has house"},
    OtherFormat{"a STEP file", ".step .stp .p21 .stpz .stpx", {"ISO-10303-21"}, kTessellate},
    OtherFormat{"an Open CASCADE shape",
                ".brep .brp",
                {"DBRep_DrawableShape", "CASCADE Topology"},
                kTessellate},
    OtherFormat{"an IGES file", ".iges .igs", {}, "STL of it: gmsh FILE -2 -clcurv 24 -o OUT.stl"},
    OtherFormat{"an OpenSCAD program", ".scad", {}, "STL of it: openscad -o OUT.stl FILE"},
    OtherFormat{"a DXF drawing",
                ".dxf",
                {"0 SECTION", "AutoCAD Binary DXF"},
                "STL by the program that made it; of 3DFACE and POLYLINE meshes without arrays of "
                "INSERT also OBJ by osgconv (OpenSceneGraph)"},
    OtherFormat{"an AC3D model",
                ".ac .ac3d .acc",
                {"AC3D"},
                "OBJ of it by osgconv (OpenSceneGraph), but for those with subdiv"},
    OtherFormat{"a 3MF package",
                ".3mf",
                {},
                "STL or OBJ by the program that made it; STL by prusa-slicer --export-stl"},
    OtherFormat{
        "an AMF file",
        ".amf",
        {"<amf"},
        "STL by the program that made it, or by prusa-slicer --export-stl if no instance is "
        "turned"},
    OtherFormat{"an X3D file", ".x3d .x3db .x3dv", {"<X3D"}, kBlender},
    OtherFormat{"a VRML file", ".wrl .vrml .wrz", {"#VRML"}, kBlender},
    OtherFormat{"a Blender file",
                ".blend",
                {"BLENDER"},
                "glTF of it: blender -b FILE --python-expr \"import bpy; "
                "bpy.ops.export_scene.gltf(filepath='OUT.glb', export_apply=True)\""},
    OtherFormat{
        "a Collada file",
        ".dae .zae",
        {"<COLLADA"},
        "glTF of it: assimp export FILE OUT.glb -fglb2, as experiments/models.toml has duck"},
    OtherFormat{
        "a 3DS file",
        ".3ds .prj",
        {},
        "glTF of it: assimp export FILE OUT.glb -fglb2; if it moves, STL: assimp export FILE "
        "OUT.stl -fstlb"},
    OtherFormat{"a Quake 3 map",
                ".bsp .pk3",
                {"IBSP"},
                "OBJ of it by map_mesh of experiments/models/quake.py"},
    OtherFormat{"a BVH motion without a shape", ".bvh", {"HIERARCHY"}, kMotion},
    OtherFormat{"a CSM motion without a shape", ".csm", {"$Filename"}, kMotion},
    OtherFormat{"a LightWave object", ".lwo", {"LWO", "LWLO"}, kMaker},
    OtherFormat{"a Modo object", ".lxo", {"LXOB"}, kMaker},
    OtherFormat{"a LightWave scene", ".lws .mot", {"LWSC"}, kMaker},
    OtherFormat{"a DirectX file", ".x", {"xof 0"}, kMaker},
    OtherFormat{"a Doom 3 model", ".md5mesh .md5anim .md5camera", {"MD5Version"}, kMaker},
    OtherFormat{"an Ogre or Medit mesh", ".mesh .mesh.xml", {"<mesh>", "MeshVersion"}, kMaker},
    OtherFormat{"a Source model", ".smd .vta", {"version 1 nodes"}, kMaker},
    OtherFormat{"a Half-Life model", "", {"IDST", "IDSQ"}, kMaker},
    OtherFormat{"a 3D GameStudio model", ".hmp", {"MDL", "HMP"}, kMaker},
    OtherFormat{"a Blitz3D model", ".b3d", {"BB3D"}, kMaker},
    OtherFormat{"an Inter-Quake model", ".iqm .iqe", {"INTERQUAKEMODEL"}, kMaker},
    OtherFormat{"a MilkShape model", ".ms3d", {"MS3D000000"}, kMaker},
    OtherFormat{"a 3ds Max text export", ".ase .ask", {"*3DSMAX_ASCIIEXPORT"}, kMaker},
    OtherFormat{"a trueSpace file", ".cob .scn", {"Caligari "}, kMaker},
    OtherFormat{"an NFF file", ".nff .enff", {}, kMaker},
    OtherFormat{"an OpenGEX file", ".ogex", {"Metric (key"}, kMaker},
    OtherFormat{"a Quick3D file", ".q3o .q3s", {"quick3D"}, kMaker},
    OtherFormat{"a RAW list of triangles", ".raw", {}, kMaker},
    OtherFormat{"a Silo model", ".sib", {"HEAD\x04"}, kMaker},
    OtherFormat{"an XGL file", ".xgl .zgl", {"<WORLD"}, kMaker},
    OtherFormat{"a Nendo model", ".ndo", {"nendo "}, kMaker},
    OtherFormat{"a Terragen terrain", ".ter", {"TERRAGEN"}, kMaker},
    OtherFormat{"an Irrlicht file", ".irr .irrmesh", {"<irr_scene", "<mesh xmlns"}, kMaker},
    OtherFormat{"an Unreal model", ".3d .uc", {}, kMaker},
    OtherFormat{"a Return to Castle Wolfenstein model", ".mdc", {"IDPC"}, kMaker},
    OtherFormat{"a MikuMikuDance model", ".pmx .pmd", {"PMX "}, kMaker},
    OtherFormat{"a Model 3D file", ".m3d .a3d", {"3DMO"}, kMaker},
    OtherFormat{"a dump of Assimp's", ".assbin .assxml", {"ASSIMP.binary"}, kMaker},
    OtherFormat{"a USD file", ".usd .usdc .usda .usdz", {"PXR-USDC", "#usda"}, kMaker},
    OtherFormat{"a Rhino file", ".3dm", {"3D Geometry File Format"}, kMaker},
    OtherFormat{"a Parasolid file",
                ".x_t .x_b .xmt_txt .xmt_bin",
                {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ"},
                kMaker},
    OtherFormat{"an Alembic file", ".abc", {"Ogawa"}, kMaker},
    OtherFormat{"a Maya file", ".ma .mb", {"//Maya ASCII"}, kMaker},
    OtherFormat{"a JT file", ".jt", {"Version 8", "Version 9", "Version 10"}, kMaker},
    OtherFormat{"a DWG drawing", ".dwg .dgn", {"AC10"}, kMaker},
    OtherFormat{"a 3ds Max scene", ".max", {}, kMaker},
    OtherFormat{"a SketchUp file", ".skp", {"\xff\xfe\xff\x0eS"}, kMaker},
    OtherFormat{"a Cinema 4D file", ".c4d", {}, kMaker},
    OtherFormat{"an ACIS file", ".sat .sab .asat .asab", {}, kMaker},
    OtherFormat{"a CAD part or assembly",
                ".sldprt .sldasm .ipt .iam .catpart .catproduct .prt .f3d .fcstd",
                {},
                kMaker},
};

/// Whether one of `endings` ends `name`.
bool ends_with_one(const std::string& name, Words endings) {
    while (!endings.empty()) {
        const std::size_t end = std::min(endings.find_first_of(", "), endings.size());
        if (end > 0 && name.ends_with(endings.substr(0, end))) return true;
        endings.remove_prefix(std::min(end + 1, endings.size()));
    }
    return false;
}

std::string name_of(const std::filesystem::path& path) {
    return lower_case(path.filename().string());
}

/// What stands behind the prolog, the document type and the remarks of XML.
Words behind_prolog(Words text) {
    while (text.starts_with("<?") || text.starts_with("<!")) {
        const Words end = text.starts_with("<!--") ? "-->" : ">";
        const std::size_t at = text.find(end);
        if (at == text.npos) return {};
        text.remove_prefix(at + end.size());
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    }
    return text;
}

/// The place where a file's mark stands, white space as one blank and none before it.
std::string beginning_of(Words head) {
    constexpr std::size_t kMostChars = 80;
    constexpr Words kBlanks = " \t\r\n";
    constexpr std::size_t kFormBytes = 8;
    Words text = without_mark(head);
    if (text.starts_with("FORM")) return std::string(text.substr(0, 12)).substr(kFormBytes);
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    std::string squeezed;
    for (const char c : behind_prolog(text).substr(0, kMostChars)) {
        const bool is_blank = kBlanks.find(c) != kBlanks.npos;
        if (!is_blank || !squeezed.ends_with(' ')) squeezed += is_blank ? ' ' : c;
    }
    return squeezed;
}

bool is_ifc(Words head) {
    const std::size_t schema = head.find("FILE_SCHEMA");
    return schema != head.npos && head.substr(schema, 80).find("IFC") != head.npos;
}

[[noreturn]] void refuse(const OtherFormat& format) {
    throw Refusal(
        "", "is " + std::string(format.name) + ", which is not read", std::string(format.way));
}

}  // namespace

bool has_read_ending(const std::filesystem::path& path) {
    return ends_with_one(name_of(path), kReadEndings);
}

std::span<const OtherFormat> other_formats() {
    return kOtherFormats;
}

void refuse_by_content(Words head) {
    const std::string beginning = beginning_of(head);
    for (const OtherFormat& format : kOtherFormats)
        for (const Words mark : format.marks)
            if (!mark.empty() && beginning.starts_with(mark))
                refuse(is_ifc(head) ? kOtherFormats.front() : format);
}

void refuse_by_ending(const std::filesystem::path& path, Words head) {
    for (const OtherFormat& format : kOtherFormats)
        if (ends_with_one(name_of(path), format.endings)) refuse(format);
    if (is_utf16(head)) throw Refusal("", "is UTF-16 text, which is not read", "UTF-8");
}

}  // namespace ink::import
