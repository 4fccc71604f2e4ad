// New here: no method of its own, but the one of the registry that the scene's statistics call for
// (auto.h).
// Every number here was found on the catalogue at 1280x720, one thread; the method's page says how
// it does there and on real models.

#include "methods/auto/auto.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <glm/trigonometric.hpp>
#include <memory>
#include <optional>

#include "buffers/surface_inputs.h"
#include "methods/registry.h"

namespace ink::methods {
namespace {

constexpr double kMostlyThin = 0.5;  // of the length of all lines
constexpr double kMostlyLoose = 0.1;

constexpr double kEdgesPrice = 1.5;  // times ids, of few triangles

/// What looking up lines costs, in times of ids: codes decide where faces are flat or end at lines,
/// and the mesh is asked where smooth edges pass between the samples.
double lookup_price(const scene::SceneStatistics& s) {
    return 1 + s.smooth_share();
}

/// Why the label of a patch is all that a line needs; "" where it is not.
std::string why_labels(const scene::SceneStatistics& s) {
    if (s.loose_share() > kMostlyLoose) return "";
    if (!s.is_curved()) {
        return "no edge is smooth: a flat patch hides no part of itself, and no crease ends in it";
    }
    if (!s.has_creases() && s.convex_components == s.components) {
        return "all components are convex, without a crease: no patch hides a part of itself";
    }
    return "";
}

ScenePlan choose(const scene::SceneStatistics& s, double price) {
    if (s.thin_share > kMostlyThin && kEdgesPrice <= price) {
        return {"edge_hash",
                {{"edge_hash",
                  fmt::format("{:.0f} % of the lines are of parts thinner than a 720th of the "
                              "scene's radius: samples pass them by, edges are drawn",
                              100 * s.thin_share)}}};
    }
    if (const std::string why = why_labels(s); !why.empty()) {
        return {"label8",
                {{"label8", why},
                 {"no distance over the surface, no look-up", "labels differ across every line"},
                 {"surface_lookup from inside",
                  "where the near plane cuts the scene, labels would draw the cut"}}};
    }
    const double lookup = lookup_price(s);
    const std::string predicted =
        fmt::format("looking up lines costs about {:.1f} times ids here, by {:.0f} % smooth edges",
                    lookup,
                    100 * s.smooth_share());
    if (lookup <= price) return {"surface_lookup", {{"surface_lookup", predicted}}};
    return {"surface8_depth",
            {{"surface8_depth",
              "a surface may hide a part of itself: distances over it and depth tell, labels not"},
             {"no look-up", fmt::format("{}, of {:g} at most", predicted, price)}}};
}

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
        start_ = scene->animation ? std::optional<scene::Scene>(scene) : std::nullopt;
        look_at(scene);
        (void)choose(scene);
        forget_view();
        chosen_->prepare(scene);
    }
    /// Plans anew if anything moved: a fold may have become a crease. Codes stay those of the
    /// start, whatever was drawn on the way.
    void pose(const scene::PreparedScene& scene) override {
        look_at(scene);
        if (scene.hash() != planned_hash_ && choose(scene)) {
            forget_view();
            prepare_from_start(*chosen_, scene);
        }
        chosen_->pose(scene);
        if (for_cuts_) for_cuts_->pose(scene);
    }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        drawn_ = &method_for(frame.view.camera);
        drawn_->draw(frame, out);
    }
    [[nodiscard]] std::vector<method::Layer> layers(const method::Frame& frame) override {
        return method_for(frame.view.camera).layers(frame);
    }
    [[nodiscard]] int bytes_per_px() const override { return chosen_->bytes_per_px(); }
    [[nodiscard]] raster::SkipCounts skip_counts() const override {
        return drawn_ ? drawn_->skip_counts() : raster::SkipCounts{};
    }
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
        settings_ = {{"crease_deg", fmt::format("{}", params_.crease_deg)},
                     {"threshold", fmt::format("{}", params_.threshold)}};
        chosen_ = find_method(plan_.method).make(settings_);
        return true;
    }
    void look_at(const scene::PreparedScene& scene) {
        scene_ = &static_cast<const scene::Scene&>(scene);
        bounds_ = scene.bounds();
    }
    void forget_view() {
        for_cuts_ = nullptr;
        drawn_ = nullptr;
    }
    void prepare_from_start(method::Method& method, const scene::PreparedScene& scene) const {
        if (start_) return method.prepare(*start_);
        method.prepare(scene);
    }
    /// Labels draw the near plane's cut, which is no line: where it may be seen, lines are looked
    /// up.
    [[nodiscard]] method::Method& method_for(const scene::Camera& camera) {
        const double depth =
            -(camera.view_from_world * (bounds_.center_world - camera.eye_world)).z;
        // Fitted, the near plane touches the ball, but for rounding.
        const bool is_cut = depth - bounds_.radius < camera.near * (1 - 1e-6);
        if (!is_cut || scene_ == nullptr || plan_.method != "label8") return *chosen_;
        if (!for_cuts_) {
            for_cuts_ = find_method("surface_lookup").make(settings_);
            prepare_from_start(*for_cuts_, *scene_);
            for_cuts_->pose(*scene_);
        }
        return *for_cuts_;
    }

    Params params_;
    ScenePlan plan_;
    core::ParamValues settings_;
    const scene::Scene* scene_ = nullptr;
    scene::Sphere bounds_;
    std::optional<scene::Scene> start_;  ///< of a scene that moves: as it was prepared
    std::unique_ptr<method::Method> chosen_;
    std::unique_ptr<method::Method> for_cuts_;  ///< once such a view was drawn
    method::Method* drawn_ = nullptr;           ///< what drew last
    std::uint64_t planned_hash_ = 0;
};

}  // namespace

ScenePlan plan_scene(const scene::SceneStatistics& statistics, double price) {
    ScenePlan plan = choose(statistics, price);
    const auto absent = [&](bool is_absent, const char* what, const std::string& why) {
        if (is_absent) plan.lines.push_back({what, why});
    };
    absent(!statistics.has_creases(),
           "nothing for creases",
           fmt::format("no edge bends by {:g} degrees", glm::degrees(statistics.crease_rad)));
    absent(statistics.seams.count == 0, "nothing for seams", "no objects meet without a crease");
    absent(!statistics.may_cross(), "nothing for intersections", "no components can cross");
    return plan;
}

method::MethodInfo auto_method() {
    method::MethodInfo info = method::method_info<Auto>("auto");
    info.is_planned = true;
    return info;
}

}  // namespace ink::methods
