#include "buffers/filled_lines.h"

#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "core/parallel.h"
#include "scene/components.h"
#include "scene/predicates.h"
#include "scene/topology.h"

namespace ink::buffers {
namespace {

/// An edge as one of its faces runs through it: joins the corners of the face's triangle that lie
/// where the welded vertices do.
raster::Line line_of(const scene::Topology& topology,
                     const scene::Surface& surface,
                     const scene::Face& face,
                     const scene::Edge& edge) {
    const auto corner_at = [&](std::uint32_t vertex) {
        for (const std::uint32_t corner : surface.triangles[face.triangle]) {
            if (surface.p_world[corner] == topology.p_world[vertex]) return corner;
        }
        assert(false && "a face has corners that its triangle has not");
        return std::uint32_t{0};
    };
    for (std::size_t i = 0; i < 3; ++i) {
        if (face.vertices[i] == edge.a && face.vertices[(i + 1) % 3] == edge.b)
            return {corner_at(edge.a), corner_at(edge.b)};
    }
    return {corner_at(edge.b), corner_at(edge.a)};
}

/// Whether an edge only cuts a flat polygon in two.
bool is_inner(const scene::Topology& topology, const scene::Edge& edge) {
    if (edge.face_count != 2) return false;
    const auto faces = topology.faces_of(edge);
    const scene::Face& a = topology.faces[faces[0]];
    const scene::Face& b = topology.faces[faces[1]];
    return a.object == b.object && a.material == b.material &&
           scene::deviation_rad(topology, edge, faces[0], faces[1]) < scene::kFlat_rad;
}

}  // namespace

TriangleEdges::Lines TriangleEdges::lines_of(const scene::PreparedScene& scene) const {
    Lines found;
    const auto welded = scene.topology();
    const scene::Topology& topology = *welded;
    for (const scene::Edge& edge : topology.edges) {
        if (edges_ == WireEdges::polygons && is_inner(topology, edge)) continue;
        // Faces are grouped by edge in ascending order, so those of one object stand together.
        const auto faces = topology.faces_of(edge);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const scene::Face& face = topology.faces[faces[i]];
            const bool has_next =
                i + 1 < faces.size() && topology.faces[faces[i + 1]].object == face.object;
            if (has_next) ++i;
            found.lines.push_back(line_of(topology, surface(), face, edge));
            found.lines.back().is_both_ways = has_next;
            found.faces.push_back({face.triangle, topology.faces[faces[i]].triangle});
        }
    }
    return found;
}

void TriangleEdges::find_lines(const scene::PreparedScene& scene) {
    const std::string name = fmt::format("triangle edges {}", static_cast<int>(edges_));
    lines_ = scene.get(name, [&] { return lines_of(scene); });
}

void TriangleEdges::prepare(const scene::PreparedScene& scene) {
    DepthFill::prepare(scene);
    find_lines(scene);
}

void TriangleEdges::pose(const scene::PreparedScene& scene) {
    const Posed posed = inputs().pose(scene);
    const bool may_bend = edges_ == WireEdges::polygons && posed == Posed::moved;
    if (may_bend || posed == Posed::anew) find_lines(scene);
}

void TriangleEdges::find_sides(const method::Frame& frame) {
    constexpr std::size_t kRun = 4096;
    const std::size_t count = surface().triangles.size();
    sides_.resize(count);
    core::parallel_for((count + kRun - 1) / kRun, frame.threads, [&](std::size_t run) {
        const std::size_t last = std::min(count, (run + 1) * kRun);
        for (std::size_t i = run * kRun; i < last; ++i) {
            const scene::Triangle& t = surface().triangles[i];
            const std::vector<glm::dvec3>& p = surface().p_world;
            sides_[i] = static_cast<std::int8_t>(
                scene::facing(p[t[0]], p[t[1]], p[t[2]], frame.view.camera.viewpoint()));
        }
    });
}

std::span<const raster::Line> TriangleEdges::lines_of_side(int side, const method::Frame& frame) {
    find_sides(frame);
    shown_.clear();
    const auto shows = [&](std::uint32_t face) {
        return side < 0 ? sides_[face] < 0 : sides_[face] >= 0;
    };
    for (std::size_t i = 0; i < lines_->lines.size(); ++i) {
        const raster::Line& line = lines_->lines[i];
        const Faces& faces = lines_->faces[i];
        const bool shows_first = shows(faces.first);
        const bool shows_second = line.is_both_ways && shows(faces.second);
        if (shows_first) shown_.push_back({line.from, line.to, shows_second});
        if (!shows_first && shows_second) shown_.push_back({line.to, line.from});
    }
    return shown_;
}

/// 255 where a line is seen; lines behind fills count among what is hidden.
raster::SkipCounts FilledLinesMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    out.fill(0);
    raster::MeshInput fills = pass().see(frame);
    raster::LineInput lines;
    choose(frame, pass(), fills, lines);
    raster::SkipCounts skips = pass().fill(fills);

    lines.p_world = pass().surface().p_world;
    lines.view = frame.view;
    lines.threads = frame.threads;
    lines.skips_hidden = frame.skips.has(raster::Skip::occlusion_culling);
    const raster::LineCounts counts = line_pass_.draw(lines, pass().depth(), out);
    raster::SkipCount& hidden = raster::count_of(skips, raster::Skip::occlusion_culling);
    hidden.skipped += counts.hidden;
    hidden.of += counts.lines;
    return skips;
}

}  // namespace ink::buffers
