#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/param.h"
#include "harness/suite/suite.h"
#include "methods/antialias.h"
#include "methods/method_configs.h"
#include "score/coverage.h"
#include "score/intersections.h"
#include "studies/motion_study.h"
#include "summary/answer.h"

namespace ink::experiment {

/// What is computed: `compare` draws methods on views, and may study motion beside; `stress` draws
/// along axes of difficulty; `animation` on sequences.
enum class ExperimentKind { compare, stress, animation };

/// "compare", "stress", "animation": as files and run.toml have it.
[[nodiscard]] std::string_view name(ExperimentKind kind);

/// Of which views a comparison keeps images: none, the first of each scene, or all.
enum class KeptImages { none, first, all };

/// Every combination of some settings of one method.
struct SettingGrid {
    std::string method;
    std::vector<std::pair<std::string, std::vector<std::string>>> axes;  ///< key, its values
};

/// What a comparison alone is asked.
struct CompareRequest {
    std::vector<std::string> presets = {};   ///< preset files whose methods take part too
    std::vector<std::string> entrants = {};  ///< NAME=PATH, methods from outside that take part too
    double entrant_s = 60;                   ///< that a program from outside may take for a view
    std::vector<method::MethodConfig> own_methods = {};  ///< made by code, beside or instead
    int views = 0;                                       ///< the first of each scene; 0: all
    std::vector<SettingGrid> grids = {};                 ///< sweep.csv
    int own_sweep_views = 0;                  ///< sweep.csv: each method's own, on the first views
    std::vector<std::string> skips_off = {};  ///< optimisations that methods may not use
    scene::CreaseSource creases = scene::CreaseSource::angle;  ///< of the truth
    KeptImages images = KeptImages::first;
    bool study_motion = false;  ///< the sequences of an animation, too
    bool full_scores = true;    ///< curves, tolerance sweep, bins, causes; else F at 2 px alone
    summary::AnswerRule answer = {};  ///< how it is chosen; no row depends on it
};

/// What the sweep of difficulties alone is asked.
struct StressRequest {
    std::vector<std::string> axes = {};  ///< none: all
    int points = 0;                      ///< values of an axis, at most; 0: all
    scene::ProjectionKind projection = scene::ProjectionKind::perspective;  ///< of all cameras
};

/// What sequences alone are asked.
struct AnimationRequest {
    int frames = 48;                      ///< of a sequence
    double step_px = studies::kStep_px;   ///< by which the image moves a frame
    std::vector<std::string> paths = {};  ///< before any scene; none: the study's own sequences
};

struct ImageSize {
    int width_px = 0;
    int height_px = 0;

    bool operator==(const ImageSize&) const = default;
};

/// An experiment, from its file or from the options of a command; all names are checked. A part of
/// it is of each kind alone, the rest of all.
struct Experiment {
    std::string where;    ///< the file or the command that asks, for messages
    std::string command;  ///< as the user typed it, less what says where results go; may be ""
    std::string name;
    ExperimentKind kind = ExperimentKind::compare;
    std::uint64_t seed = 0;
    std::vector<std::string> methods;              ///< registered names, each once; none: all
    std::vector<std::string> settings;             ///< key=value or method.key=value
    std::vector<ImageSize> sizes = {{1280, 720}};  ///< one at least
    std::vector<int> threads = {1};                ///< of the methods
    std::vector<std::string> scenes;    ///< built-in scenes or model files; not of stress
    harness::ViewRequest view_request;  ///< from where scenes are seen; its size is not read
    std::string model_list = {};        ///< the file that `view_request.listed` is of, or ""
    double crease_deg = 40;             ///< of the truth, and of methods that follow it
    double weld_epsilon = 0;            ///< of the truth, share of each part's diagonal
    score::Intersections intersections = score::Intersections::above_crease;  ///< that count
    bool crosscheck = true;  ///< hold truths against the cross-check
    bool times = true;       ///< false: columns of times stay empty
    int repetitions = 60;    ///< timed drawings, at most
    double budget_ms = 60;   ///< of drawing, after which repetitions end
    /// How many samples a pixel the methods draw, each choice a method of its own.
    std::vector<methods::Antialias> antialias = {methods::Antialias::none};
    bool coverage = false;  ///< score grey lines too
    /// Of grey lines: of the true ones, and of those that methods draw with several samples.
    double line_width_px = score::kLineWidth_px;
    CompareRequest compare = {};
    StressRequest stress = {};
    AnimationRequest animation = {};
};

/// The width of the true lines, if grey lines are scored.
[[nodiscard]] std::optional<double> scored_width_px(const Experiment& experiment);

/// From where its scenes are seen, in images of this size.
[[nodiscard]] harness::ViewRequest views_of(const Experiment& experiment, const ImageSize& size);

/// The same in images of the first of its sizes.
[[nodiscard]] harness::ViewRequest views_of(const Experiment& experiment);

/// Reads an experiment. Throws core::Error (where = file and line) that names key, value and what
/// is accepted: for TOML that cannot be read, unknown keys, wrong types, unknown names, values out
/// of range, and a grid without cells.
[[nodiscard]] Experiment read_experiment(const std::filesystem::path& file);

/// The same from text; `file` is for messages and for models beside it. What run.toml of a run
/// records as asked is asked again.
[[nodiscard]] Experiment parse_experiment(const std::string& text,
                                          const std::filesystem::path& file);

/// Lets a comparison score grey lines, too, where a method that draws ink is named; not where all
/// methods take part.
void cover_named_ink(Experiment& experiment);

/// The methods that take part, presets and entrants last, with the settings that each knows, and
/// the truth's crease angle where they follow it (methods::follow_crease). Throws core::Error for a
/// preset that cannot be read.
[[nodiscard]] std::vector<method::MethodConfig> configs_of(const Experiment& experiment);

/// Every combination of a grid as a configuration, on top of what `config` has; the last key turns
/// fastest.
[[nodiscard]] std::vector<method::MethodConfig> grid_configs(const method::MethodConfig& config,
                                                             const SettingGrid& grid);

/// The scenes that "catalogue", "train" and "heldout" stand for; any other name is its own.
[[nodiscard]] std::vector<std::string> scenes_called(const std::string& name);

/// "640x360"; throws core::Error (where = `where`) for text that is no size, or one that cannot be
/// drawn.
[[nodiscard]] ImageSize parse_image_size(const std::string& text, const std::string& where);

/// What an experiment asks for as a TOML document: scenes and views, methods with every parameter,
/// grids, how things are measured. Keys are sorted, so that equal experiments give equal texts. It
/// can be asked again (parse_experiment), but for methods that are made by code.
[[nodiscard]] std::string asked_text(const Experiment& experiment);

}  // namespace ink::experiment
