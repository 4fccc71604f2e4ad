// PLY (Stanford's polygon file format, version 1.0).

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "import/meshes/line_words.h"
#include "import/meshes/mesh_readers.h"
#include "import/meshes/ply_parts.h"
#include "import/meshes/polygons.h"

namespace ink::import {
namespace {

/// Reads all rows of an element: `take(property, value)` gets every number outside lists,
/// `list(property, length)` and then `take` those of lists; `end()` follows each row.
template <class List, class Take, class End>
void read_rows(PlyBody& body, const PlyElement& element, List list, Take take, End end) {
    if (element.properties.empty()) return;  // a row takes nothing
    for (std::uint64_t row = 0; row < element.count; ++row) {
        body.begin_row(element, row);
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            std::uint64_t length = 1;
            if (property.count_type) {
                length = body.length(*property.count_type, bytes_of(property.type));
                list(p, length);
            }
            for (std::uint64_t i = 0; i < length; ++i)
                take(p, body.value(property.type));
        }
        body.end_row();
        end();
    }
}

/// What a file holds of a mesh while it is being read.
struct PlyMesh {
    ImportedMesh mesh;
    Polygons faces;
    std::uint64_t vertices = 0;  ///< that the header promises
};

/// The numbers of the properties called `names`; nothing unless all are there.
template <std::size_t N>
std::optional<std::array<std::size_t, N>> find_all(const PlyElement& element,
                                                   const std::array<std::string_view, N>& names) {
    std::array<std::size_t, N> found{};
    for (std::size_t i = 0; i < N; ++i) {
        const auto property = element.find(names[i]);
        if (!property || element.properties[*property].count_type) return std::nullopt;
        found[i] = *property;
    }
    return found;
}

/// Where texture coordinates are, by the names that programs give them.
std::optional<std::array<std::size_t, 2>> find_texcoords(const PlyElement& element) {
    auto found = find_all<2>(element, {"s", "t"});
    if (!found) found = find_all<2>(element, {"u", "v"});
    return found ? found : find_all<2>(element, {"texture_u", "texture_v"});
}

void read_vertices(PlyBody& body, const PlyElement& element, ImportedMesh& mesh) {
    const auto places = find_all<3>(element, {"x", "y", "z"});
    if (!places)
        LineWords::fail_at(element.line, "vertices lack x, y or z", "a number for each of them");
    const auto normals = find_all<3>(element, {"nx", "ny", "nz"});
    const auto texcoords = find_texcoords(element);
    bool is_float = !body.is_text();
    // Where each property's number goes; what is not wanted goes to the last place.
    std::array<double, 9> row{};
    std::vector<std::size_t> place_of(element.properties.size(), 8);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        place_of[(*places)[axis]] = axis;
        if (normals) place_of[(*normals)[axis]] = 3 + axis;
        is_float = is_float && element.properties[(*places)[axis]].type == PlyType::float32;
    }
    for (std::size_t i = 0; texcoords && i < 2; ++i)
        place_of[(*texcoords)[i]] = 6 + i;
    mesh.are_floats = is_float;
    mesh.positions.reserve(body.most_rows(element));
    if (normals) mesh.normals.reserve(body.most_rows(element));
    read_rows(
        body,
        element,
        [](std::size_t, std::uint64_t) {},
        [&](std::size_t p, double value) { row[place_of[p]] = value; },
        [&] {
            mesh.positions.emplace_back(row[0], row[1], row[2]);
            if (normals) mesh.normals.emplace_back(row[3], row[4], row[5]);
            if (texcoords) mesh.texcoords.emplace_back(row[6], 1 - row[7]);
        });
}

/// The list of vertices of an element of faces.
std::size_t index_list(const PlyElement& element) {
    for (const char* name : {"vertex_indices", "vertex_index"}) {
        const auto property = element.find(name);
        if (property && element.properties[*property].count_type) return *property;
    }
    LineWords::fail_at(element.line,
                       "element " + in_quotes(element.name) + " has no list of vertices",
                       "a list called vertex_indices or vertex_index");
}

