#include "raster/mesh/mesh_stage.h"

// The short way of a cluster: small triangles, whose pixels are found when they are sorted out.

namespace ink::raster {

/// Whether what culling and binning left becomes fragments: it is small, and so is its cluster.
bool MeshRun::makes_fragments(const MeshJob& job, const LaneSlot& slot) const {
    return culled_.extent_px <= kFragmentExtent_px &&
           culled_.area_px <= kFragmentArea_px * culled_.count && lanes_.is_packed &&
           slot.q[0] == slot.q[1] && has_fragments(job.format);
}

/// Finds the fragments, and gives each tile its own in a slot. The cluster's records, from the end
/// of what is kept on, are not needed any more then.
void MeshRun::add_fragments(const MeshJob& job, std::size_t index, LaneSlot slot) {
    alignas(64) std::uint32_t constants[CullResult::kCapacity];
    if (job.format.constant) list_constants(job, index, constants);
    find_fragments({job.format,
                    job.depth_bias,
                    lanes_.records,
                    {slot.values[0], slot.values[1]},
                    constants,
                    slot.bounds},
                   culled_,
                   fragments_);
    const std::size_t room = FragmentBlock::byte_count(job.format, fragments_.count + kLanePad);
    const scene::Cluster& cluster = job.input.mesh->clusters().clusters[index];
    const TileRange tiles(job.grid, slot.bounds);
    tiles.for_each(job.grid, [&](int tile) {
        const PixelRect drawn = job.grid.drawn(tile);
        const std::size_t triangles =
            tiles.is_one() ? culled_.count : count_triangles(culled_, drawn);
        if (triangles == 0) return;
        slot.first_byte = records_.size();
        records_.reserve(slot.first_byte + room);
        const std::size_t count = keep_fragments(job.format,
                                                 fragments_,
                                                 slot.bounds,
                                                 {job.grid.own(tile), drawn},
                                                 records_.data() + slot.first_byte);
        slot.triangles = static_cast<std::uint32_t>(triangles);
        slot.fragments = static_cast<std::uint32_t>(count);
        slot.byte_count = static_cast<std::uint32_t>(FragmentBlock::byte_count(job.format, count));
        records_.resize(slot.first_byte + slot.byte_count);
        const auto number = static_cast<std::uint32_t>(slots_.size());
        slots_.push_back(slot);
        lists_[static_cast<std::size_t>(tile)].push(number << 8 | kAllFragments);
        mark(static_cast<std::size_t>(tile), job.object_bit(cluster));
    });
}

}  // namespace ink::raster
