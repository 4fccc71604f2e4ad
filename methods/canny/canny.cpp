// J. Canny, "A computational approach to edge detection", PAMI 8(6), 1986, as cv::Canny has it.

#include "methods/canny/canny.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "buffers/surface_values.h"
#include "core/parallel.h"

namespace ink::methods {
namespace {

/// Puts the tiles' codes together.
class CodeSink : public raster::TileSink {
  public:
    explicit CodeSink(core::Image<std::uint8_t>& codes) : codes_(codes) {}

    void finish(const raster::Tile& tile) override {
        for (int y = 0; y < tile.height_px; ++y) {
            std::memcpy(codes_.row(tile.y0_px + y) + tile.x0_px,
                        tile.row<std::uint8_t>(0, y),
                        static_cast<std::size_t>(tile.width_px));
        }
    }

  private:
    core::Image<std::uint8_t>& codes_;
};

/// OpenCV's own threads while one of these lives; as many as before after the last. Methods that
/// draw at the same time use the same number of threads.
class OpenCvThreads {
  public:
    explicit OpenCvThreads(int threads) {
        Use& use = shared();
        const std::lock_guard lock(use.mutex);
        if (use.users++ > 0) return;
        use.before = cv::getNumThreads();
        // 0: none at all. More than the machine has, and oneTBB would warn on stderr.
        cv::setNumThreads(threads == 1 ? 0 : std::min(threads, core::hardware_threads()));
    }
    ~OpenCvThreads() {
        Use& use = shared();
        const std::lock_guard lock(use.mutex);
        if (--use.users == 0) cv::setNumThreads(use.before);
    }
    OpenCvThreads(const OpenCvThreads&) = delete;
    OpenCvThreads& operator=(const OpenCvThreads&) = delete;

  private:
    /// OpenCV has one number for the whole program, hence one of this, too.
    struct Use {
        std::mutex mutex;
        int users = 0;
        int before = 0;
    };
    static Use& shared() {
        static Use use;
        return use;
    }
};

buffers::CodeLayout layout(const Canny::Params& params) {
    const buffers::Field sum{
        .ranges = {.depth = params.range_depth,
                   .normal = {params.range_nx, params.range_ny, params.range_nz}}};
    return {.store = raster::Store::u8, .planes = 1, .fields = {sum}};
}

raster::PassFormat pass_format(const Canny::Params& params) {
    raster::PassFormat format;
    format.interpolants = 1;
    format.store = raster::Store::u8;
    format.interpolation = params.interpolation;
    format.depth = params.depth_format;
    return format;
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // One threshold: no weak edges that hang on strong ones.
        {{"low", "60"}},
        // Weaker lines, and only the strongest.
        {{"low", "20"}, {"high", "40"}},
        {{"low", "50"}, {"high", "100"}},
        // The sum of its components' sizes for the gradient's length.
        {{"l2_gradient", "false"}},
        // Smoothed first, as Canny's own paper does.
        {{"blur", "true"}},
        // Unlike weights, so that unlike turns of the normal do not cancel.
        {{"range_depth", "75"}, {"range_nx", "90"}, {"range_ny", "60"}, {"range_nz", "30"}},
        // No smooth normals: what adjacency buys.
        {{"normals", "facet"}},
    };
}

}  // namespace

core::ParamTable<Canny::Params> Canny::table() {
    core::ParamTable<Params> table;
    const std::pair<double, double> range{0, 255};
    const std::pair<double, double> gradient{1, 2040};
    table.number(&Params::range_depth, "range_depth", range, "code", "Codes that depth 0..1 spans.")
        .number(&Params::range_nx, "range_nx", range, "code", "Codes that the normal's x spans.")
        .number(&Params::range_ny, "range_ny", range, "code", "Codes that the normal's y spans.")
        .number(&Params::range_nz, "range_nz", range, "code", "Codes that the normal's z spans.")
        .number(&Params::low,
                "low",
                gradient,
                "",
                "Least gradient of a pixel that continues a line; a step of one code has 4.")
        .number(&Params::high, "high", gradient, "", "Least gradient of a pixel that begins one.")
        .choice(&Params::aperture, "aperture", {"3", "5", "7"}, "Side of the Sobel kernels, in px.")
        .flag(&Params::l2_gradient,
              "l2_gradient",
              "Measure the gradient by its length, else by the sum of its components' sizes.")
        .flag(&Params::blur, "blur", "Smooth the codes by a Gaussian of 5 x 5 px first.");
    return buffers::add_input_params(table)
        .number(&Params::sky, "sky", range, "code", "What empty pixels hold.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Least edge response of a line pixel; it draws only 0 and 255.");
}

