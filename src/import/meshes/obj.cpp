// Wavefront OBJ (Advanced Visualizer, appendix B1): what has an area.

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/parse_number.h"
#include "import/meshes/line_words.h"
#include "import/meshes/mesh_readers.h"
#include "import/meshes/polygons.h"
#include "import/model_bytes.h"
#include "import/scene_stream.h"

namespace ink::import {
namespace {

constexpr std::uint32_t kNone = ~0U;

/// A corner of a face: numbers of the file's positions, normals and texture coordinates, from 0.
struct ObjCorner {
    std::uint32_t position = 0;
    std::uint32_t normal = kNone;
    std::uint32_t texcoord = kNone;
    [[nodiscard]] bool operator==(const ObjCorner&) const = default;
};

/// Faces that follow each other, of one object and one material.
struct ObjRun {
    std::size_t first_face = 0;
    std::uint32_t object = 0;
    std::uint32_t material = 0;
};

/// What an OBJ file holds, in its order.
struct ObjContent {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texcoords;  ///< as ImportedMesh has them
    std::vector<ObjCorner> corners;
    std::vector<std::size_t> ends;  ///< face f has the corners from ends[f - 1] to ends[f]
    std::vector<ObjRun> runs;       ///< each ends where the next begins
    std::vector<std::string> objects;
};

/// Gives a vertex what it has of a kind that others may lack.
template <class T>
void put(std::uint32_t vertex,
         std::uint32_t index,
         const std::vector<T>& from,
         std::vector<T>& to) {
    if (index == kNone) return;
    to.resize(vertex, T(0));
    to.push_back(from[index]);
}

/// Gives the different corners of one object their numbers.
class Vertices {
  public:
    explicit Vertices(const ObjContent& content)
        : content_(&content), first_(content.positions.size(), kNone) {}

    /// Begins with another object.
    void start(ImportedMesh& mesh) {
        for (const Entry& entry : entries_)
            first_[entry.corner.position] = kNone;
        entries_.clear();
        mesh_ = &mesh;
    }

    std::uint32_t number_of(const ObjCorner& corner) {
        std::uint32_t* link = &first_[corner.position];
        for (; *link != kNone; link = &entries_[*link].next)
            if (entries_[*link].corner == corner) return *link;
        const auto number = static_cast<std::uint32_t>(entries_.size());
        *link = number;
        entries_.push_back({corner, kNone});
        mesh_->positions.push_back(content_->positions[corner.position]);
        put(number, corner.normal, content_->normals, mesh_->normals);
        put(number, corner.texcoord, content_->texcoords, mesh_->texcoords);
        return number;
    }

    /// Of a kind all are there or none are.
    void finish() {
        const std::size_t count = mesh_->positions.size();
        if (!mesh_->normals.empty()) mesh_->normals.resize(count, glm::vec3(0));
        if (!mesh_->texcoords.empty()) mesh_->texcoords.resize(count, glm::vec2(0));
    }

