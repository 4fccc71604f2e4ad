// "Inked": a fat black wireframe first, then fills that polygon offset moves over it.

#include "methods/polygon_offset/polygon_offset.h"

namespace ink::methods {
namespace {

/// From the fastest to the most exact, the method as it comes among them; factor and units span the
/// plane over which its errors are drawn.
std::vector<core::ParamValues> sweep() {
    return {
        // Half the triangles, half the lines.
        {{"faces", "front"}, {"edges", "polygons"}},
        {{"faces", "front"}},
        {{"edges", "polygons"}},
        {},
        {{"depth_format", "z16"}},
        // Along factor: from specks all over slopes to what lies behind showing through.
        {{"factor", "0"}},
        {{"factor", "-0.125"}},
        {{"factor", "-0.25"}},
        {{"factor", "-0.75"}},
        {{"factor", "-1"}},
        {{"factor", "-2"}},
        {{"factor", "-4"}},
        // Along units: from specks on level faces to the same.
        {{"units", "0"}},
        {{"units", "-16"}},
        {{"units", "-256"}},
        {{"units", "-4096"}},
        // Against each other.
        {{"factor", "0"}, {"units", "-16"}},
        {{"factor", "0"}, {"units", "-256"}},
        {{"factor", "0"}, {"units", "-4096"}},
        {{"factor", "-0.25"}, {"units", "-256"}},
        // Twice as fat: the page's offset grows with the width.
        {{"width_px", "4"}},
        {{"width_px", "3"}},
    };
}

}  // namespace

core::ParamTable<PolygonOffsetInk::Params> PolygonOffsetInk::table() {
    core::ParamTable<Params> table;
    table
        .number(&Params::width_px,
                "width_px",
                {1, 16},
                "px",
                "Width of the wireframe's lines, to the nearest px; half of it is visible.")
        .number(&Params::factor,
                "factor",
                {-8, 8},
                "1/px",
                "Polygon offset's factor over the width: below 0 moves towards the eye.")
        .number(&Params::units,
                "units",
                {-65536, 65536},
                "steps",
                "Polygon offset's units: below 0 moves towards the eye.")
        .choice(&Params::edges,
                "edges",
                {"all", "polygons"},
                "Edges of all triangles, or without those inside a flat polygon.")
        .choice(&Params::faces,
                "faces",
                {"both", "front"},
                "Draw faces seen from both sides, or cull those seen from their back.")
        .choice(&Params::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth buffer: float 1/w, or whole steps of window depth.")
        .number(
            &Params::threshold, "threshold", {1, 255}, "", "Least edge response of a line pixel.");
    return table;
}

PolygonOffsetInk::PolygonOffsetInk(const Params& params)
    : buffers::FilledLinesMethod(params.edges, params.depth_format), params_(params) {}

void PolygonOffsetInk::choose(const method::Frame& frame,
                              buffers::TriangleEdges& scene,
                              raster::MeshInput& fills,
                              raster::LineInput& lines) const {
    const bool is_culled = params_.faces == Faces::front;
    fills.cull = is_culled ? raster::Cull::back : raster::Cull::none;
    // The page's width is a whole number; a factor of a width that is rounded must not be another.
    fills.offset = {params_.factor * raster::line_width_px(params_.width_px), params_.units};
    lines.lines = is_culled ? scene.lines_of_side(1, frame) : scene.lines();
    lines.width_px = params_.width_px;
}

method::MethodInfo polygon_offset() {
    method::MethodInfo info = method::method_info<PolygonOffsetInk>(
        "polygon_offset",
        "\"Inked\", a page on drawing outlines with polygon offset",
        "a fat black wireframe, fills moved over it by polygon offset");
    info.family = method::Family::edges_and_hulls;
    info.marker = method::Marker::diamond;
    info.tunables = {{"factor", {{-4, 0}}}, {"units", {{-65536, 0}}}};
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
