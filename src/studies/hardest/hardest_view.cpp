#include "studies/hardest/hardest_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <memory>

#include "core/error.h"
#include "core/interrupt.h"
#include "harness/scores/grey_lines.h"
#include "scene/prepared_scene.h"
#include "search/search.h"

namespace ink::studies {
namespace {

/// What the search lowers where there is no candidate: above every F, and less where more lines
/// are in the image, so that a search finds its way back.
constexpr double kNoCandidate = 1;

struct Interrupted {};

/// A scene at a moment, with all that is made ready there.
struct Stage {
    Stage(scene::Scene posed, const HardestOptions& options)
        : scene(std::move(posed)),
          bounds(scene::bounding_sphere(scene)),
          model(scene, options.cell.trace.truth),
          prepared(scene) {
        std::vector<method::MethodConfig> configs = {options.method};
        if (options.against) configs.push_back(*options.against);
        methods = harness::prepare_methods(configs, prepared);
    }

    scene::Scene scene;
    scene::Sphere bounds;
    truth::SceneModel model;
    scene::PreparedScene prepared;
    harness::PreparedMethods methods;
};

/// The scene as it is at a moment, named after it, with one view if `camera` is there.
harness::SceneViews at_moment(const harness::SceneViews& rest, const ViewChoice& choice) {
    harness::ViewRequest request;
    request.width_px = rest.views.front().width_px;
    request.height_px = rest.views.front().height_px;
    request.time_s = choice.time_s;
    request.cameras = {choice.camera()};
    return harness::make_scene_views(rest.scene, request);
}

class Looker {
  public:
    Looker(const harness::SceneViews& rest, const HardestOptions& options)
        : rest_(rest), options_(options), space_(rest.scene) {
        options_.cell.scores = harness::Scores::settings;
        options_.cell.measure.max_repetitions = 0;
        options_.cell.trace.cache.clear();  // nothing comes again
        options_.cell.trace.crosscheck = false;
    }

    [[nodiscard]] const ViewSpace& space() const { return space_; }
    /// Where the worst candidate so far lies; nothing before the first.
    [[nodiscard]] const std::vector<double>& worst_point() const { return worst_point_; }

    /// The scene's own views, as it stands.
    void look_at_usual() {
        Stage stage(rest_.scene, options_);
        for (const scene::View& view : rest_.views) {
            HardestLook look = looked("usual", stage, view);
            look.choice = space_.at(space_.point_of(view.camera));
            look.choice.time_s = {};
            look.view = view.camera.name;
            add(std::move(look));
        }
    }

    /// The point nearest to the own view that is worst.
    [[nodiscard]] std::vector<double> start() const {
        const auto worst = std::ranges::min_element(looks_, is_worse);
        const auto n = static_cast<std::size_t>(worst - looks_.begin());
        return space_.point_of(rest_.views[n].camera);
    }

    [[nodiscard]] search::SearchObjective objective() {
        return [this](const char* phase, const std::vector<double>& point) {
            return value_at(phase, point);
        };
    }

    search::SearchValue value_at(const char* phase, const std::vector<double>& point) {
        if (core::is_interrupted()) throw Interrupted{};
        const ViewChoice choice = space_.at(point);
        HardestLook known;
        known.choice = choice;
        const auto [entry, is_new] = values_.try_emplace(known.view_words(), 0);
        if (!is_new) return {entry->second, false};
        if (!stage_ || moment_ != choice.time_s) {
            stage_ = std::make_unique<Stage>(at_moment(rest_, choice).scene, options_);
            moment_ = choice.time_s;
        }
        scene::View view = rest_.views.front();
        view.camera = harness::make_camera(choice.camera(), stage_->scene.origin, stage_->bounds);
        HardestLook look = looked(phase, *stage_, view);
        look.choice = choice;
        entry->second = look.value;
        if (worst_point_.empty() || look.value < worst_value_) {
            worst_point_ = point;
            worst_value_ = look.value;
        }
        add(std::move(look));
        return {entry->second, true};
    }

    /// Ranks the worst that are distinct, and gives all.
    [[nodiscard]] std::vector<HardestLook> ranked() {
        std::vector<HardestLook*> candidates;
        for (HardestLook& look : looks_)
            if (look.is_candidate() && look.phase != "usual") candidates.push_back(&look);
        std::ranges::stable_sort(candidates, {}, &HardestLook::value);
        std::vector<glm::dvec3> kept;
        for (HardestLook* look : candidates) {
            if (std::ssize(kept) == options_.worst) break;
            const glm::dvec3 direction = space_.direction(look->choice);
            const bool is_alike = std::ranges::any_of(kept, [&](const auto& other) {
                return glm::dot(direction, other) >= std::cos(glm::radians(kDistinct_deg));
            });
            if (is_alike) continue;
            kept.push_back(direction);
            look->rank = static_cast<int>(kept.size());
            look->view = fmt::format("{}_{}", options_.method.info->name, kept.size());
        }
        return std::move(looks_);
    }

