#include "buffers/full_buffer_method.h"

#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"

namespace ink::buffers {
namespace {

constexpr double kFloat_bytes = sizeof(float);

}  // namespace

/// Hands tiles to the method's filter, empty ones apart.
class FullBufferMethod::Sink : public raster::TileSink {
  public:
    Sink(const FullBufferMethod& method, const FullBufferFrame& frame, edge::EdgeImage& out)
        : method_(method), frame_(frame), out_(out) {}

    void finish(const raster::Tile& tile) override {
        if (tile.is_empty) return clear_tile(tile, out_);
        const raster::Tile output = output_tile(tile, out_.width_px(), out_.height_px());
        if (output.width_px > 0 && output.height_px > 0) method_.filter(frame_, output, out_);
    }

  private:
    const FullBufferMethod& method_;
    const FullBufferFrame& frame_;
    edge::EdgeImage& out_;
};

void FullBufferMethod::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (buffers_.is_empty()) return out.fill(0);
    const method::DepthCarrier carrier = buffers_.see(frame);
    const FullBufferFrame seen{carrier, buffers_.range(), PixelRays(buffers_.view())};
    Sink sink(*this, seen, out);
    skip_counts_ = buffers_.draw(frame, carrier, sky_, sink, out);
}

method::Cost FullBufferMethod::cost() const {
    method::Cost cost = buffers_.cost();
    cost.filter = filter_work();
    return cost;
}

method::PixelWork encoded_depth_work(const InputParams& params) {
    method::PixelWork depth = method::encode_work(params.depth_encoding, params.interpolation);
    if (params.depth_sign == DepthSign::far_high) depth.operations += 1;
    if (depth.operations == 0) return depth;  // its own plane holds it
    return depth + method::PixelWork{kFloat_bytes, kFloat_bytes, 0};
}

method::PixelWork view_normals_work(bool renormalise) {
    if (!renormalise) return {};
    return method::renormalise_work() + 3 * method::PixelWork{kFloat_bytes, kFloat_bytes, 0};
}

}  // namespace ink::buffers
