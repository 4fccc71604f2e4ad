#include "linear_code/bound_tables.h"

#include "harness/cell.h"
#include "harness/tables/table_of.h"

namespace ink::linear_code {
namespace {

struct Record {
    std::int64_t cell = 0;
    BoundRow row;
};
using BoundTable = harness::TableOf<Record>;

void add_measured(BoundTable& table) {
    table.add(
        {"views", "", "of the scene or scenes"}, [](auto& r) -> auto& { return r.row.views; });
    table.add_derived({"f_2px", "0..1", "F of the method as it is scored, over all views"},
                      [](const Record& r) { return r.row.measured.f(); });
    table.add(
        {"k_2px", "px", "its matches within 2 px"},
        [](auto& r) -> auto& { return r.row.measured.k; });
    table.add(
        {"n_pred", "px", "its drawn pixels after thinning"},
        [](auto& r) -> auto& { return r.row.measured.n_pred; });
    table.add(
        {"n_truth", "px", "true pixels"}, [](auto& r) -> auto& { return r.row.measured.n_truth; });
}

/// A count of the method's own weights, empty where it has none in the domain.
void add_model(BoundTable& table, harness::Column column, std::int64_t LinearCount::*count) {
    table.add(
        std::move(column),
        [count](const Record& r) {
            return r.row.modelled ? harness::csv_text((*r.row.modelled).*count) : "";
        },
        [count](const harness::CsvField& field, Record& r) {
            if (field.is_empty()) return;
            if (!r.row.modelled) r.row.modelled.emplace();
            field.read((*r.row.modelled).*count);
        });
}

void add_models(BoundTable& table) {
    table.add_derived({"f_model", "0..1", "F of its weights by the bound's more lenient rule"},
                      [](const Record& r) {
                          return r.row.modelled ? std::optional(r.row.modelled->f()) : std::nullopt;
                      });
    add_model(
        table, {"model_found", "px", "true pixels of which a stencil fires"}, &LinearCount::found);
    add_model(table,
              {"model_far_positives", "px", "stencils that fire far from lines"},
              &LinearCount::far_positives);
    add_model(
        table, {"model_n_truth", "px", "true pixels that the bound counts"}, &LinearCount::n_truth);
}

void add_bound(BoundTable& table) {
    table.add(
        {"f_found", "0..1", "the best F of weights that were found"},
        [](auto& r) -> auto& { return r.row.bound.f_found; });
    table.add(
        {"f_upper", "0..1", "no weights can exceed this"},
        [](auto& r) -> auto& { return r.row.bound.f_upper; });
    table.add_derived({"gap", "0..1", "f_upper less f_found"},
                      [](const Record& r) { return r.row.bound.gap(); });
    table.add(
        {"boxes", "", "of weights that were searched"},
        [](auto& r) -> auto& { return r.row.bound.boxes; });
    table.add(
        {"found", "px", "true pixels of which a stencil fires, by the weights found"},
        [](auto& r) -> auto& { return r.row.bound.count.found; });
    table.add(
        {"far_positives", "px", "stencils that fire far from lines, by them"},
        [](auto& r) -> auto& { return r.row.bound.count.far_positives; });
    table.add(
        {"asked_truth", "px", "true pixels that the bound counts"},
        [](auto& r) -> auto& { return r.row.bound.count.n_truth; });
    constexpr const char* kWeights[] = {"depth", "nx", "ny", "nz"};
    for (std::size_t i = 0; i < std::size(kWeights); ++i) {
        table.add(
            {kWeights[i], "1/threshold", "weight found, over the threshold"},
            [i](auto& r) -> auto& { return r.row.bound.weights[i]; });
    }
}

const BoundTable& table() {
    static const BoundTable kTable = [] {
        BoundTable table("bound.csv",
                         "A line per cell of study `bound`: the most that any four weights could "
                         "reach on a scene or on several, and what a method's own weights reach.");
        table.add(
            {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
        add_measured(table);
        add_models(table);
        add_bound(table);
        return table;
    }();
    return kTable;
}

}  // namespace

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
    row.weld_epsilon = options.trace.truth.weld_epsilon;
    return row;
}

const harness::TableInfo& bound_table() {
    return table().info();
}

std::string bound_line(std::int64_t cell, const BoundRow& row) {
    return table().line({cell, row});
}

std::vector<BoundRow> read_bounds(const harness::CsvTable& csv, const harness::RowIndex& rows) {
    std::vector<BoundRow> bounds;
    for (Record& record : table().read(csv)) {
        const harness::Row& row = rows.find(harness::CsvField(csv, bounds.size(), 0)).row;
        record.row.scene = row.scene;
        record.row.split = row.split;
        bounds.push_back(std::move(record.row));
    }
    return bounds;
}

}  // namespace ink::linear_code
