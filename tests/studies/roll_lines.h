#pragma once

#include <vector>

#include "harness/tables/csv_table.h"
#include "studies/roll_axis.h"

namespace ink::studies {

/// A line of creases.csv.
struct RollSampleLine : RollSample {
    std::int64_t cell = 0;
    int crease = 0;
};

inline std::vector<RollSampleLine> creases_in(const Lines& lines) {
    const harness::CsvTable table = harness::split_csv(
        harness::heading(creases_table()) + lines.at("creases.csv"), "creases.csv");
    std::vector<RollSampleLine> all;
    for (std::size_t i = 0; i < table.records.size(); ++i) {
        const auto read = [&](std::size_t column, auto& value) {
            const harness::CsvField field(table, i, column);
            if (!field.is_empty()) field.read(value);
        };
        RollSampleLine& line = all.emplace_back();
        read(0, line.cell);
        read(1, line.crease);
        read(2, line.length_px);
        read(3, line.covered_px);
        read(4, line.step);
        read(5, line.is_blind);
    }
    return all;
}

}  // namespace ink::studies
