#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands/commands.h"
#include "cli/json_values.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/place.h"
#include "experiment/options/option_table.h"
#include "inspect/explain.h"
#include "methods/method_configs.h"

namespace ink::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ExplainArgs {
    SceneOptions scene;
    std::string view;
    std::vector<std::string> methods{"auto"};
    std::vector<std::string> settings;
    ExperimentOptions options;
    bool json = false;
};

Json json_of(const std::vector<inspect::Fact>& facts) {
    Json json = Json::object();
    for (const inspect::Fact& fact : facts) {
        if (fact.is_flag) {
            json[fact.name] = fact.value != 0;
        } else if (fact.value == std::floor(fact.value) && fact.value < 1e15) {
            json[fact.name] = static_cast<std::int64_t>(fact.value);
        } else {
            json[fact.name] = fact.value;
        }
    }
    return json;
}

Json json_of(const raster::SkipCounts& counts) {
    Json json = Json::object();
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        const raster::SkipCount& count = counts[static_cast<std::size_t>(info.skip)];
        json[info.name] = {{"skipped", count.skipped}, {"of", count.of}};
    }
    return json;
}

Json json_of(const inspect::Explanation& explanation) {
    Json json = {{"scene", explanation.scene}, {"statistics", json_of(explanation.facts)}};
    json["methods"] = Json::object();
    for (const inspect::MethodExplanation& method : explanation.methods) {
        const auto line_json = [](const method::PlanLine& line) -> Json {
            return {{"what", line.what}, {"why", line.why}};
        };
        json["methods"][method.method] = {{"skips", json_of(method.skips)},
                                          {"plan", list_of<Json>(method.plan, line_json)}};
    }
    return json;
}

void run_explain(const ExplainArgs& args) {
    const experiment::Experiment asked = args.options.read();
    auto configs = methods::make_configs(method_list(args.methods), args.settings);
    methods::follow_crease(asked.crease_deg, configs);
    const harness::ViewRequest request = views_of(asked);
    const std::string scene = one_scene(args.scene, "explain");
    const harness::SceneViews scene_views = args.view.empty()
                                                ? harness::load_scenes({scene}, request).front()
                                                : harness::load_one_view(scene, args.view, request);
    const inspect::Explanation explanation =
        inspect::explain(scene_views, configs, asked.crease_deg);
    if (args.json) {
        Json json = json_of(explanation);
        json["place"] = place_json(scene_views);
        fmt::print("{}\n", json.dump(2));
    } else {
        fmt::print("{}\n{}", place_text(scene_views), inspect::as_text(explanation));
    }
}

}  // namespace

void add_explain_command(CLI::App& app) {
    auto args = std::make_shared<ExplainArgs>();
    auto* command = app.add_subcommand("explain",
                                       "Explain a scene: where it is, what it has, what methods "
                                       "leave undone there, and what auto chooses and why");
    add_one_scene_options(*command, args->scene);
    add_method_options(*command, args->methods, "auto");
    add_set_option(*command, args->settings);
    CommandRows rows(*command);
    rows.text("--view", args->view, "NAME", "Name of a view (default: all)");
    args->options.add_to(*command, experiment::view_rows());
    args->options.add_to(*command,
                         {"measure.crease_deg"},
                         "Crease angle of the scene statistics, and of methods that use the same");
    rows.flag("--json",
              args->json,
              "Print JSON instead of text, with facts that are 0 and lengths of edges");
    command->footer(
        "Example: inkbench explain torus --methods mote4,auto\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] { run_explain(*args); });
}

}  // namespace ink::cli
