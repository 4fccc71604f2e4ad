#include "studies/hardest/hardest_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/text_table.h"
#include "harness/rows/row_parts.h"

namespace ink::studies {
namespace {

using Table = core::TableOf<HardestLook>;

void add_scores(Table& table, bool has_ink) {
    using C = score::CurveCount;
    table.add({"value",
               "",
               "what the search lowers: f_2px, or f_2px - f_against, or with --coverage soft_f "
               "in its place; from 1 on a view that is no candidate"},
              &HardestLook::value);
    table.add({"status", "", "ok, or why the view is no candidate"}, &HardestLook::status);
    table.add({"f_2px", "0..1", "F of the method"}, &HardestLook::f_2px);
    table.add({"f_against", "0..1", "F of the other"}, &HardestLook::f_against);
    const auto count = table.part(&HardestLook::count);
    count.add({"k_2px", "px", "matches of the method within 2 px"}, &C::k);
    count.add({"n_pred", "px", "its drawn pixels after thinning"}, &C::n_pred);
    count.add({"n_truth", "px", "true pixels"}, &C::n_truth);
    if (!has_ink) return;
    harness::add_ink_columns(table.part(&HardestLook::soft));
    table.add({"soft_f_against", "0..1", "soft_f of the other"}, &HardestLook::soft_f_against);
}

/// One coordinate of a member of the choice.
template <auto kMember>
void add_point(Table& table, const std::string& name, const std::string& doc) {
    constexpr const char* kAxes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        table.add(
            {fmt::format("{}_{}", name, kAxes[axis]), "", doc}, [axis](auto& of) -> auto& {
                return (of.choice.*kMember)[axis];
            });
    }
}

void add_choice(Table& table) {
    const auto choice = table.part(&HardestLook::choice);
    choice.add({"time_s", "s", "moment of an animated scene; empty for its rest"},
               &ViewChoice::time_s);
    add_point<&ViewChoice::eye>(table, "eye", "as --eye has it; of usual views about");
    add_point<&ViewChoice::target>(table, "target", "as --target has it; of usual views about");
    choice.add({"fov_deg", "degrees", "as --fov has it; of usual views about"},
               &ViewChoice::fov_deg);
}

/// What is said of one method on one scene.
struct Found {
    score::CurveCount usual;
    std::optional<score::SoftScore> soft = {};  ///< of the same views

    [[nodiscard]] std::optional<double> usual_f() const {
        if (soft) return soft->f();
        return usual.n_truth > 0 ? std::optional(usual.f()) : std::nullopt;
    }
    int looked = 0;
    const HardestLook* worst = nullptr;
};

}  // namespace

Table hardest_table(bool has_ink) {
    Table table("hardest.csv",
                "A line per view that a search for the hardest looked at. Views that were kept "
                "have cells in rows.csv under `shown_as` and `view`.");
    using L = HardestLook;
    table.add({"scene", "", "its name, without a moment"}, &L::scene);
    table.add({"method", "", "for which the view is to be hard"}, &L::method);
    table.add({"against", "", "the method that it is to lose to; empty for none"}, &L::against);
    table.add({"phase", "", "usual (the scene's own views), start, global or local"}, &L::phase);
    table.add({"evaluation", "", "its number within the search, or among the usual views"},
              &L::evaluation);
    add_scores(table, has_ink);
    add_choice(table);
    table.add({"rank", "", "of a view that was kept, 1 for the worst of scene and method"},
              &L::rank);
    table.add({"shown_as", "", "the scene in rows.csv, with its moment"}, &L::shown_as);
    table.add({"view", "", "a kept view's in rows.csv; a usual view's own name"}, &L::view);
    return table;
}

std::string hardest_text(const std::vector<HardestLook>& looks) {
    std::map<std::pair<std::string, std::string>, std::size_t> place;
    std::vector<Found> found;
    const HardestLook* worst = nullptr;
    for (const HardestLook& look : looks) {
        const auto [at, is_new] = place.try_emplace({look.scene, look.method}, found.size());
        if (is_new) found.emplace_back();
        Found& of = found[at->second];
        if (look.phase == "usual") {
            if (look.f_2px) of.usual += look.count;
            if (look.soft && !of.soft) of.soft.emplace();
            if (look.soft) *of.soft += *look.soft;
            continue;
        }
        ++of.looked;
        if (look.rank != 1) continue;
        of.worst = &look;
        if (worst == nullptr || look.value < worst->value) worst = &look;
    }
    if (looks.empty()) return "";
    const bool has_other = !looks.front().against.empty();
    const bool has_ink =
        std::ranges::any_of(looks, [](const auto& l) { return l.soft.has_value(); });
    const std::string f = has_ink ? "soft F" : "F";
    core::Cells cells = {{"scene", "method", "views", f + " usual", f + " least", "true px"}};
    if (has_other) cells.front().push_back(f + " " + looks.front().against);
    for (const auto& [name, at] : place) {
        const Found& of = found[at];
        const HardestLook* look = of.worst;
        cells.push_back({name.first,
                         name.second,
                         std::to_string(of.looked),
                         core::format_share(of.usual_f()),
                         core::format_share(look == nullptr ? std::nullopt : look->f()),
                         look == nullptr ? "-" : std::to_string(look->count.n_truth)});
        if (has_other)
            cells.back().push_back(
                core::format_share(look == nullptr ? std::nullopt : look->other_f()));
    }
    std::string text = core::aligned(cells);
    if (worst != nullptr)
        text += fmt::format("The worst view is of {}: {}\n", worst->scene, worst->view_words());
    return text;
}

}  // namespace ink::studies
