#include "linear_code/cancellation_table.h"

namespace ink::linear_code {
namespace {

using CancellationTable = harness::SideTable<CancellationRow>;

void add_kind(CancellationTable& table) {
    const auto kind = table.part(&CancellationRow::kind);
    kind.add_derived({"class", "", "of line: contour, boundary, crease, intersection, seam"},
                     [](const LineKind& of) { return truth::name(of.line_class); });
    kind.add(
        {"dihedral_low_deg", "deg", "dihedral deviation of the two faces at which the bin begins"},
        &LineKind::dihedral_low_deg);
    kind.add_derived({"dihedral_high_deg", "deg", "at which the bin ends"}, [](const LineKind& of) {
        const auto low = of.dihedral_low_deg;
        return low ? std::optional(*low + kDihedralBin_deg) : std::nullopt;
    });
}

}  // namespace

const CancellationTable& cancellation_table() {
    static const CancellationTable kTable = [] {
        CancellationTable table("cancellation.csv",
                                "A line per cell of a method with a declared code, class of line "
                                "and dihedral: how much "
                                "is lost because changes of channels cancel, as predicted and as "
                                "measured, within 2 px.");
        table.add({"silent_deg", "deg", "the dihedral up to which the code is silent"},
                  &CancellationRow::silent_deg);
        add_kind(table);
        using C = CancellationCount;
        const auto count = table.part(&CancellationRow::count);
        count.add({"n_truth", "px", "true pixels of the kind"}, &C::n_truth);
        count.add({"predicted_missed", "px", "of them without a match, as predicted"},
                  &C::predicted_missed);
        count.add({"measured_missed", "px", "of them without a match"}, &C::measured_missed);
        count.add(
            {"predicted_false_negatives", "px", "of them with nothing in reach, as predicted"},
            &C::predicted_false_negatives);
        count.add({"measured_false_negatives", "px", "of them with nothing drawn in reach"},
                  &C::measured_false_negatives);
        count.add({"both_false_negatives", "px", "of them both"}, &C::both_false_negatives);
        return table;
    }();
    return kTable;
}

}  // namespace ink::linear_code
