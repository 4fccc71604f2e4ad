#include "bake/bake.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/options/command_rows.h"
#include "cli/options/options.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/scratch_folder.h"
#include "core/whole_file.h"
#include "entrants/view_files.h"
#include "harness/suite/suite.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array kMethods{methods::BakedMethod::surface8, methods::BakedMethod::label8};

constexpr const char* kLookup = "surface_lookup";  ///< whose tables go into a file of their own

constexpr const char* kAllAnimations = "all";

struct BakeArgs {
    std::string model;
    std::string out;
    std::string codes;
    std::string channel;
    bake::BakeOptions options;
    std::optional<double> time_s;
    std::string animation;
};

bake::BakeOptions options_of(const BakeArgs& args) {
    bake::BakeOptions options = args.options;
    if (!args.codes.empty()) {
        options.codes = args.codes == bake::name(kMethods[0]) ? kMethods[0] : kMethods[1];
    } else if (!options.edges || !args.channel.empty()) {
        options.codes = kMethods[0];
    }
    if (!args.channel.empty()) options.texcoord = args.channel == "texcoord1" ? 1 : 2;
    return options;
}

std::string in_units(std::uintmax_t bytes) {
    return bytes < 10'000'000 ? fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3)
                              : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

/// Bakes a model of another format by way of a glTF file that holds its geometry.
bake::BakedFile bake_other(import::ImportedModel model,
                           const bake::BakeOptions& options,
                           const fs::path& out) {
    const core::ScratchFolder scratch("bake");
    const fs::path file = scratch.path() / "model.glb";
    bake::add_normals(model.scene, options.crease_deg, model.texcoords);
    entrants::write_glb(model.scene, {}, file, model.base_colors, model.texcoords);
    bake::BakedFile baked = bake::bake(file, import::import_model(file), options, out);
    const bool has_texcoords =
        std::ranges::any_of(model.texcoords, [](auto& of_mesh) { return !of_mesh.empty(); });
    baked.lines.insert(baked.lines.begin(),
                       fmt::format("it became glTF: geometry, normals, {}names and base colours",
                                   has_texcoords ? "texture coordinates, " : ""));
    return baked;
}

/// The scene with the animations for which codes are to be repaired. Those of one moment are not.
std::vector<scene::Scene> motions_of(const BakeArgs& args, const import::ImportedModel& model) {
    if (args.animation.empty() || args.time_s || !bake::is_gltf(model)) return {};
    std::vector<scene::Scene> motions;
    const auto add = [&](scene::Scene motion) {
        if (motion.animation) motions.push_back(std::move(motion));
    };
    if (args.animation != kAllAnimations) {
        add(model.scene);
        return motions;
    }
    for (std::size_t i = 0; i < model.scene.file.animation_names.size(); ++i)
        add(import::import_scene(args.model, {.animation = std::to_string(i)}));
    return motions;
}

/// Puts the model where it is at a time, or at rest.
void pose(import::ImportedModel& model, std::optional<double> time_s) {
    harness::ViewRequest request;
    request.time_s = time_s;
    model.scene = harness::make_scene_views(std::move(model.scene), request).scene;
}

void run_lookup(const BakeArgs& args) {
    check_output_path(args.out, {".lookup"});
    if (args.options.edges || args.options.repair || !args.channel.empty())
        throw core::Error("--codes",
                          "tables of surface_lookup go into a file of their own",
                          "neither --edges nor --channel nor --repair");
    const core::InterruptGuard guard("nothing is written");
    import::ImportedModel model = import::import_model(args.model, {.animation = args.animation});
    if (!bake::is_gltf(model))
        throw core::Error(args.model, "is no glTF file", ".gltf, .glb; bake makes one of others");
    pose(model, args.time_s);
    const std::string bytes = bake::lookup_file(model, args.options.crease_deg);
    core::write_whole_file(args.out, bytes);
    fmt::print("{}: tables of {} triangles, {}\n",
               args.out,
               scene::triangle_count(model.scene),
               in_units(bytes.size()));
}

