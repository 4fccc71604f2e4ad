// PLY (Stanford's polygon file format, version 1.0).

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/error.h"
#include "import/meshes/line_words.h"
#include "import/meshes/mesh_readers.h"
#include "import/meshes/mesh_reply.h"
#include "import/meshes/ply_header.h"

namespace ink::import {
namespace {

static_assert(std::endian::native == std::endian::little);

/// What follows the header, number by number.
class PlyBody {
  public:
    PlyBody(std::string_view file, const PlyHeader& header)
        : format_(header.format),
          file_(file),
          at_(header.bytes),
          words_(file.substr(header.bytes), {}, header.lines + 1) {}

    [[nodiscard]] bool is_text() const { return format_ == PlyFormat::ascii; }

    void begin_row(const PlyElement& element, std::uint64_t row) {
        element_ = &element;
        row_ = row;
        if (is_text() && !words_.next_line()) fail_short();
    }
    void end_row() {
        if (!is_text() || words_.is_line_over()) return;
        words_.fail("more numbers than the properties of element " + quoted(element_->name),
                    "one line for each, of as many numbers as it has properties");
    }

    double value(PlyType type) {
        if (is_text()) return words_.number("a number of element " + quoted(element_->name));
        switch (type) {
            case PlyType::int8:
                return take<std::int8_t>();
            case PlyType::uint8:
                return take<std::uint8_t>();
            case PlyType::int16:
                return take<std::int16_t>();
            case PlyType::uint16:
                return take<std::uint16_t>();
            case PlyType::int32:
                return take<std::int32_t>();
            case PlyType::uint32:
                return take<std::uint32_t>();
            case PlyType::float32:
                return take<float>();
            case PlyType::float64:
                return take<double>();
        }
        return 0;
    }

    /// The length of a list whose entries take `bytes` each; it lies in the file.
    std::uint64_t length(PlyType type, std::size_t bytes) {
        const double length = value(type);
        if (!(length >= 0) || length != std::floor(length))
            fail("a list has " + shown(length) + " entries", "a whole number of 0 or more");
        // In a text each entry takes a digit and a blank, but for the last one's.
        const std::size_t left = is_text() ? file_.size() / 2 + 1 : (file_.size() - at_) / bytes;
        if (length > static_cast<double>(left)) fail_short();
        return static_cast<std::uint64_t>(length);
    }

    /// How many rows there can be at most, so that a hostile count allocates nothing.
    [[nodiscard]] std::uint64_t most_rows(const PlyElement& element) const {
        const std::size_t least = std::max<std::size_t>(
            is_text() ? 2 * element.properties.size() : element.least_bytes(), 1);
        return std::min<std::uint64_t>(element.count, file_.size() / least + 1);
    }

    [[noreturn]] void fail(const std::string& what, const std::string& accepted) const {
        if (is_text()) words_.fail(what, accepted);
        throw core::Error("", "byte " + std::to_string(at_) + ": " + what, accepted);
    }

    /// A number as whole as it is.
    [[nodiscard]] static std::string shown(double value) {
        const auto whole = static_cast<std::int64_t>(std::clamp(value, -1e15, 1e15));
        return static_cast<double>(whole) == value ? std::to_string(whole) : std::to_string(value);
    }

  private:
    template <class T>
    T take() {
        if (file_.size() - at_ < sizeof(T)) fail_short();
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), file_.data() + at_, sizeof(T));
        if (format_ == PlyFormat::binary_big_endian) std::reverse(raw.begin(), raw.end());
        at_ += sizeof(T);
        return std::bit_cast<T>(raw);
    }

    [[noreturn]] void fail_short() const {
        throw core::Error("",
                          "the file is cut short: it ends in element " + quoted(element_->name) +
                              ", row " + std::to_string(row_ + 1) + " of " +
                              std::to_string(element_->count),
                          "all rows that the header promises");
    }

    PlyFormat format_;
    std::string_view file_;
    std::size_t at_;
    LineWords words_;
    const PlyElement* element_ = nullptr;  ///< the one being read
    std::uint64_t row_ = 0;
};

