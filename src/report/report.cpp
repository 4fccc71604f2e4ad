#include "report/report.h"

#include "core/whole_file.h"
#include "report/page.h"

namespace ink::report {

void write_report(const ReportData& data, const std::filesystem::path& path) {
    core::write_whole_file(path, report_page(data));
}

}  // namespace ink::report
