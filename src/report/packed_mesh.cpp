#include "report/packed_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/numbering.h"
#include "report/deflate.h"

namespace ink::report {
namespace {

using methods::LookupTable;
using methods::Twin;

/// Whole numbers in the order of floats.
std::int32_t in_order(float value) {
    const auto bits = std::bit_cast<std::int32_t>(value);
    return bits ^ (bits >> 31 & 0x7fffffff);
}

void append(std::vector<std::int32_t>& numbers, const glm::vec3& p) {
    numbers.insert(numbers.end(), {in_order(p.x), in_order(p.y), in_order(p.z)});
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

/// Writes the points, then further places of vertices, and which of them each vertex is at.
std::size_t put_places(ArrayWriter& arrays, const bake::CodedMesh& mesh) {
    core::Numbering<std::array<std::int32_t, 3>> known(mesh.lookup.p_world.size());
    std::vector<std::uint32_t> place_of, place_of_vertex;
    std::vector<std::int32_t> places;
    const auto find = [&](const glm::vec3& p, bool is_point) {
        const auto [number, is_new] = known.insert({in_order(p.x), in_order(p.y), in_order(p.z)});
        if (is_new) place_of.push_back(static_cast<std::uint32_t>(places.size() / 3));
        if (is_new || is_point) append(places, p);
        return place_of[number];
    };
    for (const glm::vec4& p : mesh.lookup.p_world)
        find(glm::vec3(p), true);
    for (const glm::vec3& p : mesh.p_world)
        place_of_vertex.push_back(find(p, false));
    arrays.put_steps(places, 3);
    arrays.put_steps(place_of_vertex, 1);
    return places.size() / 3;
}

/// Unit vectors as 16-bit numbers, 32767 for 1, a fourth one after each.
std::vector<std::int16_t> short_normals(std::span<const glm::vec3> normals) {
    std::vector<std::int16_t> numbers;
    numbers.reserve(4 * normals.size());
    for (const glm::vec3& n : normals) {
        for (int i = 0; i < 3; ++i)
            numbers.push_back(static_cast<std::int16_t>(std::lround(n[i] * 32767)));
        numbers.push_back(0);
    }
    return numbers;
}

std::vector<std::int32_t> ordered(std::span<const glm::vec3> places) {
    std::vector<std::int32_t> numbers;
    for (const glm::vec3& p : places)
        append(numbers, p);
    return numbers;
}

}  // namespace

PackedMesh packed_mesh(const bake::CodedMesh& mesh, std::span<const bake::MovingVertices> poses) {
    ArrayWriter arrays;
    put_faces(arrays, mesh.lookup.faces);
    const std::size_t place_count = put_places(arrays, mesh);
    std::vector<std::int32_t> places = ordered(mesh.p_world);
    std::vector<std::int16_t> normals = short_normals(mesh.n_world);
    arrays.put_steps(normals, 4);
    arrays.put_steps(short_normals(mesh.hull_n_world), 4, normals);
    for (const bake::MovingVertices& pose : poses) {
        const auto places_before = std::exchange(places, ordered(pose.p_world));
        const auto normals_before = std::exchange(normals, short_normals(pose.n_world));
        arrays.put_steps(places, 3, places_before);
        arrays.put_steps(normals, 4, normals_before);
        arrays.put_steps(short_normals(pose.hull_n_world), 4, normals);
    }
    arrays.put_steps(mesh.id, 1);
    arrays.put(below_next(mesh.indices));
    arrays.put_steps(mesh.surface8, 1);
    arrays.put_steps(mesh.label8, 1);
    return {deflated(std::as_bytes(std::span(arrays.bytes()))), place_count};
}

}  // namespace ink::report