void run_bake(const BakeArgs& args) {
    if (args.codes == kLookup) return run_lookup(args);
    bake::BakeOptions options = options_of(args);
    check_output_path(args.out, {".glb", ".gltf"});
    const core::InterruptGuard guard("nothing is written");
    const bool has_all = args.animation == kAllAnimations;
    import::ImportedModel model = import::import_model(
        args.model, {.animation = has_all ? "" : args.animation, .has_texcoords = true});
    const bool has_steps = options.codes == methods::BakedMethod::surface8;
    if (options.repair && !has_steps)
        throw core::Error("--repair", "these are no codes that can be repaired", "surface8");
    if (has_steps) options.motions = motions_of(args, model);
    options.repair |= !options.motions.empty();
    options.animation = args.animation;
    if (has_all && options.motions.empty())
        throw core::Error("--animation",
                          "there are no poses to repair codes of surface8 for",
                          "a glTF file that moves, without --time");
    if (model.scene.animation)
        options.pose = args.time_s ? fmt::format("at {:g} s", *args.time_s) : "at rest";
    pose(model, args.time_s);
    const bake::BakedFile baked = bake::is_gltf(model)
                                      ? bake::bake(args.model, model, options, args.out)
                                      : bake_other(std::move(model), options, args.out);
    const std::uintmax_t bytes_before = fs::file_size(args.model);
    core::write_whole_file(args.out, baked.bytes);
    for (const std::string& line : baked.lines)
        fmt::print("{}\n", line);
    fmt::print(
        "{}: {}, {} before\n", args.out, in_units(baked.bytes.size()), in_units(bytes_before));
}

}  // namespace

void add_bake_command(CLI::App& app) {
    auto args = std::make_shared<BakeArgs>();
    auto* command = app.add_subcommand(
        "bake", "Put a method's codes, or the edges to draw, into a model's own glTF file");
    CommandRows rows(*command);
    // clang-format off
    rows.text("model", args->model, "MODEL", "Model file; formats other than glTF become glTF")
        ->required();
    rows.text("-o,--out", args->out, "FILE.glb|FILE.gltf|FILE.lookup",
              "File to write")->required();
    rows.choice("--codes", args->codes, {bake::name(kMethods[0]), bake::name(kMethods[1]), kLookup},
                "Codes of this method, a byte for each triangle, as the attribute _INK "
                "(default: surface8, without --edges); of surface_lookup what its shader and that of "
                "chords read, as FILE.lookup, to stand beside a glTF file that stays as it is");
    rows.choice("--channel", args->channel, {"texcoord1", "texcoord2"},
                "Codes in a texture coordinate too, for engines that drop _INK: u is code/255");
    rows.flag("--repair", args->options.repair,
              "Codes of surface8 raised and lowered until random views of the model show few wrong "
              "lines: seconds");
    rows.flag("--edges", args->options.edges,
              "Hard edges and silhouettes as EXT_mesh_primitive_edge_visibility");
    rows.number("--crease-deg", args->options.crease_deg, {0, 180}, "DEG",
                "Angle between faces at which an edge is a line");
    rows.number("--time", args->time_s, kAnyNumber, "SECONDS",
                "Moment of a model that moves, of whose pose codes and edges are (default: its "
                "rest pose)");
    rows.text("--animation", args->animation, "NAME|N|all",
              "Which animation moves it (default: the first; inkbench explain lists them); without "
              "--time, codes of surface8 in a glTF file are repaired for all its poses");
    // clang-format on
    command->footer(
        "The first and the last vertex of each triangle have its code, so vertices may be added. "
        "All else in the file stays.\n"
        "Example: inkbench bake robot.glb -o robot.ink.glb --edges --codes surface8\n"
        "Exit codes: 0 done, 2 bad input, 130 interrupted.");
    command->callback([args] { run_bake(*args); });
}

}  // namespace ink::cli