std::uint32_t to_index(double value, const PlyBody& body, std::uint64_t vertices) {
    if (!(value >= 0 && value < static_cast<double>(vertices)) || value != std::floor(value)) {
        body.fail("a face has the vertex " + PlyBody::shown(value),
                  vertices == 0 ? "a file with vertices" : "0.." + std::to_string(vertices - 1));
    }
    return static_cast<std::uint32_t>(value);
}

void read_faces(PlyBody& body, const PlyElement& element, PlyMesh& to) {
    const std::size_t indices = index_list(element);
    to.faces.ends.reserve(to.faces.ends.size() + body.most_rows(element));
    read_rows(
        body,
        element,
        [&](std::size_t p, std::uint64_t entries) {
            if (p != indices) return;
            to.faces.ends.push_back(to.faces.corners.size() + entries);
        },
        [&](std::size_t p, double value) {
            if (p == indices) to.faces.corners.push_back(to_index(value, body, to.vertices));
        },
        [] {});
}

/// Triangles as OpenGL draws strips: every second one is turned, and -1 begins anew.
class Strips {
  public:
    explicit Strips(Polygons& faces) : faces_(&faces) {}
    void restart() { count_ = 0; }
    void add(std::uint32_t v) {
        if (count_ >= 2) {
            const bool is_odd = count_ % 2 == 1;
            for (const std::uint32_t corner :
                 {is_odd ? last_[1] : last_[0], is_odd ? last_[0] : last_[1], v})
                faces_->corners.push_back(corner);
            faces_->ends.push_back(faces_->corners.size());
        }
        last_ = {last_[1], v};
        ++count_;
    }

  private:
    Polygons* faces_;
    std::array<std::uint32_t, 2> last_{};
    std::uint64_t count_ = 0;
};

void read_strips(PlyBody& body, const PlyElement& element, PlyMesh& to) {
    const std::size_t indices = index_list(element);
    Strips strips(to.faces);
    read_rows(
        body,
        element,
        [](std::size_t, std::uint64_t) {},
        [&](std::size_t p, double value) {
            if (p != indices) return;
            if (value == -1) return strips.restart();
            strips.add(to_index(value, body, to.vertices));
        },
        [&] { strips.restart(); });
}

void skip_rows(PlyBody& body, const PlyElement& element) {
    read_rows(
        body, element, [](std::size_t, std::uint64_t) {}, [](std::size_t, double) {}, [] {});
}

const PlyElement* find_element(const PlyHeader& header, std::string_view name) {
    const PlyElement* found = nullptr;
    for (const PlyElement& element : header.elements) {
        if (element.name != name) continue;
        if (found != nullptr)
            LineWords::fail_at(
                element.line, "a second element " + in_quotes(name), "one of a name");
        found = &element;
    }
    return found;
}

}  // namespace

ImportReply read_ply(std::string_view file, const std::string& name) {
    const PlyHeader header = read_ply_header(file);
    const PlyElement* vertices = find_element(header, "vertex");
    if (vertices == nullptr)
        throw core::Error("", "the header has no element \"vertex\"", "one with x, y and z");
    if (vertices->count > 0xfffffffeU)
        LineWords::fail_at(vertices->line, "too many vertices", "up to 4294967294");
    PlyMesh mesh;
    mesh.mesh.name = name;
    mesh.vertices = vertices->count;
    PlyBody body(file, header);
    std::uint64_t edges = 0;
    for (const PlyElement& element : header.elements) {
        if (&element == vertices) {
            read_vertices(body, element, mesh.mesh);
        } else if (element.count == 0) {
            continue;
        } else if (element.name == "face") {
            read_faces(body, element, mesh);
        } else if (element.name == "tristrips") {
            read_strips(body, element, mesh);
        } else {
            skip_rows(body, element);
            if (element.name == "edge") edges = element.count;
        }
    }
    ImportReply reply = reply_of_mesh(std::move(mesh.mesh), mesh.faces);
    if (edges > 0) reply.notes.push_back(counted(edges, "edge") + " without faces: left out");
    return reply;
}

}  // namespace ink::import
