#pragma once

#include <memory>

#include "method/method.h"
#include "raster/depth/depth_image.h"
#include "raster/mesh/mesh_pass.h"

namespace ink::methods {

/// The inverted hull: the surface grown along its normals, its back faces black behind the front
/// faces.
class InvertedHull : public method::Method {
  public:
    enum class Space {
        screen,  ///< as many px everywhere
        world,   ///< as long everywhere
    };
    struct Params {
        Space space = Space::screen;
        double width_px = 2;
        double width_milliradii = 4;
        double crease_deg = 180;
        raster::DepthFormat depth_format = raster::DepthFormat::q32;
        int threshold = 128;  // it draws 0 and 255 only
    };
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit InvertedHull(const Params& params);

    void prepare(const scene::Scene& scene) override;
    void pose(const scene::Scene& scene) override;
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    [[nodiscard]] int bytes_per_px() const override;
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    void grow(const method::Frame& frame);
    [[nodiscard]] raster::MeshInput mesh_input(const method::Frame& frame) const;

    Params params_;
    raster::PassFormat format_;
    scene::Surface surface_;
    scene::Surface hull_;
    raster::LaneMesh mesh_;  ///< borrows the surface
    raster::LaneMesh hull_mesh_;
    scene::Sphere bounds_;
    std::uint64_t posed_hash_ = 0;
    raster::MeshPass fronts_;
    raster::MeshPass backs_;
    raster::DepthImage depth_;
    raster::SkipCounts skip_counts_{};
};

[[nodiscard]] method::MethodInfo inverted_hull();

}  // namespace ink::methods
