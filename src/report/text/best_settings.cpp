#include "report/text/best_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiment/summary/sweep_summary.h"
#include "report/text/text_table.h"
#include "report/text/verdict.h"

namespace ink::report {
namespace {

const experiment::SettingSummary& best_of(const experiment::MethodSweep& sweep) {
    return *std::min_element(
        sweep.settings.begin(),
        sweep.settings.end(),
        [](const experiment::SettingSummary& a, const experiment::SettingSummary& b) {
            return a.error != b.error ? a.error < b.error : a.draw_ms < b.draw_ms;
        });
}

const experiment::SettingSummary* own_of(const experiment::MethodSweep& sweep) {
    const auto found = std::find_if(
        sweep.settings.begin(), sweep.settings.end(), [](const experiment::SettingSummary& s) {
            return s.is_default();
        });
    return found == sweep.settings.end() ? nullptr : &*found;
}

}  // namespace

std::string best_settings_table(const std::vector<harness::Row>& rows,
                                const std::vector<harness::Row>& sweep) {
    const std::vector<experiment::MethodSweep> methods = experiment::summarise_sweep(rows, sweep);
    if (methods.empty()) return "";
    core::Cells cells = {{"method", "settings", "F own", "F best", "ms", "best setting"}};
    for (const experiment::MethodSweep& method : methods) {
        const experiment::SettingSummary& best = best_of(method);
        const experiment::SettingSummary* own = own_of(method);
        cells.push_back({method.method,
                         fmt::format("{}", method.settings.size()),
                         own == nullptr ? "-" : core::format_share(1 - own->error),
                         core::format_share(1 - best.error),
                         format_ms(best.draw_ms),
                         best.is_default() ? "its own" : best.difference});
    }
    std::set<harness::Place> places;
    std::set<std::string> scenes;
    for (const harness::Row& row : sweep) {
        places.insert(harness::place_of(row));
        scenes.insert(row.scene);
    }
    return fmt::format("Best settings over {} views of {} scenes:\n{}",
                       places.size(),
                       scenes.size(),
                       core::aligned(cells));
}

}  // namespace ink::report