/// Reads all rows of an element: `take(property, value)` gets every number outside lists,
/// `list(property, length)` and then `take` those of lists.
template <class Begin, class List, class Take>
void read_rows(PlyBody& body, const PlyElement& element, Begin begin, List list, Take take) {
    if (element.properties.empty()) return;  // a row takes nothing
    for (std::uint64_t row = 0; row < element.count; ++row) {
        body.begin_row(element, row);
        begin();
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
    }
}

/// What a file holds of a mesh while it is being read.
struct PlyMesh {
    ImportedMesh mesh;
    Polygons faces;
    std::uint64_t vertices = 0;  ///< that the header promises
};

/// The numbers of the properties called `names`; nothing unless all are there.
std::optional<std::array<std::size_t, 3>> find_all(const PlyElement& element,
                                                   const std::array<std::string_view, 3>& names) {
    std::array<std::size_t, 3> found{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto property = element.find(names[i]);
        if (!property || element.properties[*property].count_type) return std::nullopt;
        found[i] = *property;
    }
    return found;
}

void read_vertices(PlyBody& body, const PlyElement& element, ImportedMesh& mesh) {
    const auto places = find_all(element, {"x", "y", "z"});
    if (!places)
        LineWords::fail_at(element.line, "vertices lack x, y or z", "a number for each of them");
    const auto normals = find_all(element, {"nx", "ny", "nz"});
    bool is_float = !body.is_text();
    // Where each property's number goes; what is not wanted goes to the last place.
    std::array<double, 7> row{};
    std::vector<std::size_t> place_of(element.properties.size(), 6);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        place_of[(*places)[axis]] = axis;
        if (normals) place_of[(*normals)[axis]] = 3 + axis;
        is_float = is_float && element.properties[(*places)[axis]].type == PlyType::float32;
    }
    mesh.are_floats = is_float;
    mesh.positions.reserve(body.most_rows(element));
    if (normals) mesh.normals.reserve(body.most_rows(element));
    const auto store = [&] {
        mesh.positions.emplace_back(row[0], row[1], row[2]);
        if (normals) mesh.normals.emplace_back(row[3], row[4], row[5]);
    };
    bool is_first = true;
    read_rows(
        body,
        element,
        [&] {
            if (!std::exchange(is_first, false)) store();
        },
        [](std::size_t, std::uint64_t) {},
        [&](std::size_t p, double value) { row[place_of[p]] = value; });
    if (!is_first) store();
}

/// The list of vertices of an element of faces.
std::size_t index_list(const PlyElement& element) {
    for (const char* name : {"vertex_indices", "vertex_index"}) {
        const auto property = element.find(name);
        if (property && element.properties[*property].count_type) return *property;
    }
    LineWords::fail_at(element.line,
                       "element " + quoted(element.name) + " has no list of vertices",
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
    std::size_t length = 0;
    read_rows(
        body,
        element,
        [] {},
        [&](std::size_t p, std::uint64_t entries) {
            if (p != indices) return;
            length += entries;
            to.faces.ends.push_back(to.faces.corners.size() + entries);
        },
        [&](std::size_t p, double value) {
            if (p == indices) to.faces.corners.push_back(to_index(value, body, to.vertices));
        });
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
        [&] { strips.restart(); },
        [](std::size_t, std::uint64_t) {},
        [&](std::size_t p, double value) {
            if (p != indices) return;
            if (value == -1) return strips.restart();
            strips.add(to_index(value, body, to.vertices));
        });
}

void skip_rows(PlyBody& body, const PlyElement& element) {
    read_rows(
        body, element, [] {}, [](std::size_t, std::uint64_t) {}, [](std::size_t, double) {});
}

const PlyElement* find_element(const PlyHeader& header, std::string_view name) {
    const PlyElement* found = nullptr;
    for (const PlyElement& element : header.elements) {
        if (element.name != name) continue;
        if (found != nullptr)
            LineWords::fail_at(element.line, "a second element " + quoted(name), "one of a name");
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
