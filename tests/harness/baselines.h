#pragma once

#include "harness/cells/view_cells.h"
#include "score/coverage.h"

namespace ink::harness {

/// The baselines of a scene's first view, scored in full or as settings are.
inline std::vector<Evaluation> baselines_of(const SceneViews& scene_views,
                                            CellOptions options,
                                            bool is_full = true) {
    truth::SceneModel model(scene_views.scene, options.trace.truth);
    const scene::View& view = scene_views.views.front();
    const TracedView traced = trace_with_facts(model, scene_views.scene, view, options.trace);
    std::vector<Evaluation> evaluations;
    options.scores = is_full ? Scores::full : Scores::brief;
    finish_evaluations(scene_views.scene, view, traced, options, evaluations);
    return evaluations;
}

/// The same of a scene of the catalogue, without a cross-check.
inline std::vector<Evaluation> baselines_of(
    const char* scene,
    std::pair<int, int> size_px,
    bool is_full = true,
    score::Intersections intersections = CellOptions().trace.intersections) {
    ViewRequest request;
    request.width_px = size_px.first;
    request.height_px = size_px.second;
    CellOptions options;
    options.trace.crosscheck = false;
    options.line_width_px = score::kLineWidth_px;
    options.trace.intersections = intersections;
    return baselines_of(make_scene_views(load_scene(scene), request), options, is_full);
}

}  // namespace ink::harness
