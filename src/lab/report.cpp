#include "lab/report.h"

#include "lab/page.h"
#include "lab/whole_file.h"

namespace ink::lab {

void write_report(const ReportData& data, const std::filesystem::path& path) {
    write_whole_file(path, report_page(data));
}

}  // namespace ink::lab
