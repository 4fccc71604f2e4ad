#include "linear_code/bound_tables.h"

#include "harness/cell.h"
#include "harness/evaluations.h"

namespace ink::linear_code {
namespace {

using BoundTable = harness::SideTable<BoundRow>;

void add_measured(BoundTable& table) {
    using C = score::CurveCount;
    table.add({"views", "", "of the scene or scenes"}, &BoundRow::views);
    const auto measured = table.part(&BoundRow::measured);
    measured.add_derived({"f_2px", "0..1", "F of the method as it is scored, over all views"},
                         &C::f);
    measured.add({"k_2px", "px", "its matches within 2 px"}, &C::k);
    measured.add({"n_pred", "px", "its drawn pixels after thinning"}, &C::n_pred);
    measured.add({"n_truth", "px", "true pixels"}, &C::n_truth);
}

/// Of the method's own weights: empty where it has none in the domain.
void add_model(BoundTable& table) {
    using C = LinearCount;
    const auto model = table.part(&BoundRow::modelled);
    model.add_derived({"f_model", "0..1", "F of its weights by the bound's more lenient rule"},
                      &C::f);
    model.add({"model_found", "px", "true pixels of which a stencil fires"}, &C::found);
    model.add({"model_far_positives", "px", "stencils that fire far from lines"},
              &C::far_positives);
    model.add({"model_n_truth", "px", "true pixels that the bound counts"}, &C::n_truth);
}

void add_bound(BoundTable& table) {
    using B = LinearBound;
    using C = LinearCount;
    const auto bound = table.part(&BoundRow::bound);
    bound.add({"f_found", "0..1", "the best F of weights that were found"}, &B::f_found);
    bound.add({"f_upper",
               "0..1",
               "an estimate of what no weights exceed: how much ink thinning leaves is measured"},
              &B::f_upper);
    bound.add_derived({"gap", "0..1", "f_upper less f_found"}, &B::gap);
    bound.add({"boxes", "", "of weights that were searched"}, &B::boxes);
    const auto count = bound.part(&B::count);
    count.add({"found", "px", "true pixels of which a stencil fires, by the weights found"},
              &C::found);
    count.add({"far_positives", "px", "stencils that fire far from lines, by them"},
              &C::far_positives);
    count.add({"asked_truth", "px", "true pixels that the bound counts"}, &C::n_truth);
    constexpr const char* kWeights[] = {"depth", "nx", "ny", "nz"};
    for (std::size_t i = 0; i < std::size(kWeights); ++i) {
        bound.add(
            {kWeights[i], "1/threshold", "weight found, over the threshold"},
            [i](auto& of) -> auto& { return of.weights[i]; });
    }
}

}  // namespace

const BoundTable& bound_table() {
    static const BoundTable kTable = [] {
        BoundTable table(
            "bound.csv",
            "A line per cell of study `bound`: about the most that any four weights could "
            "reach on a scene or on several, and what a method's own weights reach.");
        add_measured(table);
        add_model(table);
        add_bound(table);
        return table;
    }();
    return kTable;
}

harness::Row bound_row(const BoundRow& of,
                       const BoundStudyOptions& options,
                       int width_px,
                       int height_px) {
    const method::MethodInfo& info = *options.config.info;
    harness::Row row;
    row.method = info.name;
    row.scene = of.scene;
    row.split = of.split;
    row.width = width_px;
    row.height = height_px;
    row.threads = options.search.threads;
    row.params = harness::join_params(info.complete(options.config.settings));
    harness::fill_truth_settings(options.trace, row);
    return row;
}

std::vector<BoundRow> read_bounds(const harness::CsvTable& csv, const harness::RowIndex& rows) {
    return bound_table().read_with_rows(csv, rows, [](BoundRow& bound, const harness::Row& row) {
        bound.scene = row.scene;
        bound.split = row.split;
    });
}

}  // namespace ink::linear_code
