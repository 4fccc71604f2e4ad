#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "buffers/codes/surface_codes.h"
#include "buffers/surface_inputs.h"
#include "edge/side_differences.h"
#include "method/method.h"

namespace ink::buffers {

/// Where the length comes from that a step of a code must cover.
enum class Footprint {
    none,    ///< nowhere: the surface's turning alone makes steps
    object,  ///< the largest object, as if it filled the height of 720 px
    view,    ///< every triangle's distance in the frame: codes are made again for each view
};

/// The parameters of whatever draws one code a triangle.
struct CodeParams {
    double crease_deg = 40;
    double weld_epsilon = 1e-4;  // as `ids` has it
    Samples samples = Samples::corner;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
    int threshold = 128;
};

/// Appends the rows of CodeParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_code_params(core::ParamTable<P>& table, std::string threshold_doc) {
    table
        .number(&P::crease_deg,
                "crease_deg",
                {0, 180},
                "deg",
                "Least dihedral deviation of an edge between two smooth patches.")
        .number(&P::weld_epsilon,
                "weld_epsilon",
                {0, 0.01},
                "",
                "Vertices of an object this near are welded for its codes, as a share of its "
                "diagonal.");
    return add_samples_param(table)
        .choice(
            &P::depth_format, "depth_format", {"q32", "z24", "z16"}, "Format of the depth test.")
        .number(&P::threshold, "threshold", {1, 255}, "", std::move(threshold_doc));
}

/// How codes are made and looked at.
struct CodeSetup {
    double turn_rad = 0;  ///< see CodeOptions
    int rounds = 0;
    CodeRange range;
    Footprint footprint = Footprint::none;
    double length_px = 0;  ///< that a step covers at least, by the footprint
    int gain_bits = 0;     ///< of the response, see edge::side_differences
    int bytes = 1;         ///< of codes a pixel, see CodeOptions
};

/// A byte or two a triangle, nothing interpolated: a line wherever the codes of neighbouring
/// samples differ.
///
/// What surface8, surface16 and label8 share: they differ in their codes alone.
class CodeMethod : public method::Method {
  public:
    CodeMethod(const CodeParams& params, const CodeSetup& setup);

    void prepare(const scene::Scene& scene) override;
    /// Codes stay with the scene at rest, which an animation starts from. A scene without one rests
    /// as it stands, so that codes are made again if it moved.
    void pose(const scene::Scene& scene) override;
    void draw(const method::Frame& frame, edge::EdgeImage& out) override;
    /// `codes`: black where nothing is, dark to white; of two bytes, in red and green.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override;
    [[nodiscard]] int bytes_per_px() const override { return format_.bytes_per_px(); }
    [[nodiscard]] method::Cost cost() const override;
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return skip_counts_; }

  private:
    /// Makes what depends on the view, and draws it.
    raster::MeshResult draw_to(raster::TileSink& sink,
                               const method::Frame& frame,
                               bool may_leave_out);
    void make_codes(const scene::Scene& scene);
    [[nodiscard]] std::string name_of_codes() const;
    void take(std::vector<std::uint32_t> codes);
    void follow_view();
    void order_codes(const raster::LaneMesh& mesh);

    CodeParams params_;
    CodeSetup setup_;
    raster::PassFormat format_;
    SurfaceInputs inputs_;
    SurfaceCodes surface_codes_;
    raster::MeshPass pass_;
    std::uint64_t coded_hash_ = 0;                 ///< of the scene that was at rest
    std::vector<std::uint32_t> codes_;             ///< per triangle
    std::vector<std::uint8_t> codes_in_clusters_;  ///< empty: to be put in order again
    std::vector<float> lengths_world_;             ///< of the last view, per triangle
    bool have_codes_changed_ = false;              ///< since the last draw: then no tile is still
    raster::SkipCounts skip_counts_{};
};

}  // namespace ink::buffers
