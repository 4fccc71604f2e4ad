#include "methods/auto/auto.h"

#include <glm/trigonometric.hpp>

namespace ink::methods {
namespace {

/// From the fastest to the most exact, the method as it comes among them. Thresholds go with their
/// settings: found by ODS over the training scenes at 1280x720.
std::vector<core::ParamValues> sweep() {
    return {
        {},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // Depth alone everywhere: the least that a code can be.
        {{"channels", "depth"}, {"threshold", "3"}},
        {{"channels", "depth"}, {"bytes", "1"}, {"depth_format", "z16"}, {"threshold", "3"}},
        // Normals everywhere.
        {{"channels", "all"}, {"threshold", "253"}},
        // One size of code for all scenes.
        {{"bytes", "1"}},
        {{"bytes", "2"}},
        // One pixel wide instead of two: less to thin.
        {{"response", "positive"}},
        // One encoding for all scenes: the seeds', and the other one.
        {{"depth_encoding", "inverse"}},
        {{"depth_encoding", "log"}},
        // Bolder and shyer.
        {{"step_scale", "0.5"}},
        {{"step_scale", "2"}},
    };
}

buffers::PackParams pack_params(const Auto::Params& params) {
    buffers::PackParams pack;
    pack.crease_deg = params.crease_deg;
    pack.interpolation = params.interpolation;
    pack.depth_format = params.depth_format;
    pack.response = params.response;
    pack.threshold = params.threshold;
    return pack;
}

}  // namespace

core::ParamTable<Auto::Params> Auto::table() {
    core::ParamTable<Params> table;
    return table
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
                "Factor on the planned least step that is a line.")
        .number(&Params::crease_deg,
                "crease_deg",
                {0, 180},
                "deg",
                "Least dihedral deviation of a crease, in the plan and in the normals.")
        .choice(&Params::interpolation,
                "interpolation",
                {"affine", "perspective"},
                "Linear on the screen, as 1998's hardware did, or on the surface.")
        .choice(&Params::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth test.")
        .choice(&Params::response,
                "response",
                {"absolute", "positive"},
                "|L|, or its positive half, one pixel wide.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Least edge response of a line pixel; a step as planned has 64.");
}

Auto::Auto(const Params& params) : params_(params) {
    replan({});
}

void Auto::replan(const scene::Scene& scene) {
    plan_ =
        make_plan(scene::make_scene_statistics(scene, glm::radians(params_.crease_deg)), params_);
    buffer_ = std::make_unique<buffers::PackedBuffer>(plan_.applied_to(pack_params(params_)),
                                                      plan_.layout());
    planned_hash_ = scene::scene_hash(scene);
}

void Auto::prepare(const scene::Scene& scene) {
    replan(scene);
    buffer_->prepare(scene);
}

void Auto::pose(const scene::Scene& scene) {
    if (scene::scene_hash(scene) != planned_hash_) prepare(scene);
    buffer_->pose(scene);
}

method::MethodInfo auto_method() {
    method::MethodInfo info = method::method_info<Auto>(
        "auto",
        "new here; a code in MOTE's manner, planned for the scene",
        "one or two bytes of what the scene's statistics says can make a line");
    info.family = method::Family::packed;
    info.marker = method::Marker::up;
    info.is_planned = true;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