  private:
    struct Entry {
        ObjCorner corner;
        std::uint32_t next;  ///< of the same position
    };
    const ObjContent* content_;
    std::vector<std::uint32_t> first_;  ///< per position of the file: its first entry
    std::vector<Entry> entries_;
    ImportedMesh* mesh_ = nullptr;
};

std::size_t end_of(const ObjContent& content, std::size_t run) {
    return run + 1 < content.runs.size() ? content.runs[run + 1].first_face : content.ends.size();
}

/// The faces of a run, by the mesh's own vertices.
Polygons faces_of(const ObjContent& content, std::size_t run, Vertices& vertices) {
    Polygons faces;
    for (std::size_t f = content.runs[run].first_face; f < end_of(content, run); ++f) {
        for (std::size_t c = f == 0 ? 0 : content.ends[f - 1]; c < content.ends[f]; ++c)
            faces.corners.push_back(vertices.number_of(content.corners[c]));
        faces.ends.push_back(faces.corners.size());
    }
    return faces;
}

void append_run(const ObjContent& content,
                std::size_t run,
                Vertices& vertices,
                ImportedMesh& mesh) {
    const Polygons faces = faces_of(content, run, vertices);
    const auto triangles = triangles_of(faces, mesh.positions);
    if (triangles.empty()) return;
    const std::uint32_t material = content.runs[run].material;
    if (mesh.parts.empty() || mesh.parts.back().material != material) {
        mesh.parts.push_back({.first_triangle = static_cast<std::uint32_t>(mesh.triangles.size()),
                              .material = material});
    }
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
}

/// A mesh for each object that has triangles, a part for each run of a material. Vertices come in
/// the order of their first use, each different corner once.
std::vector<ImportedMesh> meshes_of(const ObjContent& content) {
    std::vector<std::vector<std::size_t>> runs_of_object(content.objects.size());
    for (std::size_t run = 0; run < content.runs.size(); ++run)
        runs_of_object[content.runs[run].object].push_back(run);
    Vertices vertices(content);
    std::vector<ImportedMesh> meshes;
    for (std::size_t object = 0; object < runs_of_object.size(); ++object) {
        ImportedMesh mesh;
        mesh.name = content.objects[object];
        vertices.start(mesh);
        for (const std::size_t run : runs_of_object[object])
            append_run(content, run, vertices, mesh);
        vertices.finish();
        if (!mesh.triangles.empty()) meshes.push_back(std::move(mesh));
    }
    return meshes;
}

std::optional<double> to_number(std::string_view word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} ? std::optional(value) : std::nullopt;
}

/// A colour of a material library (MTL): three numbers, or one for all; nothing for what is a
/// spectrum or no colour.
std::optional<glm::vec3> to_color(LineWords& words) {
    glm::vec3 color{0};
    for (int i = 0; i < 3; ++i) {
        const std::string_view word = words.word();
        const auto value = to_number(word);
        if (!value && !(i > 0 && word.empty())) return std::nullopt;
        color[i] = value ? static_cast<float>(*value) : color[i - 1];
    }
    return color;
}

/// The materials of a library by name: their colour (Kd) and their opacity (d, or 1 - Tr). Only
/// names and these are looked at; what is wrong in others is none of ours.
std::map<std::string, glm::vec4> read_materials(std::string_view library) {
    std::map<std::string, glm::vec4> materials;
    glm::vec4* material = nullptr;
    for (LineWords words(library, {.comment = '#'}); words.next_line();) {
        const std::string_view keyword = words.word();
        if (keyword == "newmtl")
            material = &materials.emplace(words.rest(), glm::vec4(1)).first->second;
        if (material == nullptr) continue;
        if (keyword == "Kd") {
            if (const auto color = to_color(words)) *material = {*color, material->a};
        } else if (keyword == "d" || keyword == "Tr") {
            const auto value = to_number(words.word());  // none: "d -halo 0.5" fades with the angle
            if (value) material->a = static_cast<float>(keyword == "d" ? *value : 1 - *value);
        }
    }
    return materials;
}

constexpr WordRules kObjRules{.comment = '#', .is_continued = true};

// Statements by what they do here. All of them are in the specification; others are none.
constexpr std::array<std::string_view, 5> kSurfaces{"surf", "bsp", "bzp", "cdp", "call"};
constexpr std::array<std::string_view, 3> kCurves{"curv", "curv2", "cdc"};
constexpr std::array<std::string_view, 28> kWithoutEffect{
    "vt",    "vp",    "g",          "s",         "mg",       "usemap", "maplib",
    "bevel", "lod",   "shadow_obj", "trace_obj", "cstype",   "deg",    "bmat",
    "step",  "parm",  "trim",       "hole",      "scrv",     "sp",     "end",
    "con",   "ctech", "c_interp",   "stech",     "d_interp", "csh",    "res"};

template <class List>
bool holds(const List& list, std::string_view word) {
    return std::ranges::find(list, word) != list.end();
}

/// Numbers given to names as they come.
class NameNumbers {
  public:
    std::uint32_t number_of(std::string_view name) {
        const auto next = static_cast<std::uint32_t>(names_.size());
        const auto [place, is_new] = numbers_.try_emplace(std::string(name), next);
        if (is_new) names_.emplace_back(name);
        return place->second;
    }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  private:
    std::unordered_map<std::string, std::uint32_t> numbers_;
    std::vector<std::string> names_;
};

/// The largest number of a kind that was used before it was there, if any, and where.
struct Ahead {
    std::uint64_t index = 0;
    std::size_t line = 0;
};

/// What is said of lines that are left out.
struct LeftOut {
    std::size_t lines = 0;  ///< l, p, and faces of less than three corners
    std::size_t curves = 0;
    std::size_t unknown = 0;
    std::size_t first_unknown_line = 0;
};

class ObjReader {
  public:
    ObjReader(std::string_view file,
              const std::string& name,
              const FilesBeside& beside,
              bool has_texcoords)
        : words_(file, kObjRules),
          beside_(&beside),
          file_name_(name),
          has_texcoords_(has_texcoords),
          object_(name) {}

