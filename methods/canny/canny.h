#pragma once

#include "buffers/code_layout.h"
#include "buffers/surface_inputs.h"
#include "method/method.h"

namespace ink::methods {

/// OpenCV's Canny detector over a byte of depth and normal summed: the textbook's edges of the
/// packed image.
class Canny : public method::Method {
  public:
    /// Side of the Sobel kernels.
    enum class Aperture { three, five, seven };
    struct Params : buffers::InputParams {
        double range_depth = 63;
        double range_nx = 63;
        double range_ny = 63;
        double range_nz = 63;
        int sky = 0;
        // found: ODS over the training scenes at 1280x720, `inkbench compare`; see the page
        double low = 30;
        double high = 60;
        Aperture aperture = Aperture::three;
        bool l2_gradient = true;
        bool blur = false;
        int threshold = 128;  ///< it draws 0 and 255 alone
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Canny(const Params& params);

    void prepare(const scene::Scene& scene) override { inputs_.prepare(scene); }
    [[nodiscard]] bool prepare_like(const method::Method& other,
                                    const scene::Scene& /*scene*/) override {
        const auto* same = dynamic_cast<const Canny*>(&other);
        return same != nullptr && inputs_.prepare_like(same->inputs_);
    }
    void pose(const scene::Scene& scene) override { inputs_.pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `packed`: the codes, black to white.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    [[nodiscard]] int bytes_per_px() const override;
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    [[nodiscard]] std::unique_ptr<raster::CornerValues> corner_values() const;
    [[nodiscard]] int kernel_px() const { return 3 + 2 * static_cast<int>(params_.aperture); }

    Params params_;
    buffers::Packer packer_;
    raster::PassFormat format_;
    buffers::SurfaceInputs inputs_;
    raster::MeshPass pass_;
    core::Image<std::uint8_t> codes_;
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo canny();

}  // namespace ink::methods
