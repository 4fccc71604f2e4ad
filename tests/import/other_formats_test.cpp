// Which formats are read and which are refused, with the table of README.md.

#include "import/other_formats.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "core/whole_file.h"
#include "tests/core/error_text.h"
#include "tests/import/model_files.h"
#include "tests/import/quake_files.h"

namespace ink::import {
namespace {

using testing::HasSubstr;

using OtherFormats = ModelFiles;

std::vector<std::string> words_of(std::string_view text) {
    std::string plain(text);
    std::ranges::replace(plain, ',', ' ');
    std::istringstream words(plain);
    return {std::istream_iterator<std::string>(words), {}};
}

/// A file of the format, as far as it has a mark.
std::string content_of(std::string_view mark) {
    constexpr std::string_view kForm("FORM\0\0\0\4", 8);
    const bool is_iff = mark == "LWO" || mark == "LWLO" || mark == "LXOB";
    return std::string(is_iff ? kForm : "") + std::string(mark) + " 1 2 3\n4 5 6\n";
}

/// Each kind that goes the same way in one row, in the order of the table.
std::string refused_rows() {
    std::vector<std::pair<std::string, std::string>> rows;
    for (const OtherFormat& format : other_formats()) {
        const std::string way(format.way);
        auto row = std::ranges::find(rows, way, &std::pair<std::string, std::string>::first);
        if (row == rows.end()) row = rows.insert(row, {way, ""});
        std::string& kinds = row->second;
        if (!kinds.empty()) kinds += ", ";
        kinds += format.name.substr(format.name.find(' ') + 1);
        if (!format.endings.empty()) kinds += " (" + std::string(format.endings) + ')';
    }
    std::string text;
    for (const auto& [way, kinds] : rows)
        text += "| " + kinds + " | " + way + " |\n";
    return text;
}

TEST_F(OtherFormats, EveryEndingIsRefusedByNameWithAWay) {
    for (const OtherFormat& format : other_formats()) {
        for (const std::string& ending : words_of(format.endings)) {
            const auto path = write("model" + ending, content_of(format.marks[0]));
            const std::string error = core::error_text([&] { return import_scene(path); });
            EXPECT_EQ(error,
                      path.string() + ": is " + std::string(format.name) +
                          ", which is not read (accepted: " + std::string(format.way) + ')');
        }
    }
    EXPECT_THAT(complaint(write("UPPER.DXF", "x")), HasSubstr("is a DXF drawing"));
}

TEST_F(OtherFormats, EveryMarkIsKnownWhateverTheFileIsCalled) {
    for (const OtherFormat& format : other_formats()) {
        for (const std::string_view mark : format.marks) {
            if (mark.empty()) continue;
            const std::string content = content_of(mark);
            for (const char* name : {"model.obj", "model.ply", "model.stl", "model"})
                EXPECT_THAT(complaint(write(name, content)),
                            HasSubstr("is " + std::string(format.name) + ", which is not read"))
                    << mark << name;
        }
    }
}

TEST_F(OtherFormats, MarksStandBehindWhiteSpaceAndProlog) {
    for (const char* content : {"  0\r\nSECTION\r\n  2\r\nENTITIES\r\n", "\n0\nSECTION\n"})
        EXPECT_THAT(complaint(write("a.obj", content)), HasSubstr("is a DXF drawing"));
    EXPECT_THAT(complaint(write("a.obj",
                                "\xef\xbb\xbf<?xml version='1.0'?>\n<!-- <X3D> -->\n<!DOCTYPE "
                                "amf>\n<amf unit='millimeter'>\n")),
                HasSubstr("is an AMF file"));
    EXPECT_THAT(
        complaint(write("a.stp", "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC2X3'));\nENDSEC;\n")),
        HasSubstr("is an IFC file"));
}

TEST_F(OtherFormats, ABinaryStlMayBeginAsItLikes) {
    std::string facet = "AC3D";
    facet.resize(80, ' ');
    put(facet, std::uint32_t{1});
    put(facet, std::array<float, 12>{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    put(facet, std::uint16_t{0});
    EXPECT_EQ(scene::triangle_count(import_scene(write("a.stl", facet))), 1U);
}

TEST_F(OtherFormats, WhatIsReadHasWrongContentWithoutOne) {
    for (const std::string& ending : words_of(kReadEndings)) {
        const std::string text = complaint(write("noise" + ending, "\x01\x02 no model \x03"));
        EXPECT_EQ(text.find("not a kind of model file"), text.npos) << ending << text;
        EXPECT_EQ(text.find("which is not read"), text.npos) << ending << text;
    }
}

TEST_F(OtherFormats, NothingThatAssimpKnowsIsPassedOver) {
    // Of Assimp 5.2, but for .xml, which says nothing.
    const std::string known =
        ".3d .3ds .3mf .ac .ac3d .acc .amf .ase .ask .assbin .b3d .blend .bsp .bvh .cob .csm .dae "
        ".dxf .enff .fbx .glb .gltf .hmp .ifc .ifczip .iqm .irr .irrmesh .lwo .lws .lxo .md2 .md3 "
        ".md5anim .md5camera .md5mesh .mdc .mdl .mesh .mesh.xml .mot .ms3d .ndo .nff .obj .off "
        ".ogex .pk3 .ply .pmx .prj .q3o .q3s .raw .scn .sib .smd .step .stl .stp .ter .uc .vta .x "
        ".x3d .x3db .xgl .zae .zgl";
    std::vector<std::string> ours = words_of(kReadEndings);
    for (const OtherFormat& format : other_formats())
        std::ranges::copy(words_of(format.endings), std::back_inserter(ours));
    for (const std::string& ending : words_of(known))
        EXPECT_EQ(std::ranges::count(ours, ending), 1) << ending;
}

TEST(OtherFormatsPage, ListsWhatIsReadAndWhatIsRefused) {
    const std::string page =
        core::read_whole_file(INK_SOURCE_DIR "/src/import/README.md").value_or("");
    const std::string head = "| refused by name | what would do |\n|---|---|\n";
    const std::size_t at = page.find(head);
    ASSERT_NE(at, page.npos);
    const std::string rest = page.substr(at + head.size());
    EXPECT_EQ(rest.substr(0, rest.find("\n\n") + 1), refused_rows());
    std::string read;
    std::istringstream lines(page.substr(0, at));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t open = line.find("(.");
        if (!line.starts_with("| ") || open == line.npos || open > line.find(" | ")) continue;
        read += (read.empty() ? "" : ", ") + line.substr(open + 1, line.find(')') - open - 1);
    }
    EXPECT_EQ(read, kReadEndings);
}

}  // namespace
}  // namespace ink::import