Canny::Canny(const Params& params)
    : params_(params),
      packer_(
          layout(params), params.depth_sign, buffers::Quantise::sum, raster::Overflow::saturate),
      format_(pass_format(params)),
      inputs_(params) {}

std::unique_ptr<raster::CornerValues> Canny::corner_values() const {
    if (params_.depth_encoding != raster::DepthEncoding::inverse)
        return std::make_unique<buffers::CodeValues>(inputs_, packer_, params_.depth_encoding);
    const buffers::Ranges& ranges = packer_.layout().fields.front().ranges;
    std::vector<raster::LinearValue> values = {
        buffers::linear_code(inputs_.linear_channels(), ranges, params_.depth_sign)};
    return std::make_unique<buffers::LinearValues>(std::move(values), false);
}

void Canny::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (inputs_.is_empty() || out.is_empty()) return out.fill(0);
    if (codes_.width_px() != out.width_px() || codes_.height_px() != out.height_px())
        codes_ = core::Image<std::uint8_t>(out.width_px(), out.height_px());
    inputs_.see(frame);
    const auto values = corner_values();
    raster::MeshInput input = inputs_.mesh_input(frame);
    input.values = values.get();
    input.sky_code = {static_cast<std::uint32_t>(params_.sky)};
    // A weak edge may hang on a strong one anywhere: all tiles are drawn.
    input.may_keep_still = false;
    CodeSink sink(codes_);
    skip_counts_ = pass_.draw(format_, input, sink).skips;

    const OpenCvThreads threads(frame.threads);
    cv::Mat codes(out.height_px(), out.width_px(), CV_8U, codes_.data());
    cv::Mat edges(out.height_px(), out.width_px(), CV_8U, out.data());
    if (params_.blur) cv::GaussianBlur(codes, codes, {5, 5}, 0, 0, cv::BORDER_REPLICATE);
    cv::Canny(codes, edges, params_.low, params_.high, kernel_px(), params_.l2_gradient);
    assert(edges.data == out.data());
}

int Canny::bytes_per_px() const {
    return format_.bytes_per_px() + 1;  // the whole image of codes beside the tile's
}

method::Cost Canny::cost() const {
    method::Cost cost;
    cost.passes = 1;
    cost.interpolants = 1;
    cost.values_per_vertex = 1;
    cost.shares_vertices = params_.normals != scene::NormalSource::facet;
    cost.buffer_bytes_per_px = bytes_per_px();
    cost.fill = method::fill_work(format_);
    const method::PixelWork gather{1, 1, 0};
    method::PixelWork blur;
    if (params_.blur) blur = {2, 2, 2 * (5 + 4)};  // two passes of five
    // Two separable derivatives of 16 bits, their sizes summed, kept; the largest along the
    // gradient, by a slope's comparison; two thresholds; edges followed: a map read and written.
    const double taps = kernel_px();
    method::PixelWork gradient{1, 4 + 4, 2 * (2 * taps - 1) * 2 + 3};
    if (params_.l2_gradient) gradient.operations += 1;
    const method::PixelWork thin{4 + 4, 1, 4 + 2 + 2};
    const method::PixelWork follow{1, 1, 2};
    cost.filter = gather + blur + gradient + thin + follow;
    return cost;
}

/// The codes are those of a draw, which keeps them for the operator.
std::vector<method::Layer> Canny::layers(const method::Frame& frame) {
    const raster::SkipCounts counts = skip_counts_;
    edge::EdgeImage lines(frame.view.width_px, frame.view.height_px);
    draw(frame, lines);
    skip_counts_ = counts;
    method::Layer layer{"packed", {lines.width_px(), lines.height_px()}};
    if (!inputs_.is_empty() && !lines.is_empty()) {
        std::transform(
            codes_.data(), codes_.data() + codes_.size(), layer.rgb.data(), [](std::uint8_t code) {
                return glm::u8vec3(code);
            });
    }
    return {std::move(layer)};
}

method::MethodInfo canny() {
    method::MethodInfo info =
        method::method_info<Canny>("canny",
                                   "Canny 1986, as OpenCV has it, on the buffer of mote4",
                                   "OpenCV's Canny on depth and normal summed in one byte");
    info.family = method::Family::packed;
    info.marker = method::Marker::down;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
