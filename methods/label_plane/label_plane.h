#pragma once

#include <cstdint>
#include <vector>

#include "buffers/packed_sink.h"
#include "buffers/surface_inputs.h"
#include "method/method.h"

namespace ink::methods {

/// A label of the smooth patch plus a plane of depth, modulo the range of one or two bytes: creases
/// and seams change the label, occlusions the depth, and a plane is silent whatever it is added to.
class LabelPlane : public method::Method {
  public:
    enum class Bits { eight, sixteen };
    struct Params {
        Bits bits = Bits::eight;
        double range_depth = 255;
        double crease_deg = 40;
        double weld_epsilon = 1e-4;  // as `ids` has it
        method::RangeSource depth_range = method::RangeSource::fit;
        raster::Interpolation interpolation = raster::Interpolation::affine;
        raster::DepthFormat depth_format = raster::DepthFormat::q32;
        edge::Response response = edge::Response::absolute;
        int clip_bits = 2;
        int threshold = 4;
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit LabelPlane(const Params& params);

    void prepare(const scene::Scene& scene) override;
    /// Labels stay with the scene at rest, which an animation starts from. A scene without one
    /// rests as it stands, so that labels are given again if it moved.
    void pose(const scene::Scene& scene) override;
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `packed`: the codes, black to white over their bits; `filtered`: the response.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    [[nodiscard]] int bytes_per_px() const override { return format_.bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    void give_labels(const scene::Scene& scene);
    /// Draws the scene that is there; with `codes` all of it, and keeps them.
    [[nodiscard]] raster::SkipCounts draw_to(const method::Frame& frame,
                                             edge::EdgeImage& out,
                                             buffers::FrameCodes* codes);

    Params params_;
    buffers::Packer packer_;
    raster::PassFormat format_;
    buffers::SurfaceInputs inputs_;
    raster::MeshPass pass_;
    std::vector<std::uint32_t> labels_;  ///< per triangle
    std::uint64_t labelled_hash_ = 0;    ///< of the scene that was at rest
    bool have_labels_changed_ = false;   ///< since the last draw: then no tile is still
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo label_plane();

}  // namespace ink::methods
