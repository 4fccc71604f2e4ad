#include "summary/unscored.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "harness/tables/table_of.h"
#include "harness/view_images.h"
#include "summary/summary.h"

namespace ink::summary {
namespace {

std::string remedy_of(const harness::Row& row) {
    if (row.status.starts_with("too_large")) {
        return "a smaller --size, fewer triangles, or a larger --crease, so that fewer edges are "
               "lines";
    }
    if (row.status.starts_with("reference_disagreement")) {
        return fmt::format(
            "inkbench truth {} --view {} --crosscheck --disagreement where.png shows "
            "the places; --no-crosscheck scores the view anyway",
            row.scene,
            row.view);
    }
    if (row.status.starts_with("empty")) {
        return fmt::format(
            "a view that shows lines of it away from the frame: inkbench explain {} "
            "prints its box and cameras; or a larger --size",
            row.scene);
    }
    if (row.status.starts_with("crowded")) {
        return "a larger --size, or a view in which lines lie farther apart; f_2px_with_crowded of "
               "its rows counts the crowded pixels too";
    }
    if (row.clock == "own") {
        return fmt::format("inkbench entrant-test tries a program; a folder has {}/{}.png",
                           harness::file_name(row.scene),
                           harness::file_name(row.view));
    }
    return fmt::format("inkbench draw {} --view {} --method {} -o alone.png draws it alone",
                       row.scene,
                       row.view,
                       row.method);
}

const harness::TableOf<Unscored>& table() {
    static const auto kTable = [] {
        harness::TableOf<Unscored> table(
            "unscored.csv", "A view without any score, or a method without one on a view.");
        table.add({"scene", "", "the scene"}, &Unscored::scene);
        table.add({"view", "", "the view"}, &Unscored::view);
        table.add({"method", "", "the method; empty where the whole view has no score"},
                  &Unscored::method);
        table.add({"reason", "", "status of its rows"}, &Unscored::reason);
        table.add({"remedy", "", "what may help"}, &Unscored::remedy);
        return table;
    }();
    return kTable;
}

}  // namespace

std::vector<Unscored> unscored_cells(const std::vector<harness::Row>& rows) {
    std::map<harness::Place, bool> has_score;  // of any method
    for (const harness::Row& row : rows) {
        if (harness::is_baseline(row.method)) continue;
        bool& has = has_score[harness::place_of(row)];
        has = has || row.is_ok();
    }
    std::vector<Unscored> cells;
    std::map<harness::Place, bool> is_named;
    for (const harness::Row& row : rows) {
        if (row.is_ok() || harness::is_baseline(row.method)) continue;
        const harness::Place place = harness::place_of(row);
        const bool is_whole_view = !has_score.at(place);
        if (is_whole_view && is_named[place]) continue;
        is_named[place] = true;
        cells.push_back(
            {row.scene, row.view, is_whole_view ? "" : row.method, row.status, remedy_of(row)});
    }
    return cells;
}

bool is_failure(const Unscored& cell) {
    return !cell.reason.starts_with("crowded");
}

bool is_all_unscored(const std::vector<harness::Row>& rows) {
    const auto is_of_method = [](const harness::Row& row) {
        return !harness::is_baseline(row.method);
    };
    return std::any_of(rows.begin(), rows.end(), is_of_method) &&
           std::none_of(rows.begin(), rows.end(), [&](const harness::Row& row) {
               return is_of_method(row) && row.is_ok();
           });
}

const harness::TableInfo& unscored_table() {
    return table().info();
}

std::string unscored_csv(const std::vector<Unscored>& cells) {
    return table().file(cells);
}

std::string unscored_text(const std::vector<Unscored>& cells) {
    std::string text;
    for (const Unscored& cell : cells) {
        text += fmt::format("no score: {} {}{}: {}\n    try: {}\n",
                            cell.scene,
                            cell.view,
                            cell.method.empty() ? "" : " " + cell.method,
                            cell.reason,
                            cell.remedy);
    }
    return text;
}

}  // namespace ink::summary
