#include "truth/drawn_lines.h"

#include "truth/eye_scene.h"
#include "truth/eye_view.h"

namespace ink::truth {
namespace {

std::vector<Polyline> joined_by_class(std::vector<Curve> curves) {
    for (Curve& curve : curves)
        curve.kind = ContourKind::none;
    return join_curves(curves);
}

}  // namespace

DrawnLines trace_drawn_lines(const Model& model,
                             const scene::View& view,
                             const TruthTrace& trace,
                             Hidden hidden) {
    if (view.width_px <= 0 || view.height_px <= 0) return {};
    const EyeView eye(model, view, trace.threads);
    const EyeScene scene(model.topology, view.camera, trace.threads);
    TracedLines lines = trace_lines(eye, scene, trace, hidden);
    return {joined_by_class(std::move(lines.curves)), joined_by_class(std::move(lines.hidden))};
}

}  // namespace ink::truth
