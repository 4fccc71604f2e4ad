#include "experiment/view_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/error.h"
#include "core/named.h"
#include "core/param.h"
#include "core/parse_number.h"
#include "core/split_list.h"
#include "experiment/experiment.h"

namespace ink::experiment {
namespace {

constexpr double kMostMargin = 0.45;

glm::dvec3 parse_point(const std::string& text, const std::string& option) {
    const std::vector<std::string> parts = core::split_list(text);
    glm::dvec3 point{0};
    bool is_point = parts.size() == 3;
    for (int i = 0; is_point && i < 3; ++i) {
        point[i] = core::parse_number<double>(parts[static_cast<std::size_t>(i)]).value_or(NAN);
        is_point = std::isfinite(point[i]);
    }
    if (!is_point) {
        throw core::Error(option, fmt::format("'{}' is no point", text), "X,Y,Z");
    }
    return point;
}

/// A direction, which has a length.
glm::dvec3 parse_direction(const std::string& text, const std::string& option) {
    const glm::dvec3 direction = parse_point(text, option);
    if (direction == glm::dvec3(0)) {
        throw core::Error(option,
                          fmt::format("'{}' is no direction: its length is 0", text),
                          "X,Y,Z that are not all 0");
    }
    return direction;
}

/// What belongs to a camera that is set by hand says nothing without one.
void refuse_without_eye(const ViewOptions& options) {
    const auto refuse = [](const char* option) {
        throw core::Error(
            option, "there is no --eye, whose camera it would set", "--eye X,Y,Z beside it");
    };
    if (!options.eyes.empty()) return;
    if (!options.targets.empty()) refuse("--target");
    if (options.fov_deg) refuse("--fov");
}

void parse_cameras(const ViewOptions& options, harness::ViewRequest& request) {
    refuse_without_eye(options);
    if (options.targets.size() > options.eyes.size()) {
        throw core::Error(
            "--target", "there are more targets than eyes", "one --eye for each --target");
    }
    for (std::size_t i = 0; i < options.eyes.size(); ++i) {
        harness::CameraRequest camera;
        camera.eye_world = parse_point(options.eyes[i], "--eye");
        if (i < options.targets.size()) {
            camera.target_world = parse_point(options.targets[i], "--target");
        }
        camera.fov_y_rad = glm::radians(options.fov_deg.value_or(kFov_deg));
        request.cameras.push_back(camera);
    }
}

/// Of cameras that are set by hand, or of views by name.
void parse_up(const ViewOptions& options, harness::ViewRequest& request) {
    if (!options.up) return;
    const auto axis = std::ranges::find(harness::kUpAxisNames, *options.up);
    const auto number = axis - harness::kUpAxisNames.begin();
    const bool is_axis = axis != harness::kUpAxisNames.end();
    glm::dvec3 up_world(0);
    if (is_axis) up_world[static_cast<int>(number)] = 1;
    if (!request.cameras.empty()) {
        if (!is_axis) up_world = parse_direction(*options.up, "--up");
        for (harness::CameraRequest& camera : request.cameras)
            camera.up_world = up_world;
    } else if (request.directions.empty()) {
        throw core::Error("--up",
                          "there is no --eye and no view by name, in which it would be up",
                          "--eye X,Y,Z or --views front,top beside it");
    } else if (!is_axis) {
        throw core::Error("--up", fmt::format("'{}' is no axis", *options.up), "x, y, z");
    } else {
        request.up = static_cast<harness::UpAxis>(number);
    }
}

void parse_projection_options(const ViewOptions& options, harness::ViewRequest& request) {
    std::vector<core::GivenText> names;
    for (const std::string& name : core::split_list(options.projection))
        names.push_back({name, "--projection"});
    request.projections = parse_projections(names);
    if (!options.parallel_height) return;
    const double height = *options.parallel_height;
    if (!(height > 0 && std::isfinite(height))) {
        throw core::Error("--parallel",
                          fmt::format("the height seen cannot be {:g}", height),
                          "a length above 0, in the scene's units");
    }
    if (options.fit == "box") {
        throw core::Error("--parallel", "--fit box finds the height", "one of the two");
    }
    if (options.fov_deg) {
        throw core::Error("--fov", "there is a --parallel beside it", "one of the two");
    }
    if (request.projections == std::vector{scene::ProjectionKind::perspective}) {
        throw core::Error(
            "--parallel", "the projection is perspective", "--projection parallel, or --fov");
    }
    for (harness::CameraRequest& camera : request.cameras)
        camera.height_world = height;
    if (!request.cameras.empty()) return;
    request.height_world = height;
    if (request.projections.empty()) request.projections = {scene::ProjectionKind::parallel};
}

void parse_framing(const ViewOptions& options, harness::ViewRequest& request) {
    if (options.fit != "" && options.fit != "sphere" && options.fit != "box")
        throw core::Error(
            "--fit", fmt::format("'{}' is no way to fit", options.fit), "sphere, box");
    if (options.fit == "box") request.fit = harness::Fit::box;
    if (options.fit == "sphere") request.fit = harness::Fit::sphere;
    if (options.margin) {
        if (request.fit != harness::Fit::box)
            throw core::Error("--margin", "there is no --fit box beside it", "--fit box");
        if (!(*options.margin >= 0 && *options.margin <= kMostMargin)) {
            throw core::Error("--margin",
                              fmt::format("the margin cannot be {:g}", *options.margin),
                              fmt::format("0..{:g} of the frame", kMostMargin));
        }
    }
    request.margin = options.margin;
    request.objects = options.objects;
    const bool is_framed = request.fit || !request.objects.empty();
    if (is_framed && (!request.cameras.empty() || options.views == "file")) {
        throw core::Error(request.fit ? "--fit" : "--object",
                          "the cameras are given, so there is nothing to frame",
                          "no --eye and no --views file beside it");
    }
}

std::string accepted_views(const std::string& wrong) {
    return "1..360, file, or some of " +
           core::known_names(core::names_of(scene::drawing_views()), wrong);
}

/// Names of views, each once.
std::vector<scene::NamedDirection> parse_directions(const std::string& names) {
    const auto known = scene::drawing_views();
    std::vector<scene::NamedDirection> directions;
    for (const std::string& name : core::split_list(names)) {
        const auto* direction = core::find_named(known, name);
        if (direction == nullptr)
            throw core::Error(
                "--views", fmt::format("there is no '{}'", name), accepted_views(name));
        if (core::find_named(directions, name) != nullptr)
            throw core::Error("--views", fmt::format("'{}' is named twice", name), "each once");
        directions.push_back(*direction);
    }
    if (directions.empty())
        throw core::Error("--views", fmt::format("'{}' names none", names), accepted_views(names));
    return directions;
}

void parse_views(const std::string& views, harness::ViewRequest& request) {
    if (views.empty()) return;
    if (views == "file") {
        request.file_cameras = true;
    } else if (const int count = core::parse_number<int>(views).value_or(0);
               count >= 1 && count <= 360) {
        request.orbit_count = count;
    } else {
        request.directions = parse_directions(views);
    }
}

}  // namespace

harness::ViewRequest view_request(const ViewOptions& options) {
    harness::ViewRequest request;
    const ImageSize size = parse_image_size(options.size, "--size");
    request.width_px = size.width_px;
    request.height_px = size.height_px;
    parse_cameras(options, request);
    parse_framing(options, request);
    parse_views(options.views, request);
    parse_up(options, request);
    parse_projection_options(options, request);
    if (options.time_s && options.frame) {
        throw core::Error("--time", "there is a --frame beside it", "one of the two");
    }
    request.time_s = options.time_s;
    request.frame = options.frame;
    request.model.animation = options.animation;
    request.model.material_seams = harness::parse_seams(options.seams, "--seams");
    return request;
}

}  // namespace ink::experiment
