// OFF (Geomview's Object File Format), text.

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "import/meshes/line_words.h"
#include "import/meshes/mesh_readers.h"
#include "import/meshes/polygons.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

constexpr WordRules kOffRules{.comment = '#', .ends_words = true};

/// The prefixes of the format's word, in their order: [ST][C][N][4][n]OFF.
struct OffKind {
    bool has_normals = false;
    bool has_more = false;  ///< colours or texture coordinates behind each vertex
    bool has_other_dimensions = false;
};

/// What the format's word says; nothing if it is none.
std::optional<OffKind> kind_of(std::string_view word) {
    OffKind kind;
    const auto take = [&](std::string_view prefix) {
        const bool has_it = word.starts_with(prefix);
        if (has_it) word.remove_prefix(prefix.size());
        return has_it;
    };
    const bool has_texture = take("ST");
    // Both orders of C and N are seen.
    const bool has_color_first = take("C");
    kind.has_normals = take("N");
    kind.has_more = has_texture || has_color_first || take("C");
    const bool is_4 = take("4");
    const bool is_n = take("n");
    kind.has_other_dimensions = is_4 || is_n;
    return word == "OFF" ? std::optional(kind) : std::nullopt;
}

/// Some writers forget to end the line behind the word: "OFF490 518 0".
bool is_glued(std::string_view word) {
    return word.starts_with("OFF") && word.size() > 3 &&
           word.find_first_not_of("0123456789", 3) == word.npos;
}

void next_line(LineWords& words, const char* of_what) {
    if (words.next_line()) return;
    throw core::Error("",
                      std::string("the file is cut short: it ends inside its ") + of_what,
                      "as many as its counts promise");
}

void read_vertex(LineWords& words, const OffKind& kind, ImportedMesh& mesh) {
    next_line(words, "vertices");
    mesh.positions.push_back(words.vector("a vertex's coordinate"));
    if (kind.has_normals) mesh.normals.emplace_back(words.vector("a normal's coordinate"));
    if (!kind.has_more && !words.is_line_over())
        words.fail("more numbers than a vertex has", "one vertex a line; COFF for colours");
}

/// What follows the corners is a colour.
void read_face(LineWords& words, std::size_t vertices, Polygons& faces) {
    next_line(words, "faces");
    const std::uint64_t corners = words.count("a face's count of corners");
    for (std::uint64_t c = 0; c < corners; ++c) {
        const std::uint64_t v = words.count("a corner");
        if (v >= vertices) {
            words.fail(
                "a face has the vertex " + std::to_string(v),
                vertices == 0 ? "a file with vertices" : "0.." + std::to_string(vertices - 1));
        }
        faces.corners.push_back(static_cast<std::uint32_t>(v));
    }
    faces.ends.push_back(faces.corners.size());
}

/// The count of vertices or of faces: on the line, or the next.
std::uint64_t read_count(LineWords& words, const char* what) {
    if (words.is_line_over()) next_line(words, "counts");
    return words.count(what);
}

}  // namespace

bool is_off(std::string_view file) {
    LineWords words(file, kOffRules);
    if (!words.next_line()) return false;
    const std::string_view word = words.word();
    return kind_of(word) || is_glued(word);
}

ImportReply read_off(std::string_view file, const std::string& name) {
    LineWords words(file, kOffRules);
    next_line(words, "counts");
    OffKind kind;
    LineWords ahead = words;
    const std::string_view word = ahead.word();
    if (const auto named = kind_of(word)) {
        kind = *named;
        words = ahead;
        const bool is_binary = ahead.word() == "BINARY";
        if (kind.has_other_dimensions || is_binary) {
            throw Refusal("",
                          "is an OFF file of the kind \"" + std::string(word) +
                              (is_binary ? " BINARY" : "") + "\", which is not read",
                          "OFF as text, of three coordinates");
        }
    }
    if (is_glued(word)) {
        const auto behind = static_cast<std::size_t>(word.data() + 3 - file.data());
        words = LineWords(file.substr(behind), kOffRules, words.line());
    }
    const std::uint64_t vertices = read_count(words, "the count of vertices");
    const std::uint64_t faces = read_count(words, "the count of faces");
    if (!words.is_line_over()) (void)words.count("the count of edges");
    if (!words.is_line_over()) words.fail("more counts than three", "vertices, faces and edges");
    if (vertices > 0xfffffffeU) words.fail("too many vertices", "up to 4294967294");
    ImportedMesh mesh;
    mesh.name = name;
    // Each takes three digits and blanks at least; a face takes its count.
    mesh.positions.reserve(std::min<std::uint64_t>(vertices, file.size() / 6 + 1));
    for (std::uint64_t v = 0; v < vertices; ++v)
        read_vertex(words, kind, mesh);
    Polygons polygons;
    polygons.ends.reserve(std::min<std::uint64_t>(faces, file.size() / 2 + 1));
    for (std::uint64_t f = 0; f < faces; ++f)
        read_face(words, mesh.positions.size(), polygons);
    return reply_of_mesh(std::move(mesh), polygons);
}

}  // namespace ink::import
