#include "draw/drawn_lines.h"

#include "truth/eye_scene.h"
#include "truth/eye_view.h"

namespace ink::draw {
namespace {

std::vector<truth::Polyline> joined(std::vector<truth::Curve> curves) {
    for (truth::Curve& curve : curves)
        curve.kind = truth::ContourKind::none;
    return truth::join_curves(curves);
}

}  // namespace

truth::TracedLines trace_drawn_lines(const truth::Model& model,
                                     const scene::View& view,
                                     const truth::TruthTrace& trace,
                                     truth::Hidden hidden) {
    if (view.width_px <= 0 || view.height_px <= 0) return {};
    const truth::EyeView eye(model, view, trace.threads);
    const truth::EyeScene scene(model.topology, view.camera, trace.threads);
    return truth::trace_lines(eye, scene, trace, hidden);
}

DrawnLines joined_by_class(truth::TracedLines lines) {
    return {joined(std::move(lines.curves)), joined(std::move(lines.hidden))};
}

}  // namespace ink::draw
