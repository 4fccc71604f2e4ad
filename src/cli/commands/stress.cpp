#include <memory>

#include "cli/commands/commands.h"
#include "cli/options/experiment_options.h"
#include "cli/options/options.h"
#include "cli/options/run_options.h"

namespace ink::cli {

void add_stress_command(CLI::App& app) {
    auto args = std::make_shared<MeasureArgs>("stress", "");
    args->options.usual().kind = experiment::ExperimentKind::stress;
    args->options.usual().sizes = {{480, 270}};
    auto* command =
        app.add_subcommand("stress", "Sweep one difficulty at a time: error curves per method");
    ExperimentOptions& options = args->options;
    options.add_to(*command, {"grid.axes"});
    add_method_options(*command, args->methods);
    add_set_option(*command, args->settings);
    options.add_to(*command, {"grid.points", "grid.projection"});
    options.add_to(*command, {"grid.sizes"}, "Size of an image");
    options.add_to(*command, {"grid.threads"}, "Threads of a method");
    options.add_to(*command, {"seed"}, "Of the intervals");
    options.add_to(*command, {"measure.intersections", "grid.antialias"});
    options.add_to(*command, {"measure.coverage", "measure.line_width_px"});
    add_cache_options(*command, args->cache);
    add_run_folder_options(*command, args->folder);
    command->footer(
        std::string("Writes rows.csv, stress.csv, axes.csv, axis_summary.csv and report.html.\n"
                    "Example: inkbench stress --axes grazing,origin --methods mote4,decaudin\n"
                    "Exit codes: 0 done; 1 a number was not finite, a code overflowed, a cell has "
                    "no result or images differ that must not; 2 bad input; ") +
        kUnscoredCode + "; 130 interrupted.");
    command->callback(
        [args, command] { run_to_end(*command, args->read(), args->folder, args->cache); });
}

}  // namespace ink::cli
