#include "report/live_page.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <type_traits>
#include <utility>

#include "core/numbering.h"
#include "report/page_template.h"

namespace ink::report {
namespace {

using methods::LookupTable;
using methods::Twin;

/// Whole numbers in the order of floats.
std::int32_t in_order(float value) {
    const auto bits = std::bit_cast<std::int32_t>(value);
    return bits ^ (bits >> 31 & 0x7fffffff);
}

/// Arrays of whole numbers one after the other.
class ArrayWriter {
  public:
    /// Writes of each number what that of `base` (of none: 0) does not tell.
    template <class T>
    void put(const std::vector<T>& values, const std::vector<T>& base = {}) {
        put_rests(values, base, values.size());
    }
    /// The same of how they differ from the numbers `stride` before.
    template <class T>
    void put_steps(const std::vector<T>& values,
                   std::size_t stride,
                   const std::vector<T>& base = {}) {
        put_rests(values, base, stride);
    }
    [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  private:
    template <class T>
    void put_rests(const std::vector<T>& values, const std::vector<T>& base, std::size_t stride) {
        using Word = std::make_unsigned_t<T>;
        constexpr int kBits = 8 * sizeof(T);
        std::vector<Word> rests(values.size());
        for (std::size_t i = 0; i < rests.size(); ++i)
            rests[i] = static_cast<Word>(values[i] - (base.empty() ? T{} : base[i]));
        for (std::size_t i = rests.size(); i-- > stride;)
            rests[i] = static_cast<Word>(rests[i] - rests[i - stride]);
        for (Word& rest : rests)  // small numbers of either sign are small ones
            rest = static_cast<Word>(rest << 1U ^ (rest >> (kBits - 1) ? ~Word{} : Word{}));
        for (int shift = 0; shift < kBits; shift += 8)
            for (const Word rest : rests)
                bytes_.push_back(static_cast<std::uint8_t>(rest >> shift));
    }

    std::vector<std::uint8_t> bytes_;
};

/// Numbers that first appear in order, by how far they lie below the next new one.
std::vector<std::uint32_t> below_next(const std::vector<std::uint32_t>& numbers) {
    std::vector<std::uint32_t> below;
    std::uint32_t next = 0;
    for (const std::uint32_t number : numbers) {
        below.push_back(next - number);
        next = std::max(next, number + 1);
    }
    return below;
}

/// What twins would be were each edge that joins the same two points that of two faces.
std::vector<std::uint32_t> guessed_twins(const std::vector<LookupTable::Face>& faces) {
    std::vector<std::uint32_t> twins(3 * faces.size(), Twin().word);
    core::Numbering<std::array<std::uint32_t, 2>> known(2 * faces.size());
    std::vector<std::uint32_t> first_of;
    const auto guess = [&](std::uint32_t edge, std::uint32_t other) {
        const LookupTable::Face &mine = faces[edge / 3], &theirs = faces[other / 3];
        const bool is_turned = mine.corners[edge % 3] == theirs.corners[other % 3];
        const bool is_line = (mine.rest >> 3 * (edge % 3) & 7U) != 0;
        twins[edge] = Twin::of(other / 3, other % 3).word | (is_turned ? Twin::kTurned : 0) |
                      (is_line ? Twin::kClosed : 0);
    };
    for (std::uint32_t edge = 0; edge < twins.size(); ++edge) {
        const auto& corners = faces[edge / 3].corners;
        const auto [low, high] = std::minmax(corners[edge % 3], corners[(edge + 1) % 3]);
        const auto [number, is_new] = known.insert({low, high});
        if (is_new) {
            first_of.push_back(edge);
        } else {
            guess(first_of[number], edge);
            guess(edge, first_of[number]);
        }
    }
    return twins;
}

void put_faces(ArrayWriter& arrays, const std::vector<LookupTable::Face>& faces) {
    std::vector<std::uint32_t> corners, patches, rests, twins = guessed_twins(faces);
    for (const LookupTable::Face& face : faces) {
        corners.insert(corners.end(), face.corners.begin(), face.corners.end());
        patches.push_back(face.patch);
        rests.push_back(face.rest);
        for (std::size_t i = 0; i < 3; ++i)
            twins[3 * rests.size() - 3 + i] ^= face.twins[i];
    }
    arrays.put(below_next(corners));
    arrays.put_steps(patches, 1);
    arrays.put_steps(rests, 1);
    arrays.put(twins);
}

/// Where vertices are: places by number, of which the lookup's points are the first.
struct Places {
    std::vector<std::int32_t> numbers;  ///< three a place, in_order()
    std::vector<std::uint32_t> of_vertex;
    [[nodiscard]] std::size_t count() const { return numbers.size() / 3; }
};

Places places_of(const bake::CodedMesh& mesh) {
    Places places;
    core::Numbering<std::array<std::int32_t, 3>> known(mesh.lookup.p_world.size());
    std::vector<std::uint32_t> first;  // by the number that `known` gives
    const auto find = [&](const glm::vec3& p, bool is_point) {
        const std::array<std::int32_t, 3> words = {in_order(p.x), in_order(p.y), in_order(p.z)};
        const auto [number, is_new] = known.insert(words);
        if (is_new) first.push_back(static_cast<std::uint32_t>(places.count()));
        if (is_new || is_point)
            places.numbers.insert(places.numbers.end(), words.begin(), words.end());
        return first[number];
    };
    for (const glm::vec4& p : mesh.lookup.p_world)
        find(glm::vec3(p), true);
    for (const glm::vec3& p : mesh.p_world)
        places.of_vertex.push_back(find(p, false));
    return places;
}

/// Unit vectors as 16-bit numbers, 32767 for 1, a fourth one after each.
template <class Vectors>
std::vector<std::int16_t> short_normals(const Vectors& normals) {
    std::vector<std::int16_t> numbers;
    numbers.reserve(4 * normals.size());
    for (const auto& n : normals) {
        for (int i = 0; i < 3; ++i)
            numbers.push_back(static_cast<std::int16_t>(std::lround(n[i] * 32767)));
        numbers.push_back(0);
    }
    return numbers;
}

/// The angle between two vectors within a hundred-thousandth, of whose cross product that is the
/// length: by operations that give the same bits in JavaScript.
double angle_rad(const glm::dvec3& u, const glm::dvec3& v, double cross) {
    const double tangent = cross / (std::sqrt(glm::dot(u, u) * glm::dot(v, v)) + glm::dot(u, v));
    const bool is_steep = !(tangent <= 1);  // of half the angle; of a half turn infinite or none
    const double t = is_steep ? 1 / tangent : tangent, tt = t * t;
    const double arc =
        t * (0.9998660 + tt * (-0.3302995 + tt * (0.1801410 + tt * (-0.0851330 + tt * 0.0208351))));
    return 2 * (is_steep ? 1.5707963 - arc : arc);
}

/// The normals that the triangles round the places of the vertices tell: means by their angles
/// there, as the methods' normals are where no crease parts them.
std::vector<std::int16_t> told_normals(const bake::CodedMesh& mesh,
                                       std::span<const glm::vec3> p_world,
                                       const Places& places) {
    std::vector<glm::dvec3> sums(places.count(), glm::dvec3(0));
    for (std::size_t at = 0; at < mesh.indices.size(); at += 3) {
        const std::uint32_t* const v = mesh.indices.data() + at;
        const glm::dvec3 p[] = {p_world[v[0]], p_world[v[1]], p_world[v[2]]};
        const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double length = std::sqrt(glm::dot(normal, normal));
        if (!(length > 0)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 u = p[(i + 1) % 3] - p[i], w = p[(i + 2) % 3] - p[i];
            sums[places.of_vertex[v[i]]] += normal * (angle_rad(u, w, length) / length);
        }
    }
    for (glm::dvec3& sum : sums) {
        const double length = std::sqrt(glm::dot(sum, sum));
        sum = length > 0 ? sum * (1 / length) : glm::dvec3(0);
    }
    std::vector<glm::dvec3> of_vertices;
    for (const std::uint32_t place : places.of_vertex)
        of_vertices.push_back(sums[place]);
    return short_normals(of_vertices);
}

/// Those of hulls by what triangles tell, the others by those.
void put_normals(ArrayWriter& arrays,
                 const bake::CodedMesh& mesh,
                 const bake::MovingVertices& moved,
                 const Places& places) {
    const std::vector<std::int16_t> hull = short_normals(moved.hull_n_world);
    arrays.put_steps(hull, 4, told_normals(mesh, moved.p_world, places));
    arrays.put_steps(short_normals(moved.n_world), 4, hull);
}

std::vector<std::int32_t> ordered(std::span<const glm::vec3> places) {
    std::vector<std::int32_t> numbers;
    for (const glm::vec3& p : places)
        numbers.insert(numbers.end(), {in_order(p.x), in_order(p.y), in_order(p.z)});
    return numbers;
}

}  // namespace

PackedMesh packed_mesh(const bake::CodedMesh& mesh, std::span<const bake::MovingVertices> poses) {
    ArrayWriter arrays;
    put_faces(arrays, mesh.lookup.faces);
    const Places at = places_of(mesh);
    arrays.put_steps(at.numbers, 3);
    arrays.put_steps(at.of_vertex, 1);
    arrays.put(below_next(mesh.indices));
    put_normals(arrays, mesh, mesh, at);
    std::vector<std::int32_t> places = ordered(mesh.p_world);
    for (const bake::MovingVertices& pose : poses) {
        const auto places_before = std::exchange(places, ordered(pose.p_world));
        arrays.put_steps(places, 3, places_before);
        put_normals(arrays, mesh, pose, at);
    }
    arrays.put_steps(mesh.id, 1);
    arrays.put_steps(mesh.surface8, 1);
    arrays.put_steps(mesh.label8, 1);
    return {deflated(std::as_bytes(std::span(arrays.bytes()))), at.count()};
}

}  // namespace ink::report
