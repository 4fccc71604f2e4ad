#include "import/fbx/geometry.h"

#include <algorithm>
#include <string>

#include "import/meshes/polygons.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

[[noreturn]] void fail_geometry(const FbxObject& geometry, const std::string& what) {
    throw core::Error("", "geometry \"" + geometry.name + "\": " + what, "a whole, valid FBX file");
}

/// The slot of each polygon's material; an array that does not fit counts as none.
std::vector<std::size_t> slots_of(const FbxObject& geometry, std::size_t polygons) {
    std::vector<std::size_t> slots(polygons, 0);
    const FbxElement* layer = geometry.element->child("LayerElementMaterial");
    if (layer == nullptr) return slots;
    const std::vector<double> list = layer->list("Materials");
    const bool is_each = layer->word("MappingInformationType") == "ByPolygon";
    if (list.empty() || (is_each && list.size() < polygons)) return slots;
    for (std::size_t p = 0; p < polygons; ++p)
        if (const double slot = list[is_each ? p : 0]; slot > 0)
            slots[p] = static_cast<std::size_t>(std::min(slot, 1e6));
    return slots;
}

}  // namespace

std::vector<glm::dvec3> points_of(const FbxObject& geometry) {
    const std::vector<double> numbers = geometry.element->list("Vertices");
    if (numbers.size() % 3 != 0) fail_geometry(geometry, "its Vertices are not three numbers each");
    std::vector<glm::dvec3> points(numbers.size() / 3);
    for (std::size_t p = 0; p < points.size(); ++p)
        points[p] = {numbers[3 * p], numbers[3 * p + 1], numbers[3 * p + 2]};
    return points;
}

FbxCorners corners_of(const FbxObject& geometry, std::size_t points) {
    FbxCorners corners;
    for (const double number : geometry.element->list("PolygonVertexIndex")) {
        const bool is_last = number < 0;
        const double point = is_last ? -1 - number : number;
        if (!(point >= 0 && point < static_cast<double>(points)))
            fail_geometry(geometry, "a polygon has a point that is not there");
        corners.points.push_back(static_cast<std::uint32_t>(point));
        if (is_last) corners.ends.push_back(corners.points.size());
    }
    if (!corners.points.empty() &&
        (corners.ends.empty() || corners.ends.back() != corners.points.size()))
        fail_geometry(geometry, "its last polygon has no end");
    if (const FbxElement* holes = geometry.element->child("LayerElementHole")) {
        const std::vector<double> list = holes->list("Hole");
        if (std::any_of(list.begin(), list.end(), [](double hole) { return hole != 0; })) {
            throw Refusal(
                "",
                "geometry \"" + geometry.name + "\": polygons that are holes are not read",
                "polygons without LayerElementHole");
        }
    }
    corners.materials = slots_of(geometry, corners.ends.size());
    return corners;
}

std::vector<glm::dvec3> normals_of(const FbxObject& geometry, const FbxCorners& corners) {
    const FbxElement* layer = geometry.element->child("LayerElementNormal");
    if (layer == nullptr) return {};
    const std::vector<double> numbers = layer->list("Normals");
    const std::vector<double> indices = layer->list("NormalsIndex");
    const bool is_direct = layer->word("ReferenceInformationType") == "Direct" || indices.empty();
    const std::string mapping = layer->word("MappingInformationType");
    std::vector<glm::dvec3> normals;
    for (std::size_t c = 0, polygon = 0; c < corners.points.size(); ++c) {
        while (c >= corners.ends[polygon])
            ++polygon;
        std::size_t i = mapping == "ByPolygonVertex" ? c : corners.points[c];
        if (mapping == "ByPolygon") i = polygon;
        if (mapping == "AllSame") i = 0;
        const double at = is_direct ? static_cast<double>(i) : i < indices.size() ? indices[i] : -1;
        if (!(at >= 0 && 3 * at + 2 < static_cast<double>(numbers.size()))) return {};
        const auto n = 3 * static_cast<std::size_t>(at);
        normals.emplace_back(numbers[n], numbers[n + 1], numbers[n + 2]);
    }
    return normals;
}

std::size_t append_polygons(const FbxCorners& corners,
                            const std::vector<glm::dvec3>& positions,
                            const std::vector<std::uint32_t>& numbers,
                            std::uint32_t none,
                            ImportedMesh& mesh) {
    std::vector<std::size_t> slots;  // in the order in which they come
    std::vector<Polygons> polygons_of;
    std::vector<std::size_t> place;  // by slot, one more than that in `slots`
    std::size_t begin = 0;
    for (std::size_t p = 0; p < corners.ends.size(); ++p) {
        const std::size_t slot = corners.materials[p];
        if (slot >= place.size()) place.resize(slot + 1, 0);
        if (place[slot] == 0) {
            slots.push_back(slot);
            polygons_of.emplace_back();
            place[slot] = slots.size();
        }
        Polygons& polygons = polygons_of[place[slot] - 1];
        for (; begin < corners.ends[p]; ++begin)
            polygons.corners.push_back(static_cast<std::uint32_t>(begin));
        polygons.ends.push_back(polygons.corners.size());
    }
    const auto first_vertex = static_cast<std::uint32_t>(mesh.positions.size());
    std::size_t poor = 0;
    for (std::size_t s = 0; s < slots.size(); ++s) {
        mesh.parts.push_back({.first_triangle = static_cast<std::uint32_t>(mesh.triangles.size()),
                              .material = slots[s] < numbers.size() ? numbers[slots[s]] : none});
        poor += count_without_area(polygons_of[s]);
        for (const scene::Triangle& triangle : triangles_of(polygons_of[s], positions))
            mesh.triangles.push_back({triangle[0] + first_vertex,
                                      triangle[1] + first_vertex,
                                      triangle[2] + first_vertex});
    }
    mesh.positions.insert(mesh.positions.end(), positions.begin(), positions.end());
    return poor;
}

}  // namespace ink::import
