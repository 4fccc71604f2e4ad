#include "lab/row.h"

#include <fmt/format.h>

#include <functional>

#include "core/provenance.h"
#include "lab/csv.h"

namespace ink::lab {
namespace {

/// A column: its name and how a row fills it. One table, so that names and values cannot drift
/// apart.
struct Column {
    std::string name;
    std::function<std::string(const Row&)> field;
};

template <class T>
std::string text_of(const T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
        return csv_field(value);
    } else {
        return fmt::format("{}", value);
    }
}

template <class T>
std::string text_of(const std::optional<T>& value) {
    return value ? text_of(*value) : "";
}

template <class T>
Column column(std::string name, T Row::*field) {
    return {std::move(name), [field](const Row& row) { return text_of(row.*field); }};
}

/// A count that means something only where the cell came out.
Column counted(std::string name, std::int64_t Row::*field) {
    return {std::move(name),
            [field](const Row& row) { return row.is_ok() ? text_of(row.*field) : ""; }};
}

Column recall(const std::string& line_class) {
    return {"recall_" + line_class, [line_class](const Row& row) {
                const auto found = row.recall_by_class.find(line_class);
                return found == row.recall_by_class.end() ? "" : text_of(found->second);
            }};
}

Column truth_px(const std::string& line_class) {
    return {"truth_px_" + line_class, [line_class](const Row& row) {
                const auto found = row.truth_px_by_class.find(line_class);
                return found == row.truth_px_by_class.end() ? "" : text_of(found->second);
            }};
}

Column constant(std::string name, const std::string& value) {
    return {std::move(name), [value](const Row&) { return csv_field(value); }};
}

void add_provenance(std::vector<Column>& columns) {
    const core::Provenance& p = core::provenance();
    columns.push_back(constant("version", p.version));
    columns.push_back(constant("commit", p.commit));
    columns.push_back(constant("dirty", p.dirty ? "true" : "false"));
    columns.push_back(constant("compiler", p.compiler));
    columns.push_back(constant("flags", p.flags));
    columns.push_back(constant("cpu", p.cpu));
    columns.push_back(constant("simd", p.simd));
    for (const auto& [library, version] : p.libraries)
        columns.push_back(constant(library, version));
}

std::vector<Column> make_columns() {
    std::vector<Column> columns = {
        column("method", &Row::method),
        column("scene", &Row::scene),
        column("view", &Row::view),
        column("split", &Row::split),
        column("width", &Row::width),
        column("height", &Row::height),
        column("threads", &Row::threads),
        column("seed", &Row::seed),
        column("params", &Row::params),
        column("status", &Row::status),
        column("f_2px", &Row::f_2px),
        column("f_1px", &Row::f_1px),
        column("precision_2px", &Row::precision_2px),
        column("recall_2px", &Row::recall_2px),
        recall("contour"),
        recall("boundary"),
        recall("crease"),
        recall("intersection"),
        recall("seam"),
        column("mean_width_px", &Row::mean_width_px),
        column("ap", &Row::ap),
        column("prepare_ns", &Row::prepare_ns),
        column("draw_ns", &Row::draw_ns),
        column("bytes_per_px", &Row::bytes_per_px),
        column("image_hash", &Row::image_hash),
        counted("truth_px", &Row::truth_px),
        counted("k_2px", &Row::k_2px),
        counted("n_pred", &Row::n_pred),
        counted("n_truth", &Row::n_truth),
        counted("surplus", &Row::surplus),
        counted("off_line", &Row::off_line),
        counted("lost", &Row::lost),
        counted("missing", &Row::missing),
        counted("k_1px", &Row::k_1px),
        counted("n_pred_1px", &Row::n_pred_1px),
        truth_px("contour"),
        truth_px("boundary"),
        truth_px("crease"),
        truth_px("intersection"),
        truth_px("seam"),
        column("pose_ns", &Row::pose_ns),
        column("draw_ns_q25", &Row::draw_ns_q25),
        column("draw_ns_q75", &Row::draw_ns_q75),
        column("draw_ns_min", &Row::draw_ns_min),
        column("draw_n", &Row::draw_n),
        counted("truth_merged_px", &Row::truth_merged_px),
        column("crowded_share", &Row::crowded_share),
        column("triangles", &Row::triangles),
    };
    add_provenance(columns);
    return columns;
}

const std::vector<Column>& columns() {
    static const std::vector<Column> kColumns = make_columns();
    return kColumns;
}

}  // namespace

const std::vector<std::string>& row_columns() {
    static const std::vector<std::string> kNames = [] {
        std::vector<std::string> names;
        for (const Column& c : columns())
            names.push_back(c.name);
        return names;
    }();
    return kNames;
}

std::string to_csv(const Row& row) {
    std::string line;
    for (const Column& c : columns()) {
        if (&c != &columns().front()) line += ',';
        line += c.field(row);
    }
    return line;
}

}  // namespace ink::lab
