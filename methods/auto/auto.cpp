// New here: a packed buffer in MOTE's manner whose code is planned from the scene's statistics:
// which channels, how many bytes, which step is a line (auto_plan.h). It leaves channels out, so
// its image is its own.

#include <cstdint>
#include <glm/trigonometric.hpp>
#include <memory>

#include "buffers/packed_buffer.h"
#include "methods/auto/auto_plan.h"

namespace ink::methods {
namespace {

struct AutoParams : PlanWishes {
    double crease_deg = 40;
    raster::Interpolation interpolation = raster::Interpolation::affine;
    raster::DepthFormat depth_format = raster::DepthFormat::q32;
    edge::Response response = edge::Response::absolute;
    // found: experiments/thresholds.py, over the training scenes at 1280x720
    int threshold = kPlannedResponse;
};

buffers::PackParams pack_params(const AutoParams& params) {
    buffers::PackParams pack;
    pack.crease_deg = params.crease_deg;
    pack.interpolation = params.interpolation;
    pack.depth_format = params.depth_format;
    pack.response = params.response;
    pack.threshold = params.threshold;
    return pack;
}

class Auto : public method::Method {
  public:
    using Params = AutoParams;
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table
            .choice(&Params::channels,
                    "channels",
                    {"planned", "depth", "all"},
                    "What the code sums: as planned, depth alone, or depth and normal.")
            .choice(&Params::bytes,
                    "bytes",
                    {"planned", "1", "2"},
                    "Size of a pixel's code: as planned, or given.")
            .choice(&Params::encoding,
                    "depth_encoding",
                    {"planned", "inverse", "log"},
                    "How distance becomes a number: as planned, or given.")
            .number(&Params::step_scale,
                    "step_scale",
                    {0.25, 4},
                    "",
                    "Factor on the planned least step that is a line.");
        buffers::add_crease_param(
            table, "Least dihedral deviation of a crease, in the plan and in the normals.");
        buffers::add_depth_format_param(buffers::add_interpolation_param(table))
            .choice(&Params::response,
                    "response",
                    {"absolute", "positive"},
                    "|L|, or its positive half, one pixel wide.");
        return method::add_threshold(
            table, "Least edge response of a line pixel; a step as planned has 64.");
    }
    explicit Auto(const Params& params) : params_(params) { replan(scene::Scene{}); }

    void prepare(const scene::PreparedScene& scene) override {
        replan(scene);
        buffer_->prepare(scene);
    }
    /// Plans anew if anything moved: where components stand is part of the plan.
    void pose(const scene::PreparedScene& scene) override {
        if (scene.hash() != planned_hash_) prepare(scene);
        buffer_->pose(scene);
    }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        buffer_->draw(frame, out);
    }
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return buffer_->layers(frame);
    }
    [[nodiscard]] int bytes_per_px() const override { return buffer_->bytes_per_px(); }
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return buffer_->skip_counts(); }
    [[nodiscard]] method::Cost cost() const override { return buffer_->cost(); }
    [[nodiscard]] std::optional<method::LinearCode> code() const override {
        return buffer_->code();
    }
    [[nodiscard]] std::vector<method::PlanLine> plan() const override { return plan_.lines; }

  private:
    void replan(const scene::PreparedScene& scene) {
        const auto statistics =
            scene::make_scene_statistics(scene, glm::radians(params_.crease_deg));
        plan_ = make_plan(statistics, params_);
        buffer_ = std::make_unique<buffers::PackedBuffer>(plan_.applied_to(pack_params(params_)),
                                                          plan_.layout());
        planned_hash_ = scene.hash();
    }

    Params params_;
    CodePlan plan_;
    std::unique_ptr<buffers::PackedBuffer> buffer_;
    std::uint64_t planned_hash_ = 0;
};

}  // namespace

method::MethodInfo auto_method() {
    method::MethodInfo info = method::method_info<Auto>("auto");
    info.is_planned = true;
    return info;
}

}  // namespace ink::methods
