#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands/commands.h"
#include "cli/json_values.h"
#include "cli/options/command_rows.h"
#include "core/error.h"
#include "experiment/diff/run_diff.h"
#include "report/text/diff_text.h"

namespace ink::cli {
namespace {

constexpr int kWorse = 1;

struct DiffArgs {
    std::string before;
    std::string after;
    bool is_json = false;
    bool fail_if_worse = false;
};

nlohmann::json cells_json(const std::vector<const harness::Row*>& rows) {
    return list_of(rows, [](const harness::Row* row) -> nlohmann::json {
        return {{"method", row->method},
                {"scene", row->scene},
                {"view", row->view},
                {"width", row->width},
                {"height", row->height},
                {"params", row->params}};
    });
}

/// "f_before", "f_after", and as `prefix` has it "difference", "lo" and "hi".
void add_f(const experiment::FDiff& f,
           const std::string& name,
           const std::string& prefix,
           nlohmann::json& json) {
    json[name + "_before"] = or_null(f.before);
    json[name + "_after"] = or_null(f.after);
    json[prefix + "difference"] = or_null(f.difference);
    json[prefix + "lo"] = f.range ? nlohmann::json(f.range->low) : nlohmann::json(nullptr);
    json[prefix + "hi"] = f.range ? nlohmann::json(f.range->high) : nlohmann::json(nullptr);
}

nlohmann::json diff_json(const experiment::RunDiff& diff) {
    const auto method_json = [](const experiment::MethodDiff& method) {
        nlohmann::json json{{"method", method.method},
                            {"settings", method.settings},
                            {"cells", method.cells},
                            {"changed_images", method.changed_images},
                            {"changed_scores", method.changed_scores},
                            {"lost", method.lost},
                            {"won", method.won},
                            {"time_ratio", or_null(method.time_ratio)},
                            {"worse", method.is_worse()}};
        add_f(method.f, "f", "", json);
        if (method.soft_f.before) add_f(method.soft_f, "soft_f", "soft_", json);
        return json;
    };
    const auto change_json = [](const experiment::AskedChange& change) -> nlohmann::json {
        return {{"key", change.key}, {"before", change.a}, {"after", change.b}};
    };
    return {{"same", diff.is_same()},
            {"worse", diff.is_worse()},
            {"asked", list_of(diff.asked, change_json)},
            {"new", cells_json(diff.cells.added)},
            {"gone", cells_json(diff.cells.gone)},
            {"changed_truths", diff.changed_truths},
            {"times_obstacle", diff.times_obstacle},
            {"methods", list_of(diff.methods, method_json)}};
}

/// Throws core::Error unless the run has rows to pair.
void check_rows(const experiment::RunData& run) {
    if (!run.tables.rows.empty()) return;
    throw core::Error(
        run.folder.string(),
        "there are no rows of a comparison in it (it is a run of kind '" + run.record.kind + "')",
        "a run of inkbench compare or inkbench run");
}

}  // namespace

void add_diff_command(CLI::App& app) {
    auto args = std::make_shared<DiffArgs>();
    auto* command = app.add_subcommand("diff", "Say what one run changed against another");
    CommandRows rows(*command);
    // clang-format off
    rows.text("before", args->before, "DIR", "Folder of a run")->required();
    rows.text("after", args->after, "DIR", "Folder of the run to compare with it")->required();
    rows.flag("--fail-if-worse", args->fail_if_worse,
              "Exit with 1 if a method's F or soft F fell (its 95 % interval below 0), or a scored cell has "
              "no score or is gone");
    rows.flag("--json", args->is_json, "Print the result as JSON");
    // clang-format on
    command->footer(
        "Cells are paired by method, scene, view, size and parameters. `inkbench report BEFORE "
        "AFTER\n-o FILE.html` shows the same as a page, with images.\n"
        "Example: inkbench diff inkbench-out/monday inkbench-out/tuesday --fail-if-worse\n"
        "Exit codes: 0 done, 1 worse (with --fail-if-worse), 2 bad input.");
    command->callback([args] {
        const experiment::RunData before = experiment::read_run(args->before);
        const experiment::RunData after = experiment::read_run(args->after);
        check_rows(before);
        check_rows(after);
        const experiment::RunDiff diff =
            experiment::diff_runs(before, after, before.tables.rows.front().seed);
        if (args->is_json)
            fmt::print("{}\n", diff_json(diff).dump(2));
        else
            fmt::print("{}", report::diff_text(diff));
        std::fflush(stdout);
        if (args->fail_if_worse && diff.is_worse()) throw CLI::RuntimeError(kWorse);
    });
}

}  // namespace ink::cli
