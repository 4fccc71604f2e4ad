#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "buffers/code_layout.h"
#include "buffers/packed_sink.h"
#include "buffers/surface_inputs.h"
#include "core/image.h"
#include "edge/edge_image.h"
#include "method/depth_code.h"
#include "raster/pass/corner_values.h"

namespace ink::buffers {

/// The code of one field at a vertex, plus one half, so that a floor later rounds it: the sum that
/// Packer::at_vertex computes, as one linear value.
[[nodiscard]] raster::LinearValue linear_code(const LinearChannels& channels,
                                              const Ranges& ranges,
                                              DepthSign sign);

/// Values that are linear in 1/w and the normal.
class LinearValues : public raster::CornerValues {
  public:
    /// `reads_all`: normals are read where they have no weight, too.
    LinearValues(std::vector<raster::LinearValue> values, bool reads_all);
    void compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const override;
    /// How many of depth and the normal's three components no value reads.
    [[nodiscard]] std::uint64_t unread_channels() const;

  private:
    std::vector<raster::LinearValue> values_;
    bool reads_all_;
};

inline constexpr int kChannels = 4;  ///< depth, nx, ny, nz

/// Depth as a DepthCarrier carries it, and the view-space normal: four values.
class ChannelValues : public raster::CornerValues {
  public:
    ChannelValues(const SurfaceInputs& inputs, const method::DepthCarrier& carrier);
    void compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const override;

  private:
    raster::LinearValue linear_[4];
    method::DepthCarrier carrier_;
};

/// Codes that are not linear: fields rounded at the vertex, depth in another encoding.
class CodeValues : public raster::CornerValues {
  public:
    CodeValues(const SurfaceInputs& inputs, const Packer& packer, raster::DepthEncoding encoding);
    void compute(const raster::CornerBatch& in, const raster::CornerPlanes& out) const override;

  private:
    const Packer& packer_;
    raster::DepthEncoding encoding_;
    raster::DepthRange range_;
    glm::mat3 view_from_world_;
};

/// Codes as an image, 0 black and the largest of its bits white: one field as grey; of more, the
/// first three as red, green and blue (of four, which are depth and normal, the normal's).
///
/// `codes` has an image for each of the layout's planes, all of one size.
[[nodiscard]] core::Image<glm::u8vec3> code_image(const FrameCodes& codes,
                                                  const CodeLayout& layout);

/// Edge responses in grey, brightened or dimmed so that `threshold` (1..255) comes out as 128; what
/// is twice as strong is white.
[[nodiscard]] core::Image<glm::u8vec3> response_image(const edge::EdgeImage& edge_responses,
                                                      int threshold);

}  // namespace ink::buffers
