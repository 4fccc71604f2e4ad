#include "buffers/constant_pass.h"

namespace ink::buffers {

void ConstantPass::take(std::vector<std::uint32_t> constants) {
    have_changed_ = have_changed_ || constants != constants_;
    constants_ = std::move(constants);
    in_clusters_.clear();
}

void ConstantPass::prepare(const scene::PreparedScene& scene) {
    SurfacePass::prepare(scene);
    take(constants_of(scene));
    posed_hash_ = scene.hash();
    have_changed_ = true;
}

void ConstantPass::pose(const scene::PreparedScene& scene) {
    SurfacePass::pose(scene);
    in_clusters_.clear();
    const std::uint64_t hash = scene.hash();
    if (hash == posed_hash_ || !follows(scene)) return;
    take(constants_of(scene));
    posed_hash_ = hash;
}

/// Constants in the order in which the pass comes by its triangles.
void ConstantPass::order_constants(const raster::LaneMesh& mesh) {
    const std::vector<std::uint32_t>& ids = mesh.clusters().triangle_ids;
    if (in_clusters_.size() == ids.size()) return;
    in_clusters_.resize(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
        in_clusters_[i] = static_cast<std::uint8_t>(constants_[ids[i]]);
}

raster::MeshInput ConstantPass::see(const method::Frame& frame, bool may_leave_out) {
    inputs().see(frame);
    follow_view(frame);
    raster::MeshInput input = inputs().mesh_input(frame);
    input.constants = constants_;
    if (format().store == raster::Store::u8 && format().interpolants == 0) {
        order_constants(*input.mesh);
        input.constants_in_clusters = in_clusters_;
    }
    input.sky_code = {sky_};
    input.flat_gives_zero = flat_gives_zero_ && may_leave_out;
    input.may_keep_still = input.may_keep_still && may_leave_out;
    if (have_changed_ || !may_leave_out) input.moved_objects = std::nullopt;
    have_changed_ = false;
    return input;
}

raster::MeshResult ConstantPass::draw(const method::Frame& frame,
                                      bool may_leave_out,
                                      raster::TileSink& sink) {
    return SurfacePass::draw(see(frame, may_leave_out), sink);
}

raster::SkipCounts ConstantPass::draw_lines(const method::Frame& frame,
                                            raster::TileSink& sink,
                                            edge::EdgeImage& out) {
    const raster::MeshResult result = draw(frame, true, sink);
    inputs().finish(result, out);
    return result.skips;
}

raster::PassFormat constant_format(raster::Store store, raster::DepthFormat depth, int halo_px) {
    return {.constant = true, .store = store, .depth = depth, .halo_px = halo_px};
}

}  // namespace ink::buffers
