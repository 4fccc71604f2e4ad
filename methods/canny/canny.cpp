// J. Canny, "A computational approach to edge detection", PAMI 8(6), 1986, as cv::Canny has it,
// over a byte of depth and normal summed: the textbook's edges of the packed image.

#include <algorithm>
#include <cassert>
#include <cstring>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "buffers/code_layout.h"
#include "buffers/each_tile.h"
#include "buffers/surface_method.h"
#include "buffers/surface_pass.h"
#include "buffers/surface_values.h"
#include "core/parallel.h"

namespace ink::methods {
namespace {

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

raster::PassFormat pass_format(const buffers::InputParams& params) {
    return {.interpolants = 1,
            .store = raster::Store::u8,
            .interpolation = params.interpolation,
            .depth = params.depth_format};
}

/// Side of the Sobel kernels.
enum class Aperture { three, five, seven };

class Canny : public buffers::SurfaceMethod<buffers::SurfacePass> {
  public:
    struct Params : buffers::InputParams, buffers::SumParams {
        int sky = 0;
        // found: ODS over the training scenes at 1280x720, `inkbench compare`; see the page
        double low = 30;
        double high = 60;
        Aperture aperture = Aperture::three;
        bool l2_gradient = true;
        bool blur = false;
        int threshold = 128;  ///< it draws 0 and 255 alone
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        const std::pair<double, double> gradient{1, 2040};
        buffers::add_sum_params(table, 255)
            .number(&Params::low,
                    "low",
                    gradient,
                    "",
                    "Least gradient of a pixel that continues a line; a step of one code has 4.")
            .number(
                &Params::high, "high", gradient, "", "Least gradient of a pixel that begins one.")
            .choice(
                &Params::aperture, "aperture", {"3", "5", "7"}, "Side of the Sobel kernels, in px.")
            .flag(&Params::l2_gradient,
                  "l2_gradient",
                  "Measure the gradient by its length, else by the sum of its components' sizes.")
            .flag(&Params::blur, "blur", "Smooth the codes by a Gaussian of 5 x 5 px first.");
        buffers::add_input_params(table).number(
            &Params::sky, "sky", {0, 255}, "code", "What empty pixels hold.");
        return method::add_threshold_of_two(table);
    }
    explicit Canny(const Params& params)
        : SurfaceMethod(params, pass_format(params)),
          params_(params),
          packer_({.planes = 1, .fields = {{.ranges = params.ranges()}}},
                  params.depth_sign,
                  buffers::Quantise::sum,
                  raster::Overflow::saturate) {}

    /// `packed`: the codes, black to white. They are those of a draw, which keeps them for the
    /// operator.
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        edge::EdgeImage lines(frame.view.width_px, frame.view.height_px);
        if (pass().is_empty() || lines.is_empty())
            return {{"packed", {lines.width_px(), lines.height_px()}}};
        (void)draw_lines(frame, lines);
        const auto gray = [](std::uint8_t code) { return glm::u8vec3(code); };
        return {{"packed", core::mapped<glm::u8vec3>(codes_, gray)}};
    }
    /// The whole image of codes beside the tile's.
    [[nodiscard]] int bytes_per_px() const override { return SurfaceMethod::bytes_per_px() + 1; }

  private:
    [[nodiscard]] std::unique_ptr<raster::CornerValues> corner_values() const {
        const buffers::SurfaceInputs& inputs = pass().inputs();
        if (params_.depth_encoding != raster::DepthEncoding::inverse)
            return std::make_unique<buffers::CodeValues>(inputs, packer_, params_.depth_encoding);
        std::vector<raster::LinearValue> values = {
            buffers::linear_code(inputs.linear_channels(), params_.ranges(), params_.depth_sign)};
        return std::make_unique<buffers::LinearValues>(std::move(values), false);
    }

    raster::SkipCounts draw_lines(const method::Frame& frame, edge::EdgeImage& out) override {
        if (codes_.width_px() != out.width_px() || codes_.height_px() != out.height_px())
            codes_ = core::Image<std::uint8_t>(out.width_px(), out.height_px());
        pass().inputs().see(frame);
        const auto values = corner_values();
        raster::MeshInput input = pass().inputs().mesh_input(frame);
        input.values = values.get();
        input.sky_code = {static_cast<std::uint32_t>(params_.sky)};
        // A weak edge may hang on a strong one anywhere: all tiles are drawn.
        input.may_keep_still = false;
        buffers::EachTile sink([&](const raster::Tile& tile) {
            for (int y = 0; y < tile.height_px; ++y) {
                std::memcpy(codes_.row(tile.y0_px + y) + tile.x0_px,
                            tile.row<std::uint8_t>(0, y),
                            static_cast<std::size_t>(tile.width_px));
            }
        });
        const raster::SkipCounts skips = pass().draw(input, sink).skips;

        const OpenCvThreads threads(frame.threads);
        const int kernel_px = 3 + 2 * static_cast<int>(params_.aperture);
        cv::Mat codes(out.height_px(), out.width_px(), CV_8U, codes_.data());
        cv::Mat edges(out.height_px(), out.width_px(), CV_8U, out.data());
        if (params_.blur) cv::GaussianBlur(codes, codes, {5, 5}, 0, 0, cv::BORDER_REPLICATE);
        cv::Canny(codes, edges, params_.low, params_.high, kernel_px, params_.l2_gradient);
        assert(edges.data == out.data());
        return skips;
    }
    /// Codes gathered; two derivatives of 16 bits and their size kept; thinned along the gradient;
    /// edges followed over a map.
    [[nodiscard]] method::PixelBytes filter_bytes() const override {
        const double blur = params_.blur ? 2 : 0;
        return {1 + blur + 1 + 8 + 1, 1 + blur + 8 + 1 + 1};
    }

    Params params_;
    buffers::Packer packer_;
    core::Image<std::uint8_t> codes_;
};

}  // namespace

method::MethodInfo canny_method() {
    return method::method_info<Canny>("canny");
}

}  // namespace ink::methods
