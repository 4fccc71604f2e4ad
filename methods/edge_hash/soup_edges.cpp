#include "methods/edge_hash/soup_edges.h"

#include <algorithm>
#include <array>
#include <utility>

#include "buffers/vertex_weld.h"
#include "core/numbering.h"
#include "scene/box.h"

namespace ink::methods {
namespace {

/// Lists each edge's faces beside each other; `edge_of` is per side of a face.
void list_faces(const std::vector<std::uint32_t>& edge_of, SoupEdges& soup) {
    std::uint32_t first = 0;
    for (SoupEdge& edge : soup.edges) {
        edge.first = first;
        first += edge.count;
        edge.count = 0;
    }
    soup.faces_at.resize(first);
    for (std::size_t side = 0; side < edge_of.size(); ++side) {
        const scene::Triangle& face = soup.faces[side / 3];
        const std::size_t i = side % 3;
        SoupEdge& edge = soup.edges[edge_of[side]];
        soup.faces_at[edge.first + edge.count++] = {
            static_cast<std::uint32_t>(side / 3),
            face[(i + 2) % 3],
            static_cast<std::int8_t>(face[i] == edge.a ? 1 : -1)};
    }
}

}  // namespace

SoupEdges find_edges(const Soup& soup, double epsilon) {
    buffers::VertexWeld weld =
        buffers::weld_vertices(soup.points, epsilon * scene::box_of(soup.points).diagonal());
    buffers::WeldedFaces welded =
        buffers::weld_faces(weld, soup.points, soup.triangles, buffers::DoubleFaces::drop);

    SoupEdges found;
    found.vertex_of = std::move(weld.first_of);
    found.faces = std::move(welded.faces);
    // The third level of the key: edges by their two places.
    core::Numbering<std::array<std::uint32_t, 2>> numbers(found.faces.size() * 3);
    std::vector<std::uint32_t> edge_of;
    edge_of.reserve(found.faces.size() * 3);
    for (const scene::Triangle& face : found.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
            const auto [edge, is_new] = numbers.insert({a, b});
            if (is_new) found.edges.push_back({a, b, 0, 0});
            edge_of.push_back(edge);
            ++found.edges[edge].count;
        }
    }
    list_faces(edge_of, found);
    return found;
}

}  // namespace ink::methods
