#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "core/error.h"
#include "core/vocabulary.h"
#include "harness/rows/row_table.h"

namespace ink::harness {

/// Values without rhyme or reason, the same for the same seed: text with everything that must be
/// quoted, doubles of any exponent.
class RandomValues {
  public:
    explicit RandomValues(std::uint64_t seed) : bits_(seed) {}

    bool coin() { return (bits_() & 1) != 0; }
    std::int64_t count() { return static_cast<std::int64_t>(bits_() >> (1 + bits_() % 62)); }
    int small() { return static_cast<int>(bits_() % 1000); }
    std::size_t below(std::size_t n) { return bits_() % n; }
    double real() {
        while (true) {
            const double value = std::bit_cast<double>(bits_());
            if (std::isfinite(value)) return value;
        }
    }
    double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
    std::string text() {
        static const std::string kLetters = "ab ,\"\n;=|'\xc3\xa4.0";
        std::string text;
        for (std::size_t n = bits_() % 9; n > 0; --n)
            text += kLetters[below(kLetters.size())];
        return text;
    }
    template <class Make>
    auto maybe(Make make) -> std::optional<decltype(make())> {
        if (coin()) return std::nullopt;
        return make();
    }

  private:
    std::mt19937_64 bits_;
};

inline score::CurveCount random_counts(RandomValues& any) {
    return {any.count(), any.count(), any.count()};
}

inline void fill_random_scores(RandomValues& any, Row& row) {
    row.f_2px = any.share();
    row.precision_2px = any.maybe([&] { return any.share(); });
    row.recall_2px = any.maybe([&] { return any.share(); });
    row.k_2px = any.count();
    row.n_pred = any.count();
    row.n_truth = any.count();
    row.truth_px = any.count();
    row.unmatched_duplicates = any.count();
    row.false_positives = any.count();
    row.unmatched_truth = any.count();
    row.false_negatives = any.count();
    row.truth_merged_px = any.count();
    row.crowded_share = any.share();
    const auto count = [&any] {
        return score::CurveCount{any.count() / 4, any.count() / 4, any.count() / 4};
    };
    row.above_crease_2px = any.maybe(count);
    row.all_intersections_2px = any.maybe(count);
    row.with_crowded_2px = any.maybe(count);
    row.soft = any.maybe([&any] {
        return score::SoftScore{any.share(), any.share(), any.share(), any.share(), any.share()};
    });
    for (const core::Term& group : core::vocabulary().recall_groups) {
        if (any.coin()) continue;
        const std::string key(group.name);
        const std::int64_t n = 1 + any.count() / 4;
        row.by_class[key] = {any.count(), n, n};
    }
}

inline void fill_random_times(RandomValues& any, Row& row) {
    for (auto* time : {&row.prepare_ns,
                       &row.pose_ns,
                       &row.draw_ns,
                       &row.draw_ns_median,
                       &row.draw_ns_q75,
                       &row.draw_ns_min,
                       &row.draw_wall_ns,
                       &row.draw_cpu_ns,
                       &row.yardstick_ns}) {
        *time = any.maybe([&] { return any.count(); });
    }
    row.draw_n = any.small();
    if (any.coin()) row.time_doubt = "waited";
}

inline CostFacts random_cost(RandomValues& any) {
    CostFacts cost;
    cost.declared.passes = any.small();
    cost.declared.interpolants = any.small();
    cost.declared.values_per_vertex = any.small();
    cost.declared.shares_vertices = any.coin();
    cost.declared.fill = {any.real(), any.real()};
    cost.declared.filter = {any.real(), any.real()};
    cost.declared.buffer_bytes_per_px = any.small();
    cost.frame = {any.real(), any.real(), any.real(), any.real()};
    return cost;
}

/// A cell with anything that it may hold but what other tables do.
inline Row random_row(RandomValues& any) {
    Row row;
    row.method = any.text();
    row.scene = any.text();
    row.view = any.text();
    row.split = any.coin() ? "train" : any.coin() ? "heldout" : "real";
    row.width = any.small();
    row.height = any.small();
    row.threads = any.small();
    row.seed = static_cast<std::uint64_t>(any.count()) * 2 + 1;
    row.params = any.text();
    row.status = any.coin() ? "ok" : any.text();
    if (any.coin()) fill_random_scores(any, row);
    row.f_1px = any.maybe([&] { return any.share(); });
    row.mean_width_px = any.maybe([&] { return any.real(); });
    row.ap = any.maybe([&] { return any.share(); });
    row.k_1px = any.maybe([&] { return any.count(); });
    row.n_pred_1px = any.maybe([&] { return any.count(); });
    if (row.is_scored() && any.coin())
        row.random_baseline = {any.count(), any.count(), row.n_truth};
    fill_random_times(any, row);
    row.bytes_per_px = any.maybe([&] { return any.small(); });
    row.image_hash = any.text();
    row.triangles = any.count();
    row.weld_epsilon = any.real();
    row.crease_deg = any.real();
    row.intersections = any.coin() ? score::Intersections::all : score::Intersections::above_crease;
    row.contour_sky_px = any.maybe([&] { return any.real(); });
    row.contour_other_px = any.maybe([&] { return any.real(); });
    row.contour_self_px = any.maybe([&] { return any.real(); });
    row.reference_disagreement = any.maybe([&] { return any.share(); });
    row.crosscheck_px = row.reference_disagreement ? any.real() : 0;
    row.crosscheck_abstained = row.reference_disagreement ? any.share() : 0;
    if (any.coin()) row.coincident_px_by_class["crease"] = any.real();
    if (any.coin()) {
        row.causes.emplace();
        for (std::int64_t& px : row.causes->px)
            px = any.count();
    }
    if (any.coin()) {
        row.skips.emplace();
        for (raster::SkipCount& count : *row.skips)
            count = {static_cast<std::uint64_t>(any.count()),
                     static_cast<std::uint64_t>(any.count())};
        row.skips_off = any.text();
    }
    return row;
}

/// `count` such rows, numbered with gaps, of any study.
inline std::vector<RowRecord> random_rows(RandomValues& any, int count) {
    std::vector<RowRecord> rows;
    std::int64_t cell = 0;
    for (int i = 0; i < count; ++i) {
        cell += 1 + any.small();
        rows.push_back({cell, any.coin() ? Study::compare : Study::stress, random_row(any)});
        if (!any.coin()) continue;
        rows.back().row.axis = any.text();
        rows.back().row.value = any.real();
    }
    return rows;
}

/// A table as its file has it, split again.
inline core::CsvTable file_of(const core::TableInfo& info, const std::string& lines) {
    return core::split_csv(core::heading(info) + lines, info.file);
}

/// The field of `column` of a row as rows.csv has it, without its quotes.
inline std::string field(const Row& row, const std::string& column) {
    const core::CsvTable table = file_of(rows_table(), row_line(1, Study::compare, row));
    return core::unquoted(table.records.at(0).at(table.find(column)));
}

/// Rows as rows.csv gives them back.
inline std::vector<RowRecord> read_again(const std::vector<RowRecord>& rows) {
    std::string lines;
    for (const RowRecord& row : rows)
        lines += row_line(row.cell, row.study, row.row);
    return read_rows(file_of(rows_table(), lines));
}

}  // namespace ink::harness