    ImportReply read();

  private:
    void read_line();
    void read_face();
    void read_texcoord();
    ObjCorner read_corner(std::string_view word);
    std::uint32_t read_index(std::string_view word, std::size_t count, Ahead& ahead);
    void begin_run();
    [[nodiscard]] std::vector<glm::vec4> base_colors() const;
    [[nodiscard]] std::vector<std::string> notes() const;

    LineWords words_;
    const FilesBeside* beside_;
    std::string file_name_;
    bool has_texcoords_;
    std::string object_;    ///< the current one's name
    std::string material_;  ///< likewise
    bool is_new_run_ = true;
    NameNumbers objects_;
    NameNumbers materials_;
    std::vector<std::string> libraries_;
    ObjContent content_;
    Ahead ahead_position_;
    Ahead ahead_normal_;
    Ahead ahead_texcoord_;
    LeftOut left_out_;
};

/// The number from 0 that "7" or "-1" means, of `count` that are there so far.
std::uint32_t ObjReader::read_index(std::string_view word, std::size_t count, Ahead& ahead) {
    const auto number = core::parse_number<std::int64_t>(word);
    if (!number)
        words_.fail("a corner has the number " + in_quotes(word), "v, v/vt, v//vn or v/vt/vn");
    const std::int64_t from_1 =
        *number < 0 ? static_cast<std::int64_t>(count) + 1 + *number : *number;
    if (from_1 < 1 || from_1 > 0xfffffffe) {
        words_.fail(
            "a corner has the number " + std::string(word),
            count == 0 ? "numbers of vertices above"
                       : "1.." + std::to_string(count) + ", or -" + std::to_string(count) + "..-1");
    }
    const auto index = static_cast<std::uint64_t>(from_1);
    if (index > count && index > ahead.index) ahead = {index, words_.line()};
    return static_cast<std::uint32_t>(index - 1);
}

ObjCorner ObjReader::read_corner(std::string_view word) {
    const std::size_t first = std::min(word.find('/'), word.size());
    ObjCorner corner;
    corner.position = read_index(word.substr(0, first), content_.positions.size(), ahead_position_);
    if (first == word.size()) return corner;
    const std::size_t second = std::min(word.find('/', first + 1), word.size());
    const std::string_view texcoord = word.substr(first + 1, second - first - 1);
    if (has_texcoords_ && !texcoord.empty())
        corner.texcoord = read_index(texcoord, content_.texcoords.size(), ahead_texcoord_);
    if (second + 1 < word.size())
        corner.normal = read_index(word.substr(second + 1), content_.normals.size(), ahead_normal_);
    return corner;
}

void ObjReader::begin_run() {
    if (!std::exchange(is_new_run_, false)) return;
    content_.runs.push_back(
        {content_.ends.size(), objects_.number_of(object_), materials_.number_of(material_)});
}

void ObjReader::read_face() {
    const std::size_t before = content_.corners.size();
    for (std::string_view word = words_.word(); !word.empty(); word = words_.word())
        content_.corners.push_back(read_corner(word));
    if (content_.corners.size() < before + 3) {
        content_.corners.resize(before);
        ++left_out_.lines;
        return;
    }
    begin_run();
    content_.ends.push_back(content_.corners.size());
}

/// Without a second number that is 0.
void ObjReader::read_texcoord() {
    constexpr const char* kWhat = "a texture coordinate";
    const double u = words_.number(kWhat);
    content_.texcoords.emplace_back(u, words_.is_line_over() ? 1 : 1 - words_.number(kWhat));
}

void ObjReader::read_line() {
    const std::string_view keyword = words_.word();
    if (keyword == "v") {
        // A weight counts for curves only, a colour for nothing.
        content_.positions.push_back(words_.vector("a vertex's coordinate"));
    } else if (keyword == "f" || keyword == "fo") {
        read_face();
    } else if (keyword == "vn") {
        content_.normals.emplace_back(words_.vector("a normal's coordinate"));
    } else if (keyword == "vt" && has_texcoords_) {
        read_texcoord();
    } else if (keyword == "o") {
        object_ = words_.rest();
        if (object_.empty()) object_ = file_name_;
        is_new_run_ = true;
    } else if (keyword == "usemtl") {
        material_ = words_.rest();
        is_new_run_ = true;
    } else if (keyword == "mtllib") {
        libraries_.emplace_back(words_.rest());
    } else if (holds(kSurfaces, keyword)) {
        throw Refusal("",
                      "line " + std::to_string(words_.line()) + ": \"" + std::string(keyword) +
                          "\" is a surface that is not of polygons, which is not read",
                      "polygons, by f");
    } else if (keyword == "l" || keyword == "p") {
        ++left_out_.lines;
    } else if (holds(kCurves, keyword)) {
        ++left_out_.curves;
    } else if (!holds(kWithoutEffect, keyword)) {
        if (left_out_.unknown++ == 0) left_out_.first_unknown_line = words_.line();
    }
}

std::vector<std::string> ObjReader::notes() const {
    std::vector<std::string> notes;
    if (left_out_.lines > 0)
        notes.push_back(counted(left_out_.lines, "line") +
                        " of the file with lines or points: "
                        "left out");
    if (left_out_.curves > 0) notes.push_back(counted(left_out_.curves, "curve") + ": left out");
    if (left_out_.unknown > 0) {
        notes.push_back(counted(left_out_.unknown, "line") +
                        " that OBJ does not know, first line " +
                        std::to_string(left_out_.first_unknown_line) + ": left out");
    }
    return notes;
}

/// The colours of the materials in use; none if no library beside the file has one of them.
std::vector<glm::vec4> ObjReader::base_colors() const {
    if (!*beside_) return {};
    std::map<std::string, glm::vec4> known;
    for (const std::string& library : libraries_)
        known.merge(read_materials((*beside_)(library)));
    std::vector<glm::vec4> colors;
    bool is_any_known = false;
    for (const std::string& name : materials_.names()) {
        const auto found = known.find(name);
        is_any_known = is_any_known || found != known.end();
        colors.push_back(found == known.end() ? glm::vec4(1) : found->second);
    }
    return is_any_known ? colors : std::vector<glm::vec4>{};
}

void check_ahead(const Ahead& ahead, std::size_t count, const char* what) {
    if (ahead.index <= count) return;
    LineWords::fail_at(ahead.line,
                       "a corner has the " + std::string(what) + ' ' + std::to_string(ahead.index),
                       count == 0 ? "a file with some" : "1.." + std::to_string(count));
}

ImportReply ObjReader::read() {
    while (words_.next_line())
        read_line();
    check_ahead(ahead_position_, content_.positions.size(), "vertex");
    check_ahead(ahead_normal_, content_.normals.size(), "normal");
    check_ahead(ahead_texcoord_, content_.texcoords.size(), "texture coordinate");
    content_.objects = objects_.names();
    ImportReply reply;
    reply.meshes = meshes_of(content_);
    for (std::uint32_t m = 0; m < reply.meshes.size(); ++m)
        reply.instances.push_back({.mesh = m, .name = reply.meshes[m].name});
    reply.notes = notes();
    reply.base_colors = base_colors();
    const auto clear = std::ranges::count_if(reply.base_colors, [](auto& c) { return c.a < 1; });
    if (clear > 0) reply.notes.push_back(drawn_opaque(static_cast<std::size_t>(clear)));
    return reply;
}

}  // namespace

ImportReply read_obj(std::string_view file, const std::string& name) {
    return read_obj(file, name, {});
}

ImportReply read_obj(std::string_view file,
                     const std::string& name,
                     const FilesBeside& beside,
                     bool has_texcoords) {
    return ObjReader(file, name, beside, has_texcoords).read();
}

}  // namespace ink::import
