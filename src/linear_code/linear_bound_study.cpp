#include "linear_code/linear_bound_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "core/text_table.h"
#include "harness/cell.h"
#include "harness/unscored_view.h"
#include "linear_code/channel_planes.h"

namespace ink::linear_code {
namespace {

/// A scene, or several: what weights are judged by, and what the method got.
struct Pool {
    BoundRow row;  ///< without the bound
    int scenes = 0;
    LinearStencils stencils;

    void add(const Pool& other) {
        row.views += other.row.views;
        scenes += other.scenes;
        row.measured += other.row.measured;
        stencils.add(other.stencils);
    }
};

/// The code of a method, and which others it is held against.
struct Asked {
    method::LinearCode code;
    WeightDomain domain;
    LinearWeights weights{};
};

Asked what_is_asked(const BoundStudyOptions& options) {
    const method::MethodInfo& info = *options.config.info;
    const auto code = info.make(options.config.settings)->code();
    if (!code) {
        throw core::Error(info.name,
                          "with these settings it has no code that is one linear sum",
                          "mote4, or mote16, mote2 with one sum");
    }
    const int threshold = method::threshold_of(options.config);
    return {*code,
            weight_domain(info.name, *code, options.is_signed, options.least_threshold),
            weights_of(*code, threshold)};
}

class Study {
  public:
    explicit Study(const BoundStudyOptions& options)
        : options_(options), asked_(what_is_asked(options)) {
        options_.search.starts.push_back(asked_.weights);
    }

    [[nodiscard]] Pool empty_pool(const std::string& name, const std::string& split) const {
        Pool pool{.row = {}, .stencils = LinearStencils(asked_.domain)};
        pool.row.scene = name;
        pool.row.split = split;
        return pool;
    }

    [[nodiscard]] Pool pool_of(const harness::SceneViews& scene_views) const {
        Pool pool = empty_pool(scene_views.scene.name,
                               std::string(scene::split_name(scene_views.scene.split)));
        pool.scenes = 1;
        harness::PreparedMethod method(options_.config, scene_views.scene);
        if (!method.failure().empty()) {
            throw core::Error(
                scene_views.scene.name, method.failure(), "a scene that it can prepare");
        }
        const ChannelSource source(scene_views.scene, asked_.code);
        truth::SceneModel model(scene_views.scene, options_.trace.truth);
        for (const scene::View& view : scene_views.views)
            add_view(view, source, model, method, pool);
        return pool;
    }

    [[nodiscard]] BoundRow row_of(const Pool& pool) {
        BoundRow row = pool.row;
        row.bound = linear_bound(pool.stencils, options_.search);
        if (asked_.domain.contains(asked_.weights))
            row.modelled = linear_count(pool.stencils, asked_.weights);
        return row;
    }

    /// Weights that did well are tried on the pools.
    void remember(const LinearWeights& weights) { options_.search.starts.push_back(weights); }

  private:
    void add_view(const scene::View& view,
                  const ChannelSource& source,
                  truth::SceneModel& model,
                  harness::PreparedMethod& method,
                  Pool& pool) const {
        const harness::ViewTruth truth =
            harness::trace_scored_view(model, pool.row.scene, view, options_.trace);
        const int threads = options_.search.threads;
        pool.stencils.add(source.planes(view, truth.traced.layers.triangle, threads),
                          truth.scoring);
        edge::EdgeImage image(view.width_px, view.height_px);
        method.method().draw({view, threads}, image);
        const score::Score scored =
            score::score(image, truth.scoring, harness::score_options(method.threshold()));
        pool.row.measured += {scored.k, scored.n_pred, scored.n_truth};
        ++pool.row.views;
    }

    BoundStudyOptions options_;
    Asked asked_;
};

std::string share(double f) {
    return fmt::format("{:.4f}", f);
}

}  // namespace

void check_bound(const BoundStudyOptions& options) {
    (void)what_is_asked(options);
}

std::vector<BoundRow> study_bounds(const std::vector<harness::SceneViews>& scenes,
                                   const BoundStudyOptions& options) {
    Study study(options);
    Study of_pools(options);
    core::Progress progress("bound", static_cast<int>(scenes.size()) + 4);
    std::vector<BoundRow> rows;
    std::array parts = {study.empty_pool("(training)", "train"),
                        study.empty_pool("(held-out)", "heldout"),
                        study.empty_pool("(real)", "real")};
    int done = 0;
    for (const harness::SceneViews& scene_views : scenes) {
        if (core::is_interrupted()) return rows;
        progress.report(done++, scene_views.scene.name);
        const Pool pool = study.pool_of(scene_views);
        for (Pool& part : parts) {
            if (part.row.split == pool.row.split) part.add(pool);
        }
        rows.push_back(study.row_of(pool));
        of_pools.remember(rows.back().bound.weights);
    }
    Pool all = study.empty_pool("(all)", "");
    for (const Pool& part : parts)
        all.add(part);
    const auto present =
        std::count_if(parts.begin(), parts.end(), [](const Pool& part) { return part.scenes > 0; });
    for (const Pool* pool : {&parts[0], &parts[1], &parts[2], &all}) {
        if (core::is_interrupted()) return rows;
        progress.report(done++, pool->row.scene);
        if (pool->scenes > 1 && (pool != &all || present > 1))
            rows.push_back(of_pools.row_of(*pool));
    }
    return rows;
}

std::string bound_table(const std::vector<BoundRow>& rows) {
    core::Cells cells = {{"scene", "views", "F", "F model", "F found", "F upper", "gap", "boxes"}};
    for (const BoundRow& row : rows) {
        cells.push_back({row.scene,
                         fmt::format("{}", row.views),
                         share(row.measured.f()),
                         row.modelled ? share(row.modelled->f()) : "-",
                         share(row.bound.f_found),
                         share(row.bound.f_upper),
                         share(row.bound.gap()),
                         fmt::format("{}", row.bound.boxes)});
    }
    return core::aligned(cells);
}

}  // namespace ink::linear_code
