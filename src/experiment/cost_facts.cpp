#include "experiment/cost_facts.h"

#include <fmt/format.h>

#include <charconv>

#include "core/error.h"

namespace ink::experiment {
namespace {

/// Calls `visit` with every number of the facts, always in the same order.
template <class Facts, class Visit>
void each_number(Facts& facts, Visit visit) {
    auto& declared = facts.declared;
    visit(declared.passes);
    visit(declared.interpolants);
    visit(declared.values_per_vertex);
    visit(declared.shares_vertices);
    for (auto* work : {&declared.fill, &declared.filter}) {
        visit(work->bytes_read);
        visit(work->bytes_written);
        visit(work->operations);
    }
    visit(declared.buffer_bytes_per_px);
    visit(facts.frame.vertices);
    visit(facts.frame.triangles);
    visit(facts.frame.covered_px);
    visit(facts.frame.frame_px);
}

}  // namespace

std::string facts_table(const std::string& table) {
    return "cost_facts:" + table;
}

std::string cost_facts_line(const harness::Row& row) {
    std::string line;
    if (!row.cost) return line;
    each_number(*row.cost, [&](const auto& value) {
        line += fmt::format("{}{}", line.empty() ? "" : " ", static_cast<double>(value));
    });
    return line;
}

std::optional<harness::CostFacts> read_cost_facts(const std::string& line,
                                                  const std::string& where) {
    if (line.empty()) return std::nullopt;
    harness::CostFacts facts;
    const char* at = line.data();
    const char* end = at + line.size();
    bool is_good = true;
    each_number(facts, [&](auto& value) {
        double number = 0;
        if (at < end && *at == ' ') ++at;
        const auto [stop, status] = std::from_chars(at, end, number);
        is_good = is_good && status == std::errc{};
        at = stop;
        value = static_cast<std::remove_reference_t<decltype(value)>>(number);
    });
    if (!is_good || at != end) {
        throw core::Error(where, "the facts of a row are damaged", "an unchanged file");
    }
    return facts;
}

}  // namespace ink::experiment
