#include "lab/report.h"

#include "core/whole_file.h"
#include "lab/page.h"

namespace ink::lab {

void write_report(const ReportData& data, const std::filesystem::path& path) {
    core::write_whole_file(path, report_page(data));
}

}  // namespace ink::lab
