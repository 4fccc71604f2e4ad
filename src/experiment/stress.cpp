#include "experiment/stress.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/progress.h"
#include "core/whole_file.h"
#include "harness/csv.h"
#include "harness/interrupt.h"
#include "harness/out_folder.h"
#include "report/stress_chart.h"
#include "report/stress_page.h"

namespace ink::experiment {
namespace {

/// The rows of one axis, written case by case.
std::vector<studies::StressRow> run_axis(const studies::StressAxis& axis,
                                         const StressOptions& options,
                                         harness::CsvFile& file,
                                         const std::function<void(double)>& before) {
    std::vector<studies::StressRow> rows;
    for (const double value : studies::stress_values(axis, options.points)) {
        before(value);
        for (const studies::StressCase& stress : axis.cases(value, options.size)) {
            if (harness::is_interrupted()) return rows;
            std::vector<studies::StressRow> more =
                studies::stress_rows(stress, options.entrants, options.measure, options.trace);
            const std::size_t first = rows.size();
            for (studies::StressRow& row : more) {
                row.row.seed = options.seed;
                rows.push_back(std::move(row));
            }
            studies::note_differences(rows);
            for (std::size_t i = first; i < rows.size(); ++i)
                file.write(to_csv(rows[i]));
        }
    }
    return rows;
}

}  // namespace

StressResult run_stress(const StressOptions& options) {
    const harness::InterruptGuard guard;
    harness::make_out_folder(options.out / "figures");
    harness::CsvFile file(options.out / "stress.csv", studies::stress_columns());
    int total = 0;
    for (const studies::StressAxis* axis : options.axes)
        total += static_cast<int>(studies::stress_values(*axis, options.points).size());
    StressResult result;
    {
        core::Progress progress("stress", total);
        int done = 0;
        for (const studies::StressAxis* axis : options.axes) {
            if (harness::is_interrupted()) break;
            std::vector<studies::StressRow> rows =
                run_axis(*axis, options, file, [&](double value) {
                    progress.report(done++, axis->name + " " + format_stress_value(*axis, value));
                });
            std::move(rows.begin(), rows.end(), std::back_inserter(result.rows));
        }
    }
    file.finish();
    result.points = summarise_stress(result.rows, options.seed);
    result.counts = total_counts(result.rows);
    result.is_interrupted = harness::is_interrupted();
    core::write_whole_file(options.out / "stress_summary.csv", stress_summary_csv(result.points));
    for (const studies::StressAxis* axis : options.axes) {
        const std::vector<StressCurve> curves = stress_curves(result.points, axis->name);
        if (curves.empty()) continue;
        core::write_whole_file(options.out / "figures" / fmt::format("stress_{}.svg", axis->name),
                               report::stress_chart(*axis, curves).file(axis->title));
    }
    result.page = options.out / "stress.html";
    core::write_whole_file(result.page, report::stress_page(options, result));
    return result;
}

}  // namespace ink::experiment
