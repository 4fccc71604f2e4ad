// New here: no method of its own, but the one of the registry that the scene's statistics call for
// (auto_plan.h).

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <glm/trigonometric.hpp>
#include <memory>

#include "buffers/surface_inputs.h"
#include "methods/auto/auto_plan.h"
#include "methods/registry.h"

namespace ink::methods {
namespace {

struct AutoParams {
    enum class Price { one, one_and_a_half, three };

    Price price = Price::three;
    double crease_deg = 40;
    int threshold = 128;  // that of all from which it chooses

    [[nodiscard]] double times_ids() const {
        constexpr std::array kTimes = {1.0, 1.5, 3.0};
        return kTimes[static_cast<std::size_t>(price)];
    }
};

class Auto : public method::Method {
  public:
    using Params = AutoParams;
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.choice(&Params::price,
                     "price",
                     {"1", "1.5", "3"},
                     "What a frame may cost, in times of `ids`, as the scene's statistics predict "
                     "it.");
        buffers::add_crease_param(
            table, "Least dihedral deviation of a crease, in the plan and in what it chose.");
        return method::add_threshold(table,
                                     "Least edge response of a line pixel, in whatever it chose.");
    }
    explicit Auto(const Params& params) : params_(params) { (void)choose(scene::Scene{}); }

    void prepare(const scene::PreparedScene& scene) override {
        (void)choose(scene);
        chosen_->prepare(scene);
    }
    /// Plans anew if anything moved: a fold may have become a crease.
    void pose(const scene::PreparedScene& scene) override {
        if (scene.hash() != planned_hash_ && choose(scene)) chosen_->prepare(scene);
        chosen_->pose(scene);
    }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        chosen_->draw(frame, out);
    }
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return chosen_->layers(frame);
    }
    [[nodiscard]] int bytes_per_px() const override { return chosen_->bytes_per_px(); }
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return chosen_->skip_counts(); }
    [[nodiscard]] method::Cost cost() const override { return chosen_->cost(); }
    [[nodiscard]] std::vector<method::PlanLine> plan() const override { return plan_.lines; }

  private:
    /// Whether that is another method than before.
    bool choose(const scene::PreparedScene& scene) {
        const std::string before = plan_.method;
        planned_hash_ = scene.hash();
        const auto statistics = scene.get(
            fmt::format("scene statistics {}", params_.crease_deg),
            [&] { return scene::make_scene_statistics(scene, glm::radians(params_.crease_deg)); });
        plan_ = plan_scene(*statistics, params_.times_ids());
        if (plan_.method == before) return false;
        const auto all = table().write(params_);
        chosen_ =
            find_method(plan_.method)
                .make({{"crease_deg", all.at("crease_deg")}, {"threshold", all.at("threshold")}});
        return true;
    }

    Params params_;
    ScenePlan plan_;
    std::unique_ptr<method::Method> chosen_;
    std::uint64_t planned_hash_ = 0;
};

}  // namespace

method::MethodInfo auto_method() {
    method::MethodInfo info = method::method_info<Auto>("auto");
    info.is_planned = true;
    return info;
}

}  // namespace ink::methods
