#include "experiment/options/option_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "catalogue/catalogue.h"
#include "core/error.h"
#include "core/named.h"
#include "core/parse_number.h"
#include "entrants/entrant.h"
#include "methods/registry.h"
#include "raster/skips.h"
#include "studies/axis.h"

namespace ink::experiment {
namespace {

/// A seed. Throws core::Error unless it is a whole number of 64 bits.
std::uint64_t parse_seed(const core::GivenText& given) {
    const auto seed = core::parse_number<std::uint64_t>(given.text);
    if (!seed) {
        throw core::Error(given.where,
                          fmt::format("'{}' is no seed", given.text),
                          "a whole number 0..18446744073709551615");
    }
    return *seed;
}

using Texts = std::vector<std::string>;
using Given = std::vector<core::GivenText>;
using Kind = core::ParamKind;

constexpr unsigned kCompare = bit(ExperimentKind::compare);
constexpr unsigned kStress = bit(ExperimentKind::stress);
constexpr unsigned kAnimation = bit(ExperimentKind::animation);
constexpr unsigned kTimed = kCompare | kStress;
constexpr unsigned kAll = kTimed | kAnimation;

constexpr double kMaxWeldEpsilon = 0.01;  // more would flatten the things themselves

/// Adds names that are not there yet.
void add_new(const Texts& names, Texts& all) {
    for (const std::string& name : names) {
        if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
    }
}

void check_scene(const core::GivenText& scene) {
    Texts known = {"catalogue", "train", "heldout"};
    add_new(core::names_of(catalogue::catalogue()), known);
    if (std::find(known.begin(), known.end(), scene.text) != known.end()) return;
    std::error_code error;  // a name that is too long is no file either
    if (std::filesystem::is_regular_file(scene.text, error)) return;
    throw core::Error(scene.where,
                      fmt::format("there is no scene, and no file, called '{}'", scene.text),
                      core::known_names(known, scene.text));
}

void read_scenes(Experiment& experiment, const Given& scenes) {
    experiment.scenes.clear();
    for (const core::GivenText& scene : scenes) {
        check_scene(scene);
        add_new(scenes_called(scene.text), experiment.scenes);
    }
}

/// Grids of methods that no longer take part go, too.
void read_methods(Experiment& experiment, const Given& methods) {
    experiment.methods.clear();
    for (const core::GivenText& method : methods) {
        at_place(method.where, [&] {
            add_new(method.text == "all" ? core::names_of(methods::registry())
                                         : Texts{methods::find_method(method.text).name},
                    experiment.methods);
        });
    }
    std::erase_if(experiment.compare.grids, [&](const SettingGrid& grid) {
        const Texts& names = experiment.methods;
        return std::find(names.begin(), names.end(), grid.method) == names.end();
    });
}

void read_entrants(Experiment& experiment, const Given& entrants) {
    for (const core::GivenText& entrant : entrants) {
        at_place(entrant.where, [&] { (void)entrants::parse_entrant(entrant.text); });
        experiment.compare.entrants.push_back(entrant.text);
    }
}

void read_sizes(Experiment& experiment, const Given& sizes) {
    experiment.sizes.clear();
    for (const core::GivenText& size : sizes)
        experiment.sizes.push_back(parse_image_size(size.text, size.where));
    if (experiment.kind == ExperimentKind::stress && sizes.size() > 1)
        throw core::Error(sizes.front().where, "stress has several sizes", "one size");
}

void read_threads(Experiment& experiment, const Given& counts) {
    const core::Param param{"", Kind::integer, 1, 256, 1, {}, "", ""};
    experiment.threads.clear();
    for (const core::GivenText& count : counts)
        experiment.threads.push_back(static_cast<int>(parse_param(param, count, "threads")));
    if (experiment.kind == ExperimentKind::stress && counts.size() > 1)
        throw core::Error(counts.front().where, "stress has several", "one: they are an axis");
}

/// What `text_of` makes of each.
template <class All, class TextOf>
Texts texts_of(const All& all, TextOf text_of) {
    Texts texts;
    for (const auto& each : all)
        texts.emplace_back(text_of(each));
    return texts;
}

std::string size_text(const ImageSize& size) {
    return fmt::format("{}x{}", size.width_px, size.height_px);
}

std::string_view antialias_name(methods::Antialias antialias) {
    return methods::kAntialiasNames[static_cast<std::size_t>(antialias)];
}

void read_listed_models(Experiment& experiment, const Given& given) {
    experiment.model_list = given.front().text;
    at_place(given.front().where,
             [&] { experiment.view_request.listed = read_model_list(experiment.model_list); });
}

Texts model_list_text(const Experiment& experiment) {
    return experiment.model_list.empty() ? Texts{} : Texts{experiment.model_list};
}

/// A list of texts that are taken as they are.
template <auto... kPath>
void read_names(Experiment& experiment, const Given& names) {
    Texts& all = kField<kPath...>(experiment);
    all.clear();
    for (const core::GivenText& name : names) {
        if (std::find(all.begin(), all.end(), name.text) != all.end())
            throw core::Error(
                name.where, fmt::format("'{}' is named twice", name.text), "each once");
        all.push_back(name.text);
    }
}
template <auto... kPath>
Texts names_text(const Experiment& experiment) {
    return kField<kPath...>(experiment);
}

OptionTable make_table() {
    using E = Experiment;
    using C = CompareRequest;
    using S = StressRequest;
    OptionTable table;
    const auto in = [&table](auto... place) -> auto& {
        return table.in(place...);
    };
    // clang-format off
    in(kAll, "--seed").texts(
        {.name = "seed", .kind = Kind::text, .unit = "N",
         .doc = "Of random images and of intervals; recorded in the rows"},
        [](E& e, const Given& given) { e.seed = parse_seed(given.front()); },
        [](const E& e) { return Texts{fmt::format("{}", e.seed)}; });

    in(kCompare | kAnimation).texts(
        {.name = "grid.scenes", .kind = Kind::list, .unit = "SCENE",
         .doc = "Built-in scenes or model files; train, heldout or catalogue"},
        read_scenes, names_text<&E::scenes>);
    in(kCompare).number(
        kField<&E::compare, &C::views>, "grid.views", {1, 360}, "N",
        "Views of each scene, the first N");
    in(kAll).texts(
        {.name = "grid.methods", .kind = Kind::list, .unit = "METHOD",
         .doc = "Methods that take part, or all"},
        read_methods, names_text<&E::methods>);
    in(kCompare, "--preset").texts(
        {.name = "grid.presets", .kind = Kind::list, .unit = "FILE",
         .doc = "A method with settings of its own, as inkbench tune writes it: a TOML file, "
                "beside the methods; may be given again"},
        read_names<&E::compare, &C::presets>, names_text<&E::compare, &C::presets>);
    in(kCompare, "--entrant").texts(
        {.name = "grid.entrants", .kind = Kind::list, .unit = "NAME=PATH",
         .doc = "A method from outside: a folder with SCENE/VIEW.png (and times.csv), or a program "
                "that is called as PROGRAM view.json out.png; may be given again (see "
                "methods/README.md)"},
        read_entrants, names_text<&E::compare, &C::entrants>);
    in(kAll, "--size").texts(
        {.name = "grid.sizes", .kind = Kind::list, .unit = "WIDTHxHEIGHT",
         .doc = "Image size in pixels"},
        read_sizes, [](const E& e) { return texts_of(e.sizes, size_text); });
    table.options.back().is_once = true;
    in(kAll, "--threads").texts(
        {.name = "grid.threads", .kind = Kind::list, .unit = "N",
         .doc = "Threads a method may use while it is timed"},
        read_threads,
        [](const E& e) { return texts_of(e.threads, [](int n) { return std::to_string(n); }); });
    table.options.back().is_once = true;
    in(kCompare | kAnimation, "--model-list").texts(
        {.name = "grid.model_list", .kind = Kind::text, .unit = "FILE",
         .doc = "Says of model files which kind of thing they are, and on which settings were "
                "found: a TOML file like experiments/models.toml"},
        read_listed_models, model_list_text);
    in(kTimed | kAnimation, "--antialias", "antialias").texts(
        {.name = "grid.antialias", .kind = Kind::list,
         .choices = {methods::kAntialiasNames.begin(), methods::kAntialiasNames.end()},
         .unit = "NAMES",
         .doc = "Samples of a pixel that methods draw: none, resolve4 (2 x 2) or resolve16 (4 x 4), "
                "averaged; of several each is a method of its own, NAME_resolve4 (default: none)"},
        [](E& e, const Given& given) { e.antialias = methods::parse_antialias(given); },
        [](const E& e) { return texts_of(e.antialias, antialias_name); });
    add_view_rows(table);
    in(kStress, "--axes,--axis", "axis").texts(
        {.name = "grid.axes", .kind = Kind::list, .choices = core::names_of(studies::stress_axes()),
         .unit = "AXES", .doc = "Axes a,b or globs (default: all; see inkbench list axes)"},
        read_names<&E::stress, &S::axes>, names_text<&E::stress, &S::axes>);
    in(kStress, "--points").number(
        kField<&E::stress, &S::points>, "grid.points", {2, 1000}, "N",
        "Points of an axis at most (default: all)");
    in(kStress, "--projection").choice(
        kField<&E::stress, &S::projection>, "grid.projection", scene::kProjectionNames,
        "How all cameras look");
    in(kAnimation).number(
        kField<&E::animation, &AnimationRequest::frames>, "grid.frames", {2, 10000}, "N",
        "Frames of a sequence");
    in(kAnimation).number(
        kField<&E::animation, &AnimationRequest::step_px>, "grid.step_px", {0.01, 8}, "PX",
        "By which the image moves a frame");
    in(kAnimation, "", "path").texts(
        {.name = "grid.paths", .kind = Kind::list,
         .choices = texts_of(scene::path_kinds(), [](auto kind) { return scene::name(kind); }), .unit = "PATHS",
         .doc = "Paths of the camera before any scene, instead of the sequences of the study"},
        read_names<&E::animation, &AnimationRequest::paths>,
        names_text<&E::animation, &AnimationRequest::paths>);

    in(kTimed, "--repetitions").number(
        &E::repetitions, "measure.repetitions", {1, 10000}, "N",
        "Timed drawings of a view, at most");
    in(kTimed).number(
        &E::budget_ms, "measure.budget_ms", {0, 1e6}, "MS",
        "Drawing of a method on a view after which repetitions end");
    in(kAll).flag(&E::times, "measure.times", "Times are measured; else their columns are empty");
    in(kCompare).flag(
        kField<&E::compare, &C::full_scores>, "measure.full_scores",
        "Curves, tolerance sweep, bins and causes; else F at 2 px alone");
    in(kAll, "--coverage").flag(
        &E::coverage, "measure.coverage",
        "Score grey lines, too: soft_f of each pixel's drawn share against the share that the true "
        "lines cover, with missing, surplus and misplaced ink. A comparison answers by it, and has "
        "it where a method that draws ink is named");
    in(kAll, "--line-width").number(
        &E::line_width_px, "measure.line_width_px",
        {score::kLeastLineWidth_px, score::kMostLineWidth_px}, "PX",
        "Width of grey lines: of the true ones with --coverage, and of those that methods draw with "
        "--antialias");
    in(kCompare, "--no-crosscheck,--no-witness").flag(
        &E::crosscheck, "measure.crosscheck", "Skip the independent check of the ground truth");
    in(kCompare, "--entrant-seconds").number(
        kField<&E::compare, &C::entrant_s>, "measure.entrant_seconds", {0.01, 86400}, "SECONDS",
        "Longest time of an entrant's program for one view");
    in(kAll, "--crease").number(
        &E::crease_deg, "measure.crease_deg", {0, 180}, "DEGREES",
        "Crease angle of the truth: edges with a larger dihedral deviation are creases; methods "
        "that use the same angle follow, unless --set says otherwise");
    in(kCompare, "--creases").choice(
        kField<&E::compare, &C::creases>, "measure.creases", scene::kCreaseSourceNames,
        "Which edges between two faces are creases of the truth: those of the crease angle, or "
        "those that the model's file marks (glTF, EXT_mesh_primitive_edge_visibility); methods "
        "keep their angle");
    in(kAll, "--weld-epsilon").number(
        &E::weld_epsilon, "measure.weld_epsilon", {0, kMaxWeldEpsilon}, "SHARE",
        "Weld vertices this near to each other, as a share of their part's diagonal (0: at the "
        "same place only)");
    in(kAll, "--intersections").choice(
        &E::intersections, "measure.intersections", score::kIntersectionNames,
        "Intersections that count: those that bend at least by the crease angle (flatter ones are "
        "neither required nor penalised), or all");
    in(kCompare, "--no-skip", "skip").texts(
        {.name = "measure.skips_off", .kind = Kind::list,
         .choices = core::names_of(raster::skip_infos()), .unit = "SKIPS",
         .doc = "Disable these optimisations, a,b or all (see inkbench list skips): other times, "
                "the same images"},
        read_names<&E::compare, &C::skips_off>,
        names_text<&E::compare, &C::skips_off>);
    in(kCompare, "--images").choice(
        kField<&E::compare, &C::images>, "measure.images", {"none", "first", "all"},
        "Views whose images are kept: none, the first of each scene, or all");

    in(kCompare, "--sweep-views").number(
        kField<&E::compare, &C::own_sweep_views>, "sweep.own_views", {0, 10000}, "N",
        "Views of each scene on which sweeps are drawn");

    in(kCompare, "--f-margin").number(
        kField<&E::compare, &C::answer, &summary::AnswerRule::f_margin>, "answer.f_margin",
        {0, 1}, "F",
        "The answer is the cheapest method whose F is at most this far below the best");
    in(kCompare, "--budget-ms").number(
        kField<&E::compare, &C::answer, &summary::AnswerRule::budget_ms>, "answer.budget_ms",
        {0, 1e6}, "MS",
        "The answer is of the methods whose frame takes at most so long (0: any)");

    in(kCompare, "--motion").flag(
        kField<&E::compare, &C::study_motion>, "study.motion",
        "Also draw sequences in which the camera moves slowly: flicker, pops, lives of false "
        "lines; motion.csv and plots, about a minute");
    // clang-format on
    return table;
}

}  // namespace

std::size_t OptionTable::row(std::string_view name) const {
    const auto& params = rows.params();
    const core::Param* found = core::find_named(params, name);
    if (found == nullptr) throw std::out_of_range(std::string(name));
    return static_cast<std::size_t>(found - params.data());
}

std::vector<std::string> OptionTable::texts(const Experiment& experiment, std::size_t row) const {
    std::vector<std::string> texts = rows.get(experiment, row);
    if (param(row).is_number() && !texts.empty()) {
        const double value = std::stod(texts.front());
        if (value < param(row).min || value > param(row).max) return {};
    }
    return texts;
}

OptionPlace place_of(const core::Param& param) {
    const auto dot = param.name.find('.');
    if (dot == std::string::npos) return {"", param.name};
    return {param.name.substr(0, dot), param.name.substr(dot + 1)};
}

const OptionTable& option_table() {
    static const OptionTable table = make_table();
    return table;
}

void set_option(Experiment& experiment,
                std::string_view option,
                const std::vector<core::GivenText>& given) {
    const std::size_t row = option_table().row(option);
    if (!option_table().has_kind(row, experiment.kind)) {
        throw core::Error(
            given.front().where,
            fmt::format(
                "{} is of kind {}, which has none", experiment.where, name(experiment.kind)),
            "another kind of experiment, or this one without it");
    }
    option_table().rows.set(experiment, row, given, "it");
}

}  // namespace ink::experiment
