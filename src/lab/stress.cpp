#include "lab/stress.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/progress.h"
#include "core/whole_file.h"
#include "lab/csv.h"
#include "lab/interrupt.h"
#include "lab/out_folder.h"
#include "lab/stress_chart.h"
#include "lab/stress_page.h"

namespace ink::lab {
namespace {

/// The rows of one axis, written case by case.
std::vector<StressRow> run_axis(const StressAxis& axis,
                                const StressOptions& options,
                                CsvFile& file,
                                const std::function<void(double)>& before) {
    std::vector<StressRow> rows;
    for (const double value : stress_values(axis, options.points)) {
        before(value);
        for (const StressCase& stress : axis.cases(value, options.size)) {
            if (is_interrupted()) return rows;
            std::vector<StressRow> more =
                stress_rows(stress, options.entrants, options.measure, options.trace);
            const std::size_t first = rows.size();
            for (StressRow& row : more) {
                row.row.seed = options.seed;
                rows.push_back(std::move(row));
            }
            note_differences(rows);
            for (std::size_t i = first; i < rows.size(); ++i)
                file.write(to_csv(rows[i]));
        }
    }
    return rows;
}

}  // namespace

StressResult run_stress(const StressOptions& options) {
    const InterruptGuard guard;
    make_out_folder(options.out / "figures");
    CsvFile file(options.out / "stress.csv", stress_columns());
    int total = 0;
    for (const StressAxis* axis : options.axes)
        total += static_cast<int>(stress_values(*axis, options.points).size());
    StressResult result;
    {
        core::Progress progress("stress", total);
        int done = 0;
        for (const StressAxis* axis : options.axes) {
            if (is_interrupted()) break;
            std::vector<StressRow> rows = run_axis(*axis, options, file, [&](double value) {
                progress.report(done++, axis->name + " " + format_stress_value(*axis, value));
            });
            std::move(rows.begin(), rows.end(), std::back_inserter(result.rows));
        }
    }
    file.finish();
    result.points = summarise_stress(result.rows, options.seed);
    result.counts = total_counts(result.rows);
    result.is_interrupted = is_interrupted();
    core::write_whole_file(options.out / "stress_summary.csv", stress_summary_csv(result.points));
    for (const StressAxis* axis : options.axes) {
        const std::vector<StressCurve> curves = stress_curves(result.points, axis->name);
        if (curves.empty()) continue;
        core::write_whole_file(options.out / "figures" / fmt::format("stress_{}.svg", axis->name),
                               stress_chart(*axis, curves).file(axis->title));
    }
    result.page = options.out / "stress.html";
    core::write_whole_file(result.page, stress_page(options, result));
    return result;
}

}  // namespace ink::lab
