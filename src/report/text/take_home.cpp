#include "report/text/take_home.h"

#include <fmt/format.h>

#include <algorithm>

#include "bake/bake.h"
#include "core/escape.h"
#include "core/toml_document.h"
#include "experiment/experiment.h"

namespace ink::report {
namespace {

namespace fs = std::filesystem;

/// What the run draws first: a model file if it has one, else a scene; as it was asked for.
std::string first_model(const experiment::RunData& run) {
    const toml::table asked = core::parse_toml(run.record.asked, run.folder);
    const auto names = core::texts_of(asked["grid"]["scenes"]);
    const auto file = std::ranges::find_if(
        names, [](const std::string& name) { return fs::path(name).has_extension(); });
    if (file != names.end()) return *file;
    return names.empty() ? "MODEL" : experiment::scenes_called(names.front()).front();
}

/// What of a model file is baked for the method: its codes, else the edges.
std::string baked_for(const std::string& method) {
    for (const auto codes : {methods::BakedMethod::surface8, methods::BakedMethod::label8})
        if (method.starts_with(bake::name(codes))) return "--codes " + bake::name(codes);
    return "--edges";
}

}  // namespace

TakeHome take_home(const experiment::RunData& run, const fs::path& page_folder) {
    const summary::MethodSummary* answer = run.comparison.answer().method;
    if (answer == nullptr) return {};
    TakeHome home;
    home.method = experiment::method_fact(run, answer->method, "summary");
    const std::string preset_of = experiment::method_fact(run, answer->method, "preset_of");
    const std::string name = preset_of.empty() ? answer->method : preset_of;
    const fs::path page = fs::path(INK_SOURCE_METHODS) / name / (name + ".md");
    if (fs::exists(page)) home.address = fs::relative(page, page_folder).generic_string();

    const std::string model = first_model(run);
    const fs::path file = fs::path(model).has_extension() ? model : "MODEL.glb";
    const std::string shown = core::shell_word(model);
    const std::string folder = core::shell_word(run.folder.string());
    home.commands = {{"live page", fmt::format("inkbench page {} --run {}", shown, folder)},
                     {"glTF file",
                      fmt::format("inkbench bake {} -o {} {}",
                                  core::shell_word(file.string()),
                                  core::shell_word(file.stem().string() + ".ink.glb"),
                                  baked_for(answer->method))},
                     {"advice", "inkbench advise " + shown},
                     {"figures", "inkbench figures " + folder}};
    return home;
}

}  // namespace ink::report
