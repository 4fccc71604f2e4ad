#include "experiment/options/option_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/named.h"
#include "core/param.h"
#include "core/parse_number.h"
#include "core/split_list.h"
#include "core/toml_reader.h"
#include "core/whole_file.h"

namespace ink::experiment {
namespace {

using Texts = std::vector<std::string>;
using Given = std::vector<core::GivenText>;
using Kind = core::ParamKind;
using V = harness::ViewRequest;

constexpr double kMostMargin = 0.45;

/// Of options: one of several, split at commas.
Given split(const Given& lists) {
    Given parts;
    for (const core::GivenText& list : lists) {
        for (std::string& part : core::split_list(list.text))
            parts.push_back({std::move(part), list.where});
    }
    return parts;
}

std::string accepted_views(const std::string& wrong) {
    return "1..360, file, or some of " +
           core::known_names(core::names_of(scene::drawing_views()), wrong);
}

/// Names of views, each once.
void read_directions(Experiment& e, const Given& names) {
    const auto known = scene::drawing_views();
    std::vector<scene::NamedDirection>& directions = e.view_request.directions;
    directions.clear();
    for (const core::GivenText& name : names) {
        const auto* direction = core::find_named(known, name.text);
        if (direction == nullptr)
            throw core::Error(
                name.where, fmt::format("there is no '{}'", name.text), accepted_views(name.text));
        if (core::find_named(directions, name.text) != nullptr)
            throw core::Error(
                name.where, fmt::format("'{}' is named twice", name.text), "each once");
        directions.push_back(*direction);
    }
}

/// A number, "file", or names.
void read_views(Experiment& e, const Given& given) {
    const std::string& views = given.front().text;
    if (views.empty()) return;
    const int count = core::parse_number<int>(views).value_or(0);
    if (views == "file") {
        e.view_request.file_cameras = true;
    } else if (count >= 1 && count <= 360) {
        e.view_request.orbit_count = count;
    } else {
        read_directions(e, split(given));
        if (e.view_request.directions.empty()) {
            throw core::Error(
                given.front().where, fmt::format("'{}' names none", views), accepted_views(views));
        }
    }
}

void read_projections(Experiment& e, const Given& given) {
    const auto& known = scene::kProjectionNames;
    std::vector<scene::ProjectionKind>& kinds = e.view_request.projections;
    kinds.clear();
    for (const core::GivenText& name : split(given)) {
        const auto at = std::find(known.begin(), known.end(), name.text) - known.begin();
        const auto kind = static_cast<scene::ProjectionKind>(at);
        const bool is_known = at < std::ssize(known);
        if (!is_known || std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) {
            throw core::Error(name.where,
                              is_known ? fmt::format("'{}' is named twice", name.text)
                                       : fmt::format("there is no projection '{}'", name.text),
                              fmt::format("{}, or both", fmt::join(known, ", ")));
        }
        kinds.push_back(kind);
    }
}

Texts projections_text(const Experiment& e) {
    Texts texts;
    for (const scene::ProjectionKind kind : e.view_request.projections)
        texts.emplace_back(scene::kProjectionNames[static_cast<std::size_t>(kind)]);
    return texts;
}

void read_fit(Experiment& e, const Given& given) {
    const auto& [fit, where, number] = given.front();
    if (fit != "sphere" && fit != "box")
        throw core::Error(where, fmt::format("'{}' is no way to fit", fit), "sphere, box");
    e.view_request.fit = fit == "box" ? harness::Fit::box : harness::Fit::sphere;
}

Texts fit_text(const Experiment& e) {
    if (!e.view_request.fit) return {};
    return {*e.view_request.fit == harness::Fit::box ? "box" : "sphere"};
}

void read_objects(Experiment& e, const Given& objects) {
    e.view_request.objects.clear();
    for (const core::GivenText& object : objects)
        e.view_request.objects.push_back(object.text);
}

void read_eyes(Experiment& e, const Given& eyes) {
    e.view_request.cameras.clear();
    for (const core::GivenText& eye : eyes)
        e.view_request.cameras.emplace_back().eye_world = parse_point(eye);
}

/// The cameras that an option belongs to.
std::vector<harness::CameraRequest>& cameras_for(Experiment& e, const Given& given) {
    if (!e.view_request.cameras.empty()) return e.view_request.cameras;
    throw core::Error(given.front().where,
                      "there is no --eye, whose camera it would set",
                      "--eye X,Y,Z beside it");
}

void read_targets(Experiment& e, const Given& targets) {
    auto& cameras = cameras_for(e, targets);
    if (targets.size() > cameras.size()) {
        throw core::Error(targets.front().where,
                          "there are more targets than eyes",
                          "one --eye for each --target");
    }
    for (std::size_t i = 0; i < targets.size(); ++i)
        cameras[i].target_world = parse_point(targets[i]);
}

void read_fov(Experiment& e, const Given& given) {
    auto& cameras = cameras_for(e, given);
    if (e.view_request.height_world)
        throw core::Error(given.front().where, "there is a --parallel beside it", "one of the two");
    const auto fov_deg = core::parse_number<double>(given.front().text);
    if (!fov_deg)
        throw core::Error(given.front().where,
                          fmt::format("'{}' is no number", given.front().text),
                          harness::kFovs_deg);
    for (harness::CameraRequest& camera : cameras)
        camera.fov_deg = harness::checked_fov_deg(*fov_deg);
}

std::optional<harness::UpAxis> axis_called(const std::string& name) {
    const auto& names = harness::kUpAxisNames;
    const auto at = std::ranges::find(names, name);
    if (at == names.end()) return std::nullopt;
    return static_cast<harness::UpAxis>(at - names.begin());
}

/// Of cameras that are set by hand a direction, of views by name an axis.
void read_up(Experiment& e, const Given& given) {
    const core::GivenText& up = given.front();
    V& request = e.view_request;
    if (!request.cameras.empty()) {
        for (harness::CameraRequest& camera : request.cameras)
            camera.up_world = parse_direction(up);
        return;
    }
    if (request.directions.empty())
        throw core::Error(up.where,
                          "there is no --eye and no view by name, in which it would be up",
                          "--eye X,Y,Z or --views front,top beside it");
    request.up = axis_called(up.text);
    if (!request.up)
        throw core::Error(up.where, fmt::format("'{}' is no axis", up.text), "x, y, z");
}

Texts up_text(const Experiment& e) {
    return e.view_request.up ? Texts{std::string(name(*e.view_request.up))} : Texts{};
}

void read_animation(Experiment& e, const Given& given) {
    e.view_request.model.animation = given.front().text;
}

Texts animation_text(const Experiment& e) {
    const std::string& animation = e.view_request.model.animation;
    return animation.empty() ? Texts{} : Texts{animation};
}

/// A number that may be left out, in the range of `param`.
template <auto kMember>
void add_number(core::ParamTable<Experiment>& rows, const core::Param& param) {
    rows.texts(
        param,
        [param](Experiment& e, const Given& given) {
            using Number =
                typename std::remove_reference_t<decltype(e.view_request.*kMember)>::value_type;
            const bool is_option = given.front().where.starts_with("--");
            e.view_request.*kMember = static_cast<Number>(
                core::parse_param(param, given.front(), is_option ? "it" : param.name));
        },
        [](const Experiment& e) {
            const auto& number = e.view_request.*kMember;
            return number ? Texts{fmt::format("{}", *number)} : Texts{};
        });
}

/// Of an option that commands alone have: it is kept elsewhere.
Texts none(const Experiment&) {
    return {};
}

constexpr const char* kNeeded = "file, kind";

void add_models(core::TomlReader& table, std::vector<harness::ListedModel>& models) {
    for (core::TomlReader& entry : table.tables("model")) {
        harness::ListedModel model{entry.needed_text("file", kNeeded),
                                   entry.needed_text("kind", kNeeded)};
        const std::string split = entry.text("split").value_or("real");
        if (split != "real" && split != "train") {
            throw core::Error(
                entry.where("split"), fmt::format("there is no split '{}'", split), "train, real");
        }
        if (split == "train") model.split = scene::Split::train;
        if (std::ranges::count(models, model.file, &harness::ListedModel::file) > 0) {
            throw core::Error(entry.where("file"),
                              fmt::format("'{}' is listed twice", model.file),
                              "each file once");
        }
        models.push_back(std::move(model));
    }
}

}  // namespace

glm::dvec3 parse_point(const core::GivenText& given) {
    const std::vector<std::string> parts = core::split_list(given.text);
    glm::dvec3 point{0};
    bool is_point = parts.size() == 3;
    for (int i = 0; is_point && i < 3; ++i) {
        point[i] = core::parse_number<double>(parts[static_cast<std::size_t>(i)]).value_or(NAN);
        is_point = std::isfinite(point[i]);
    }
    if (!is_point)
        throw core::Error(given.where, fmt::format("'{}' is no point", given.text), "X,Y,Z");
    return point;
}

glm::dvec3 parse_direction(const core::GivenText& given) {
    const auto axis = axis_called(given.text);
    if (!axis) return checked_direction(parse_point(given), given);
    glm::dvec3 direction(0);
    direction[static_cast<int>(*axis)] = 1;
    return direction;
}

glm::dvec3 checked_direction(const glm::dvec3& direction, const core::GivenText& given) {
    if (direction != glm::dvec3(0)) return direction;
    throw core::Error(given.where,
                      fmt::format("'{}' is no direction: its length is 0", given.text),
                      "X,Y,Z that are not all 0");
}

void add_view_rows(OptionTable& table) {
    constexpr unsigned kCompare = bit(ExperimentKind::compare);
    constexpr unsigned kAnimation = bit(ExperimentKind::animation);
    constexpr unsigned kNoFile = 0;
    constexpr double kMost = std::numeric_limits<double>::infinity();
    constexpr double kMostInt = std::numeric_limits<int>::max();
    const auto in = [&table](auto... place) -> auto& {
        return table.in(place...);
    };
    // clang-format off
    in(kNoFile, "--views").texts(
        {.name = "views.views", .kind = Kind::text, .unit = "N|NAME,...|file",
         .doc = "N views round the scene, names (front, back, left, right, top, bottom, iso), or "
                "'file' for the model's own cameras (default: a built-in scene's own views, "
                "three round a model); named views are parallel"},
        read_views, none);
    add_number<&V::orbit_count>(in(kCompare),
        {.name = "views.orbit", .kind = Kind::integer, .min = 1, .max = 360,
         .doc = "N views round the scene"});
    in(kCompare).texts(
        {.name = "views.directions", .kind = Kind::list, .doc = "Views round the scene by name"},
        read_directions,
        [](const Experiment& e) { return core::names_of(e.view_request.directions); });
    in(kCompare).flag(
        kField<&Experiment::view_request, &V::file_cameras>, "views.file_cameras",
        "The model's own cameras");
    in(kCompare | kAnimation, "--projection").texts(
        {.name = "grid.projections", .kind = Kind::list,
         .choices = {scene::kProjectionNames.begin(), scene::kProjectionNames.end()},
         .unit = "perspective|parallel",
         .doc = "How all views look, or both ways by commas (default: in perspective, but for "
                "named views and a file's parallel cameras)"},
        read_projections, projections_text);
    table.options.back().is_once = true;
    add_number<&V::height_world>(in(kCompare, "--parallel"),
        {.name = "views.parallel_height", .kind = Kind::real, .min = -kMost, .max = kMost,
         .unit = "HEIGHT",
         .doc = "Height that parallel views show, in the scene's units, instead of --fov "
                "(default: as much as a pinhole sees at the scene's middle)"});
    in(kCompare, "--fit").texts(
        {.name = "views.fit", .kind = Kind::text, .unit = "sphere|box",
         .doc = "What views round the scene are fitted to: its bounding sphere, or what each "
                "view shows of it (default: sphere)"},
        read_fit, fit_text);
    add_number<&V::margin>(in(kCompare, "--margin"),
        {.name = "views.margin", .kind = Kind::real, .max = kMostMargin, .unit = "SHARE",
         .doc = "Share of the frame that --fit box leaves free on either side (default: 0.04)"});
    in(kCompare, "--object").texts(
        {.name = "views.objects", .kind = Kind::list, .unit = "NAME",
         .doc = "Frame this object of the scene only; may be given again"},
        read_objects, [](const Experiment& e) { return e.view_request.objects; });
    in(kNoFile, "--eye").texts(
        {.name = "views.eye", .kind = Kind::list, .unit = "X,Y,Z",
         .doc = "Eye position instead of --views; may be given again for more views"},
        read_eyes, none);
    in(kNoFile, "--target").texts(
        {.name = "views.target", .kind = Kind::list, .unit = "X,Y,Z",
         .doc = "Point looked at, one per --eye (default: the scene's centre)"},
        read_targets, none);
    in(kCompare, "--up").texts(
        {.name = "views.up", .kind = Kind::text, .unit = "x|y|z|X,Y,Z",
         .doc = "What is up: with --eye a direction, in views by name an axis (default: y, but "
                "z for views by name of .stl files)"},
        read_up, up_text);
    in(kNoFile, "--fov").texts(
        {.name = "views.fov_deg", .kind = Kind::text, .unit = "DEGREES",
         .doc = fmt::format("Vertical field of view, with --eye (default: {:g})",
                            harness::CameraRequest{}.fov_deg)},
        read_fov, none);
    add_number<&V::time_s>(in(kCompare, "--time"),
        {.name = "views.time_s", .kind = Kind::real, .min = -kMost, .max = kMost, .unit = "SECONDS",
         .doc = "Moment of an animated scene (default: its rest pose)"});
    add_number<&V::frame>(in(kCompare, "--frame"),
        {.name = "views.frame", .kind = Kind::integer, .max = kMostInt,
         .unit = "N", .doc = "A stored frame's number, instead of --time"});
    in(kCompare, "--animation").texts(
        {.name = "views.animation", .kind = Kind::text, .unit = "NAME|N",
         .doc = "Which animation of a model file moves it (default: the first; inkbench "
                "explain names all)"},
        read_animation, animation_text);
    in(kCompare | kAnimation, "--seams").choice(
        [](auto& e) -> auto& { return e.view_request.model.material_seams; },
        "grid.seams", {"objects", "materials"},
        "Where a smooth surface has seams: between objects of a model file, or between their "
        "materials, too");
    // clang-format on
}

const std::vector<std::string>& view_rows() {
    static const std::vector<std::string> rows = core::split_list(
        "grid.sizes, views.views, grid.projections, views.parallel_height, views.fit, "
        "views.margin, views.objects, views.eye, views.target, views.up, views.fov_deg, "
        "views.time_s, views.frame, views.animation, grid.seams");
    return rows;
}

void settle_views(harness::ViewRequest& request) {
    if (request.margin && request.fit != harness::Fit::box)
        throw core::Error("--margin", "there is no --fit box beside it", "--fit box");
    const bool is_framed = request.fit || !request.objects.empty();
    if (is_framed && (!request.cameras.empty() || request.file_cameras)) {
        throw core::Error(request.fit ? "--fit" : "--object",
                          "the cameras are given, so there is nothing to frame",
                          "no --eye and no --views file beside it");
    }
    if (request.time_s && request.frame)
        throw core::Error("--time", "there is a --frame beside it", "one of the two");
    if (!request.height_world) return;
    (void)harness::checked_height(*request.height_world);
    if (request.fit == harness::Fit::box)
        throw core::Error("--parallel", "--fit box finds the height", "one of the two");
    if (request.projections == std::vector{scene::ProjectionKind::perspective}) {
        throw core::Error(
            "--parallel", "the projection is perspective", "--projection parallel, or --fov");
    }
    if (request.cameras.empty()) {
        if (request.projections.empty()) request.projections = {scene::ProjectionKind::parallel};
        return;
    }
    for (harness::CameraRequest& camera : request.cameras)
        camera.height_world = request.height_world;
    request.height_world.reset();
}

std::vector<harness::ListedModel> read_model_list(const std::filesystem::path& path) {
    const auto text = core::read_whole_file(path);
    if (!text) {
        throw core::Error(
            path.string(), "it cannot be read", "a list of models (see experiments/models.toml)");
    }
    core::TomlReader file(*text, path);
    std::vector<harness::ListedModel> models;
    add_models(file, models);
    for (core::TomlReader& package : file.tables("package"))
        add_models(package, models);
    if (models.empty()) {
        throw core::Error(path.string(), "it lists no model", "[[model]] tables with file, kind");
    }
    return models;
}

}  // namespace ink::experiment
