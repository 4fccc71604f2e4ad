#include "truth/truth.h"

#include <chrono>

#include "scene/precision/rounding.h"
#include "truth/curve_facts.h"
#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/label_image.h"
#include "truth/model.h"
#include "truth/sampled.h"
#include "truth/trace_layers.h"
#include "truth/trace_lines.h"

namespace ink::truth {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TruthCounts counts_of(const Model& model,
                      const scene::View& view,
                      const TracedLines& lines,
                      const LabelImage& image) {
    TruthCounts counts;
    counts.triangles = model.topology.counts.triangles;
    counts.degenerate = model.topology.counts.degenerate;
    counts.duplicate = model.topology.counts.duplicate;
    counts.joined_vertices = model.topology.counts.joined_vertices;
    counts.collapsed = model.topology.counts.collapsed;
    counts.defect_edges = model.defect_edges;
    counts.candidate_edges = lines.candidate_edges;
    counts.samples = lines.samples;
    counts.rays = lines.rays;
    counts.pairs_tested = model.crossings.pairs_tested;
    counts.crossings = model.crossings.segments.size();
    counts.contacts = model.crossings.contacts.size();
    counts.merged_px = image.merged_px;
    counts.crowded_share = image.crowded_share;
    counts.rounding_px = scene::most_rounding_px(model.topology, view);
    return counts;
}

}  // namespace

Truth trace_truth(const Model& model, const scene::View& view, const TruthTrace& trace) {
    const auto begin = std::chrono::steady_clock::now();
    if (view.width_px <= 0 || view.height_px <= 0) return {};
    if (model.crossings.is_too_many) {
        throw TooLarge(
            "more pairs of triangles touch than the search for crossings may look at; fewer "
            "objects "
            "that grow into each other, or a simpler mesh, would help");
    }
    const EyeView eye(model, view, trace.threads);
    const EyeScene scene(model.topology, view.camera.eye_world, trace.threads);

    Truth truth;
    TracedLines lines = trace_lines(eye, scene, trace);
    lines.rays += fill_curve_facts(eye, scene, lines.curves, trace.threads);
    LabelImage image = draw_labels(lines.curves, view.width_px, view.height_px, model.crease_rad);
    truth.counts = counts_of(model, view, lines, image);
    truth.labels = std::move(image.labels);
    truth.below_crease = std::move(image.below_crease);
    truth.curves = std::move(lines.curves);
    if (trace.layers) {
        TracedLayers seen = trace_layers(eye, scene, trace.threads);
        truth.sampled = draw_sampled(eye, seen.face, trace.threads);
        truth.exact_corner =
            draw_exact_corner(eye, trace_corners(eye, scene, trace.threads), trace.threads);
        truth.layers = std::move(seen.layers);
    }
    truth.trace_s = seconds_since(begin);
    return truth;
}

Truth trace_truth(const scene::Scene& scene, const scene::View& view, const TruthOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    const Model model = build_model(scene, options);
    Truth truth = trace_truth(
        model, view, {options.threads, options.layers, options.limits, options.progress});
    truth.trace_s = seconds_since(begin);
    return truth;
}

}  // namespace ink::truth
