#include "report/text/text_table.h"

#include "report/text/verdict.h"

namespace ink::report {

TextColumn share_column(std::string heading,
                        std::optional<double> experiment::MethodSummary::*field) {
    return {std::move(heading),
            [field](const experiment::MethodSummary& s) { return core::format_share(s.*field); }};
}

TextColumn name_column() {
    return {"method", [](const experiment::MethodSummary& s) {
                return s.method + (s.is_baseline ? " *" : s.has_own_clock ? " +" : "");
            }};
}

core::Cells cells_of(const std::vector<TextColumn>& columns,
                     const std::vector<experiment::MethodSummary>& summaries) {
    core::Cells cells(1);
    for (const TextColumn& column : columns)
        cells[0].push_back(column.heading);
    for (const experiment::MethodSummary& s : summaries) {
        std::vector<std::string>& line = cells.emplace_back();
        for (const TextColumn& column : columns)
            line.push_back(column.text(s));
    }
    return cells;
}

}  // namespace ink::report
