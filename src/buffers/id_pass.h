#pragma once

#include <cstdint>
#include <vector>

#include "buffers/surface_ids.h"
#include "buffers/surface_inputs.h"
#include "method/method.h"

namespace ink::buffers {

/// The parameters of whatever draws ids; who offers no depth format has q32.
struct IdParams {
    IdSource of = IdSource::object_and_patch;
    double crease_deg = 40;
    double weld_epsilon = 1e-4;  // found: the least that closes cracks, see ids.md
    Samples samples = Samples::centre;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
};

/// Appends the rows of IdParams but depth_format to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_id_params(core::ParamTable<P>& table) {
    table
        .choice(&P::of,
                "of",
                {"object", "patch", "object_and_patch", "triangle"},
                "What has an id of its own: objects, smooth patches, both, or every triangle.")
        .number(&P::crease_deg,
                "crease_deg",
                {0, 180},
                "deg",
                "Least dihedral deviation of an edge between two smooth patches.")
        .number(&P::weld_epsilon,
                "weld_epsilon",
                {0, 0.01},
                "",
                "Vertices of an object this near are welded for its patches, as a share of its "
                "diagonal.");
    return add_samples_param(table);
}

/// Which pixels show a border between two ids.
enum class BorderSide {
    nearer,  ///< one pixel wide, on the surface that is in front
    both,    ///< two: each pixel that has another id beside it
};

/// Appends the row `side` to a table whose struct has such a member.
template <class P>
core::ParamTable<P>& add_side_param(core::ParamTable<P>& table) {
    return table.choice(
        &P::side,
        "side",
        {"nearer", "both"},
        "Where a border's line lies: one pixel on the nearer surface, or both sides of it. "
        "With corner samples it lies in the pixel between, and this has no meaning.");
}

/// A scene drawn as ids: the pass's constant, nothing interpolated.
///
/// prepare, pose, then draw for every frame. After a draw that may keep still tiles, `finish`
/// copies what was not drawn.
class IdPass {
  public:
    IdPass(const IdParams& params, int halo_px);

    void prepare(const scene::Scene& scene);
    /// See SurfaceInputs::prepare_like; ids are taken over, too, if they are of the same.
    [[nodiscard]] bool prepare_like(const IdPass& other, const scene::Scene& scene);
    void pose(const scene::Scene& scene);
    [[nodiscard]] bool is_empty() const { return inputs_.is_empty(); }
    [[nodiscard]] const raster::PassFormat& format() const { return format_; }

    /// Hands every tile of samples to `sink`, whose plane 0 is u32 ids, kNoId where nothing is.
    /// Where nothing moved since the last frame, `may_keep_still` lets it leave tiles out.
    [[nodiscard]] raster::MeshResult draw(const method::Frame& frame,
                                          bool may_keep_still,
                                          raster::TileSink& sink);
    /// The frame of a method that draws all its lines from the tiles it is handed: still tiles are
    /// kept. `sink` writes to `out`. Returns what was skipped. The scene is not empty.
    raster::SkipCounts draw_lines(const method::Frame& frame,
                                  raster::TileSink& sink,
                                  edge::EdgeImage& out);
    /// `ids`: a colour for every id, sky black; of pixel corners, that of the upper left one. Drawn
    /// anew.
    [[nodiscard]] method::Layer layer(const method::Frame& frame);
    void finish(const raster::MeshResult& result, edge::EdgeImage& out) {
        inputs_.finish(result, out);
    }

    /// What a pass of this format costs; the filter is the method's to add.
    [[nodiscard]] method::Cost cost() const;

  private:
    [[nodiscard]] std::vector<std::uint32_t> ids_of(const scene::Scene& scene) const;

    IdParams params_;
    raster::PassFormat format_;
    SurfaceInputs inputs_;
    raster::MeshPass pass_;
    std::vector<std::uint32_t> ids_;
    std::uint64_t posed_hash_ = 0;
    bool have_ids_changed_ = false;  ///< since the last draw: then no tile is still
};

}  // namespace ink::buffers
