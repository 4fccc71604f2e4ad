// STL (stereolithography), text and binary.

#include <array>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parse_number.h"
#include "import/meshes/line_words.h"
#include "import/meshes/mesh_readers.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

constexpr std::size_t kStlHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;

void add_facet(const glm::vec3& normal,
               const std::array<glm::dvec3, 3>& corners,
               ImportedMesh& to) {
    to.positions.insert(to.positions.end(), corners.begin(), corners.end());
    to.normals.insert(to.normals.end(), 3, normal);
}

/// `mesh` has facets, which share no vertex, and no triangles yet.
ImportReply reply_of_facets(ImportedMesh mesh, const std::string& name) {
    ImportReply reply;
    mesh.name = name;
    mesh.triangles.reserve(mesh.positions.size() / 3);
    for (std::uint32_t v = 0; v + 2 < mesh.positions.size(); v += 3)
        mesh.triangles.push_back({v, v + 1, v + 2});
    reply.instances.push_back({.mesh = 0, .name = name});
    reply.meshes.push_back(std::move(mesh));
    return reply;
}

std::uint64_t facet_count(std::string_view file) {
    return number_at<std::uint32_t>(std::as_bytes(std::span(file)), kStlHeaderBytes - 4);
}

/// Bytes behind the last facet are left alone: writers add their own there.
ImportReply read_binary(std::string_view file, const std::string& name) {
    if (file.size() < kStlHeaderBytes) {
        throw core::Error("",
                          "the file is neither STL text nor long enough for binary STL",
                          "a text that begins with \"solid\" and \"facet\", or " +
                              std::to_string(kStlHeaderBytes) + " bytes and more");
    }
    const std::uint64_t count = facet_count(file);
    const std::uint64_t bytes = kStlHeaderBytes + count * kFacetBytes;
    if (bytes > file.size()) {
        throw core::Error("",
                          "the file is cut short: its header promises " + std::to_string(bytes) +
                              " bytes, it has " + std::to_string(file.size()),
                          "a whole, valid model file");
    }
    if (count > 0x7fffffffU / 3) throw core::Error("", "too many facets", "up to 715827882");
    ImportedMesh facets;
    facets.are_floats = true;
    facets.positions.reserve(3 * count);
    facets.normals.reserve(3 * count);
    for (const char* at = file.data() + kStlHeaderBytes; at != file.data() + bytes;
         at += kFacetBytes) {
        std::array<glm::vec3, 4> facet;
        static_assert(sizeof facet == 48);
        std::memcpy(facet.data(), at, sizeof facet);
        add_facet(facet[0], {facet[1], facet[2], facet[3]}, facets);
    }
    return reply_of_facets(std::move(facets), name);
}

void expect(LineWords& words, std::string_view keyword) {
    if (words.is_line_over() && !words.next_line()) {
        throw core::Error("",
                          "the file is cut short: it ends inside a solid",
                          "\"endsolid\" at the end of each solid");
    }
    const std::string_view word = words.word();
    if (is_same_word(word, keyword)) return;
    words.fail(in_quotes(word) + " stands where " + in_quotes(keyword) + " belongs",
               "a facet of three "
               "vertices");
}

/// A normal's number. Some writers put words such as 1.#QNAN there, which say that there is none.
float normal_number(LineWords& words) {
    const std::string_view word = words.word();
    if (word.empty()) words.fail("a normal has less than three numbers", "three numbers");
    return core::parse_number<float>(word).value_or(std::numeric_limits<float>::quiet_NaN());
}

void read_facet(LineWords& words, ImportedMesh& to) {
    expect(words, "normal");
    glm::vec3 normal;
    for (int axis = 0; axis < 3; ++axis)
        normal[axis] = normal_number(words);
    expect(words, "outer");
    expect(words, "loop");
    std::array<glm::dvec3, 3> corners{};
    for (glm::dvec3& p : corners) {
        expect(words, "vertex");
        p = words.vector("a vertex's coordinate");
    }
    expect(words, "endloop");
    expect(words, "endfacet");
    add_facet(normal, corners, to);
}

/// The facets up to "endsolid".
void read_solid(LineWords& words, ImportedMesh& facets) {
    while (true) {
        if (words.is_line_over() && !words.next_line()) {
            throw core::Error("",
                              "the file is cut short: its end mark is missing",
                              "\"endsolid\" at the end of each solid");
        }
        const std::string_view word = words.word();
        if (is_same_word(word, "endsolid")) return (void)words.rest();
        if (!is_same_word(word, "facet"))
            words.fail(in_quotes(word) + " stands between facets", "facet or endsolid");
        read_facet(words, facets);
    }
}

ImportReply read_text(std::string_view file, const std::string& name) {
    LineWords words(file);
    ImportedMesh facets;
    std::vector<std::string> names;
    while (words.next_line()) {
        const std::string_view word = words.word();
        // A text from DOS may end with its end mark.
        if (!names.empty() && word.find_first_not_of('\x1a') == word.npos) continue;
        if (!is_same_word(word, "solid"))
            words.fail(in_quotes(word) + " stands outside of a solid", "solid");
        const std::size_t before = facets.positions.size();
        const std::string solid = words.rest();
        read_solid(words, facets);
        if (facets.positions.size() > before) names.push_back(solid);
    }
    const bool is_named = names.size() == 1 && !names.front().empty();
    return reply_of_facets(std::move(facets), is_named ? names.front() : name);
}

}  // namespace

bool is_stl_text(std::string_view file) {
    LineWords words(file);
    if (!words.next_line() || !is_same_word(words.word(), "solid")) return false;
    // A binary file may begin with "solid", too; its second line, if any, is no facet.
    if (!words.next_line()) return false;
    const std::string_view word = words.word();
    return is_same_word(word, "facet") || is_same_word(word, "endsolid");
}

bool is_binary_stl(std::string_view file) {
    if (file.size() < kStlHeaderBytes) return false;
    const std::uint64_t bytes = kStlHeaderBytes + facet_count(file) * kFacetBytes;
    if (bytes == file.size()) return true;
    return bytes < file.size() && !is_stl_text(file);
}

ImportReply read_stl(std::string_view file, const std::string& name) {
    // What is neither: letters alone were meant as text.
    const bool has_zero_byte = file.substr(0, kStlHeaderBytes).find('\0') != file.npos;
    const bool is_text = !is_binary_stl(file) && (is_stl_text(file) || !has_zero_byte);
    return is_text ? read_text(file, name) : read_binary(file, name);
}

}  // namespace ink::import
