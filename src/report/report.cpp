#include "report/report.h"

#include <utility>

#include "core/whole_file.h"
#include "report/page.h"

namespace ink::report {
namespace {

/// Leaves the rows of one size and one number of threads: no one time of a method means anything
/// over several.
void keep_one_place(std::vector<harness::Row>& rows, const harness::Row& first) {
    std::erase_if(rows, [&](const harness::Row& row) {
        return row.width != first.width || row.height != first.height ||
               row.threads != first.threads;
    });
}

}  // namespace

ReportData report_data(experiment::RunData run) {
    experiment::RunTables& tables = run.tables;
    if (!run.record.one_place && !tables.rows.empty()) {
        const harness::Row first = tables.rows.front();
        keep_one_place(tables.rows, first);
        keep_one_place(tables.sweep, first);
    }
    return {run.record.command,
            std::move(tables.rows),
            std::move(run.views),
            run.record.work_s,
            std::move(tables.curves),
            std::move(tables.sweep),
            run.cost_fit,
            std::move(tables.scaling),
            std::move(tables.skip_study),
            std::move(tables.motion),
            std::move(tables.rolls),
            std::move(tables.cancellation),
            std::move(run.record.missing_blocks),
            run.record.blocks,
            std::move(run.record.faults)};
}

void write_report(const ReportData& data, const std::filesystem::path& path) {
    core::write_whole_file(path, report_page(data));
}

}  // namespace ink::report
