#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands/commands.h"
#include "cli/json_values.h"
#include "cli/options/command_rows.h"
#include "cli/options/experiment_options.h"
#include "cli/options/method_options.h"
#include "cli/options/scene_options.h"
#include "cli/place.h"
#include "experiment/options/view_rows.h"
#include "inspect/explain.h"
#include "methods/method_configs.h"

namespace ink::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ExplainArgs {
    SceneOptions scene;
    std::string view;
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

Json json_of(const inspect::Explanation& explanation) {
    Json json = {{"scene", explanation.scene}, {"statistics", json_of(explanation.facts)}};
    json["plan"] = list_of<Json>(explanation.plan, [](const method::PlanLine& line) -> Json {
        return {{"what", line.what}, {"why", line.why}};
    });
    return json;
}

void run_explain(const ExplainArgs& args) {
    const experiment::Experiment asked = args.options.read();
    auto configs = methods::make_configs("auto", args.settings);
    methods::follow_crease(asked.crease_deg, configs);
    const harness::ViewRequest request = views_of(asked);
    const std::string scene = one_scene(args.scene, "explain");
    const harness::SceneViews scene_views = args.view.empty()
                                                ? harness::load_scenes({scene}, request).front()
                                                : harness::load_one_view(scene, args.view, request);
    const inspect::Explanation explanation =
        inspect::explain(scene_views.scene, configs.front(), asked.crease_deg);
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
                                       "Explain a scene: where it is, what it has, and which "
                                       "method auto chooses for it and why");
    add_one_scene_options(*command, args->scene);
    add_set_option(*command, args->settings, "A parameter of auto: key=value");
    CommandRows rows(*command);
    rows.text("--view", args->view, "NAME", "Name of a view (default: all)");
    args->options.add_to(*command, experiment::view_rows());
    args->options.add_to(
        *command, {"measure.crease_deg"}, "Crease angle of the scene statistics, and of auto");
    rows.flag("--json",
              args->json,
              "Print JSON instead of text, with facts that are 0 and lengths of edges");
    command->footer(
        "Example: inkbench explain torus --crease 60\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] { run_explain(*args); });
}

}  // namespace ink::cli
