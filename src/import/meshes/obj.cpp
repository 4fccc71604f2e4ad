// Wavefront OBJ (Advanced Visualizer, appendix B1): what has an area.

#include <algorithm>
#include <array>
#include <charconv>
#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/parse_number.h"
#include "import/meshes/line_words.h"
#include "import/meshes/mesh_readers.h"
#include "import/meshes/obj_parts.h"
#include "import/meshes/polygons.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

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