  private:
    static bool is_worse(const HardestLook& a, const HardestLook& b) { return a.value < b.value; }

    void add(HardestLook look) {
        look.evaluation = ++evaluations_[look.phase == "usual"];
        looks_.push_back(std::move(look));
    }

    [[nodiscard]] HardestLook looked(const char* phase, Stage& stage, const scene::View& view) {
        const harness::TracedView traced =
            harness::trace_with_facts(stage.model, stage.scene, view, options_.cell.trace);
        std::vector<harness::Evaluation> drawn =
            harness::method_evaluations(stage.methods, view, options_.cell.measure);
        for (const harness::Evaluation& evaluation : drawn) {
            if (evaluation.row.is_ok()) continue;
            throw core::Error(fmt::format("{} on {}", evaluation.row.method, stage.scene.name),
                              evaluation.row.status,
                              "a method that draws it");
        }
        harness::finish_evaluations(stage.scene, view, traced, options_.cell, drawn);
        if (options_.cell.line_width_px && traced.has_truth())
            harness::score_grey_lines(traced.truth, *options_.cell.line_width_px, drawn);
        HardestLook look;
        look.scene = rest_.scene.name;
        look.shown_as = stage.scene.name;
        look.method = options_.method.info->name;
        if (options_.against) look.against = options_.against->info->name;
        look.phase = phase;
        const harness::Row& row = drawn.front().row;
        look.status = row.status;
        if (row.is_ok()) look.count = {row.k_2px, row.n_pred, row.n_truth};
        if (row.is_scored()) look.f_2px = row.f_2px;
        if (drawn.size() > 1 && drawn[1].row.is_scored()) look.f_against = drawn[1].row.f_2px;
        look.soft = row.soft;
        if (drawn.size() > 1 && drawn[1].row.soft) look.soft_f_against = drawn[1].row.soft->f();
        judge(look);
        return look;
    }

    /// Whether it is a candidate, and what it is worth.
    void judge(HardestLook& look) const {
        const auto least = static_cast<double>(options_.least_truth_px);
        const auto n_truth = static_cast<double>(look.count.n_truth);
        if (look.is_candidate() && n_truth < least)
            look.status = fmt::format(
                "few: {} true pixels, of {} at least", look.count.n_truth, options_.least_truth_px);
        if (!look.is_candidate() || !look.f()) {
            look.value = kNoCandidate + 1 - std::min(1.0, n_truth / std::max(1.0, least));
        } else {
            look.value = *look.f() - look.other_f().value_or(0);
        }
    }

    const harness::SceneViews& rest_;
    HardestOptions options_;
    ViewSpace space_;
    std::unique_ptr<Stage> stage_;
    std::optional<double> moment_;
    std::map<std::string, double> values_;  ///< of the choices that were looked at
    std::map<bool, int> evaluations_;       ///< so far, of usual views and of the search
    std::vector<HardestLook> looks_;
    std::vector<double> worst_point_;
    double worst_value_ = 0;
};

std::string point_words(const glm::dvec3& p) {
    return fmt::format("{},{},{}", p.x, p.y, p.z);
}

}  // namespace

std::string HardestLook::view_words() const {
    return fmt::format("--eye {} --target {} --fov {}{}",
                       point_words(choice.eye),
                       point_words(choice.target),
                       choice.fov_deg,
                       choice.time_s ? fmt::format(" --time {}", *choice.time_s) : "");
}

std::optional<std::vector<HardestLook>> search_hardest_views(const harness::SceneViews& scene_views,
                                                             const HardestOptions& options) {
    Looker looker(scene_views, options);
    try {
        looker.look_at_usual();
        const search::SearchObjective objective = looker.objective();
        const int first = (2 * options.evaluations + 2) / 3;
        search::search(objective,
                       looker.start(),
                       {.evaluations = first, .global = "direct", .global_share = 1});
        search::search(objective,
                       looker.worst_point(),
                       {.evaluations = options.evaluations - first,
                        .seed = options.seed,
                        .global = "crs",
                        .global_share = 0.3});
    } catch (const Interrupted&) {
        return std::nullopt;
    }
    return looker.ranked();
}

std::vector<harness::SceneViews> worst_scene_views(const harness::SceneViews& scene_views,
                                                   const std::vector<HardestLook>& looks) {
    std::vector<const HardestLook*> kept;
    for (const HardestLook& look : looks)
        if (look.rank) kept.push_back(&look);
    std::ranges::sort(kept, [](const auto* a, const auto* b) { return *a->rank < *b->rank; });
    std::vector<harness::SceneViews> worst;
    for (const HardestLook* look : kept) {
        worst.push_back(at_moment(scene_views, look->choice));
        worst.back().views.front().camera.name = look->view;
    }
    return worst;
}

std::vector<HardestLook> random_views(const harness::SceneViews& scene_views,
                                      const HardestOptions& options) {
    Looker looker(scene_views, options);
    search::random_search(looker.objective(),
                          looker.space().size(),
                          {.evaluations = options.evaluations, .seed = options.seed});
    return looker.ranked();
}

}  // namespace ink::studies
