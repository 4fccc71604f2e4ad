#include "import/other_formats.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "import/meshes/line_words.h"
#include "import/model_bytes.h"
#include "import/refusal.h"

namespace ink::import {
namespace {

using Words = std::string_view;

struct OtherFormat {
    Words name;
    Words mark;     ///< its first bytes; empty: it has none that is its own
    Words endings;  ///< each between blanks
};

// Blender's and IFC's readers in Assimp leave out what they do not know and say nothing.
constexpr std::array<OtherFormat, 24> kOtherFormats{{
    {"an IFC file (building)", "", " .ifc .ifczip .ifcxml "},
    {"a STEP file (CAD)", "ISO-10303-21", " .step .stp .p21 .stpz .stpx "},
    {"an IGES file (CAD)", "", " .iges .igs "},
    {"a USD file", "PXR-USDC", " .usd .usdc .usdz "},
    {"a USD file", "#usda", " .usda "},
    {"a Blender file", "BLENDER", " .blend "},
    {"a Rhino file", "3D Geometry File Format", " .3dm "},
    {"a Parasolid file (CAD)", "**ABCDEFGHIJKLMNOPQRSTUVWXYZ", " .x_t .x_b .xmt_txt .xmt_bin "},
    {"an Open CASCADE shape (CAD)", "DBRep_DrawableShape", " .brep .brp "},
    {"an Open CASCADE shape (CAD)", "\nCASCADE Topology", " "},
    {"an Alembic file", "Ogawa", " .abc "},
    {"a Maya file", "//Maya ASCII", " .ma .mb "},
    {"a JT file (CAD)", "Version 8", " .jt "},
    {"a JT file (CAD)", "Version 9", " "},
    {"a JT file (CAD)", "Version 10", " "},
    {"a DWG drawing", "AC10", " .dwg .dgn "},
    {"a 3ds Max scene", "", " .max "},
    {"a SketchUp file", "\xff\xfe\xff\x0eS", " .skp "},
    {"a Cinema 4D file", "", " .c4d "},
    {"an ACIS file (CAD)", "", " .sat .sab .asat .asab "},
    {"a CAD part or assembly",
     "",
     " .sldprt .sldasm .ipt .iam .catpart .catproduct .prt .f3d .fcstd "},
    {"an OpenSCAD program", "", " .scad "},
    {"a VRML file", "#VRML", " .wrl .vrml .wrz "},
    {"a Model 3D file", "3DMO", " .m3d .a3d "},
}};

bool is_ifc(Words head) {
    const std::size_t schema = head.find("FILE_SCHEMA");
    return schema != head.npos && head.substr(schema, 80).find("IFC") != head.npos;
}

[[noreturn]] void refuse(Words name) {
    throw Refusal("",
                  "is " + std::string(name) + ", which is not read",
                  "an export of it as glTF, STL, OBJ or PLY");
}

/// Assimp reads the faces of a DXF file, and says nothing of solids and surfaces beside them.
void check_dxf(const std::filesystem::path& path) {
    constexpr std::array<Words, 6> kShapes{"3DSOLID", "BODY", "REGION", "SURFACE", "MESH", "SOLID"};
    const std::vector<std::byte> bytes = bytes_of(path);
    LineWords words(Words(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    while (words.next_line()) {
        // A group is a code and a value, a line each; 0 begins an entity.
        const bool is_entity = words.word() == "0";
        if (!words.next_line() || !is_entity) continue;
        const Words entity = words.word();
        if (std::find(kShapes.begin(), kShapes.end(), entity) == kShapes.end()) continue;
        throw Refusal("",
                      "line " + std::to_string(words.line()) + ": the DXF entity \"" +
                          std::string(entity) + "\" is not read",
                      "3DFACE and POLYLINE meshes");
    }
}

}  // namespace

void refuse_other_format(const std::filesystem::path& path) {
    const std::string head = head_of(path);
    Words text = without_mark(head);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
    if (is_utf16(head) && !text.starts_with("\xff\xfe\xff\x0eS"))
        throw Refusal("", "is UTF-16 text, which is not read", "UTF-8");
    const std::string ending = ' ' + lower_case(path.extension().string()) + ' ';
    for (const OtherFormat& format : kOtherFormats) {
        if (format.mark.empty() || !text.starts_with(format.mark)) continue;
        refuse(is_ifc(head) ? kOtherFormats.front().name : format.name);
    }
    if (ending == " .dxf ") check_dxf(path);
    for (const OtherFormat& format : kOtherFormats)
        if (ending.size() > 2 && format.endings.find(ending) != Words::npos) refuse(format.name);
}

}  // namespace ink::import
