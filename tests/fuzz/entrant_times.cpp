// Any text in the place of times.csv is read, or an Error.

#include "core/tables/csv_table.h"
#include "entrants/image_folder.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/scratch_file.h"

namespace ink::fuzz {
namespace {

void check_table(const std::string& text) {
    const auto table = unless_refused([&] { return core::split_csv(text, "times.csv"); });
    if (!table) return;
    expect(table->lines.size() == table->records.size(), "each record has a line");
    for (std::size_t i = 0; i < table->records.size(); ++i) {
        expect(table->records[i].size() == table->columns.size(), "each record has every column");
        expect(i == 0 || table->lines[i] > table->lines[i - 1], "lines go on");
    }
}

}  // namespace

void check_entrant_times(Bytes bytes) {
    check_table({bytes.begin(), bytes.end()});
    const auto path = scratch_file("times.csv", bytes);
    (void)unless_refused([&] { return entrants::image_folder_source(path.parent_path()); });
}

}  // namespace ink::fuzz
