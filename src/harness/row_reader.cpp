#include "harness/row_reader.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

#include "core/error.h"
#include "harness/csv.h"
#include "truth/line_class.h"

namespace ink::harness {
namespace {

/// Where each column is.
using ColumnIndex = std::map<std::string, std::size_t, std::less<>>;

ColumnIndex index_of(const CsvTable& table) {
    ColumnIndex index;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        index.emplace(table.columns[i], i);
    return index;
}

/// The fields of one record by column.
class Fields {
  public:
    Fields(const ColumnIndex& columns, const std::vector<std::string>& record, std::string where)
        : columns_(columns), record_(record), where_(std::move(where)) {}

    [[nodiscard]] std::string text(const std::string& column) const {
        const auto found = columns_.find(column);
        return found == columns_.end() ? "" : unquoted(record_[found->second]);
    }

    /// Nothing for an empty field or a column that is not there.
    template <class T>
    [[nodiscard]] std::optional<T> number(const std::string& column) const {
        const std::string field = text(column);
        if (field.empty()) return std::nullopt;
        T value{};
        const char* end = field.data() + field.size();
        const auto [stop, status] = std::from_chars(field.data(), end, value);
        if (status != std::errc{} || stop != end) {
            throw core::Error(
                where_, fmt::format("column {} holds '{}'", column, field), "a number");
        }
        return value;
    }

    template <class T>
    void read(const std::string& column, T& value) const {
        if (const auto found = number<T>(column)) value = *found;
    }
    template <class T>
    void read(const std::string& column, std::optional<T>& value) const {
        value = number<T>(column);
    }
    void read(const std::string& column, std::string& value) const { value = text(column); }

    [[nodiscard]] std::string need(const std::string& column) const {
        if (!columns_.contains(column)) {
            throw core::Error(
                where_, fmt::format("there is no column {}", column), "the columns of rows.csv");
        }
        return text(column);
    }

  private:
    const ColumnIndex& columns_;
    const std::vector<std::string>& record_;
    std::string where_;
};

/// The doubles nearest `value`, itself first.
std::vector<double> doubles_round(double value) {
    constexpr int kReach = 12;
    std::vector<double> found = {value};
    double above = value;
    double below = value;
    for (int i = 0; i < kReach; ++i) {
        above = std::nextafter(above, INFINITY);
        below = std::nextafter(below, -INFINITY);
        found.insert(found.end(), {above, below});
    }
    return found;
}

/// Sums that give these very means: rounding lets several do, and the first is taken.
score::Moments moments_of(std::int64_t n,
                          std::optional<double> mean,
                          std::optional<double> spread,
                          std::optional<double> rms) {
    score::Moments moments;
    if (n == 0 || !mean || !spread) return moments;
    const auto count = static_cast<double>(n);
    const double mean_square = rms ? *rms * *rms : *spread * *spread + *mean * *mean;
    moments = {n, *mean * count, mean_square * count};
    for (const double sum : doubles_round(*mean * count)) {
        for (const double squares : doubles_round(mean_square * count)) {
            const score::Moments tried{n, sum, squares};
            const bool is_it = *tried.mean() == *mean && *tried.spread() == *spread &&
                               (!rms || *tried.rms() == *rms);
            if (is_it) return tried;
        }
    }
    return moments;
}

std::optional<LineScores> lines_of(const Fields& fields) {
    const auto n_drawn = fields.number<std::int64_t>("ink_px");
    if (!n_drawn) return std::nullopt;
    LineScores lines;
    lines.ink.n_drawn = *n_drawn;
    fields.read("false_ink_px", lines.ink.n_false);
    fields.read("crack_drawn", lines.cracks.n_drawn);
    fields.read("crack_beside", lines.cracks.n_beside);
    fields.read("crack_found", lines.cracks.all.n_found);
    fields.read("crack_truth", lines.cracks.all.n_truth);
    lines.offsets.all = moments_of(fields.number<std::int64_t>("offset_n").value_or(0),
                                   fields.number<double>("offset_px"),
                                   fields.number<double>("offset_spread_px"),
                                   fields.number<double>("offset_rms_px"));
    lines.widths.all = moments_of(fields.number<std::int64_t>("width_n").value_or(0),
                                  fields.number<double>("width_along_px"),
                                  fields.number<double>("width_spread_px"),
                                  std::nullopt);
    const auto shift_x = fields.number<double>("shift_x_px");
    const auto shift_y = fields.number<double>("shift_y_px");
    if (shift_x && shift_y) lines.offsets.shift = score::Shift{*shift_x, *shift_y};
    return lines;
}

void read_causes(const Fields& fields, Row& row) {
    score::CauseCounts counts;
    bool is_there = false;
    const auto read = [&](std::string_view kind, score::Cause cause) {
        const auto px = fields.number<std::int64_t>(fmt::format("{}_{}", kind, name(cause)));
        if (!px) return;
        counts[cause] = *px;
        is_there = true;
    };
    for (const score::Cause cause : score::kOffLineCauses)
        read("off_line", cause);
    for (const score::Cause cause : score::kMissCauses)
        read("missing", cause);
    if (is_there) row.causes = counts;
}

void read_skips(const Fields& fields, Row& row) {
    fields.read("skips_off", row.skips_off);
    raster::SkipCounts counts{};
    bool is_there = false;
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        raster::SkipCount& count = count_of(counts, info.skip);
        const auto skipped = fields.number<std::uint64_t>(fmt::format("skip_{}", info.name));
        is_there = is_there || skipped;
        count.skipped = skipped.value_or(0);
        fields.read(fmt::format("skip_{}_of", info.name), count.of);
    }
    if (is_there) row.skips = counts;
}

void read_scores(const Fields& fields, Row& row) {
    fields.read("f_2px", row.f_2px);
    fields.read("f_1px", row.f_1px);
    fields.read("precision_2px", row.precision_2px);
    fields.read("recall_2px", row.recall_2px);
    for (const truth::LineClass line_class : truth::kLineClasses) {
        const std::string name(truth::name(line_class));
        if (const auto r = fields.number<double>("recall_" + name)) row.recall_by_class[name] = *r;
        if (const auto n = fields.number<std::int64_t>("truth_px_" + name))
            row.truth_px_by_class[name] = *n;
    }
    fields.read("mean_width_px", row.mean_width_px);
    fields.read("ap", row.ap);
    fields.read("truth_px", row.truth_px);
    fields.read("k_2px", row.k_2px);
    fields.read("n_pred", row.n_pred);
    fields.read("n_truth", row.n_truth);
    fields.read("surplus", row.surplus);
    fields.read("off_line", row.off_line);
    fields.read("lost", row.lost);
    fields.read("missing", row.missing);
    fields.read("k_1px", row.k_1px);
    fields.read("n_pred_1px", row.n_pred_1px);
    if (const auto k = fields.number<std::int64_t>("k_chance_2px")) {
        row.chance = score::CurveCount{
            *k, fields.number<std::int64_t>("n_pred_chance").value_or(0), row.n_truth};
    }
    read_causes(fields, row);
    row.lines = lines_of(fields);
}

void read_times(const Fields& fields, Row& row) {
    fields.read("prepare_ns", row.prepare_ns);
    fields.read("pose_ns", row.pose_ns);
    fields.read("draw_ns", row.draw_ns);
    fields.read("draw_ns_q25", row.draw_ns_q25);
    fields.read("draw_ns_q75", row.draw_ns_q75);
    fields.read("draw_ns_min", row.draw_ns_min);
    fields.read("draw_n", row.draw_n);
    fields.read("predicted_ns", row.predicted_ns);
    fields.read("cost_residual", row.cost_residual);
}

Row read_row(const Fields& fields) {
    Row row;
    row.method = fields.need("method");
    row.scene = fields.need("scene");
    row.view = fields.need("view");
    row.params = fields.need("params");
    row.status = fields.need("status");
    fields.read("split", row.split);
    fields.read("width", row.width);
    fields.read("height", row.height);
    fields.read("threads", row.threads);
    fields.read("seed", row.seed);
    read_scores(fields, row);
    read_times(fields, row);
    read_skips(fields, row);
    fields.read("bytes_per_px", row.bytes_per_px);
    fields.read("image_hash", row.image_hash);
    fields.read("truth_merged_px", row.truth_merged_px);
    fields.read("crowded_share", row.crowded_share);
    fields.read("witness_disagreement", row.witness_disagreement);
    fields.read("triangles", row.triangles);
    fields.read("weld_epsilon", row.weld_epsilon);
    fields.read("contour_sky_px", row.contour_sky_px);
    fields.read("contour_other_px", row.contour_other_px);
    fields.read("contour_self_px", row.contour_self_px);
    return row;
}

std::string record_of(const std::string& where, std::size_t i) {
    return fmt::format("{}, record {}", where, i + 1);
}

}  // namespace

std::vector<Row> read_rows(const CsvTable& table, const std::string& where) {
    std::vector<Row> rows;
    const ColumnIndex columns = index_of(table);
    for (std::size_t i = 0; i < table.records.size(); ++i)
        rows.push_back(read_row({columns, table.records[i], record_of(where, i)}));
    return rows;
}

std::vector<statistics::CellCurve> read_curves(const CsvTable& table,
                                               const std::vector<Row>& rows,
                                               const std::string& where) {
    std::map<std::string, const Row*> cells;
    for (const Row& row : rows)
        cells.emplace(cell_key(row), &row);
    std::vector<statistics::CellCurve> curves;
    const ColumnIndex columns = index_of(table);
    std::string last_key;
    bool is_wanted = false;
    for (std::size_t i = 0; i < table.records.size(); ++i) {
        const Fields fields(columns, table.records[i], record_of(where, i));
        const auto at = fields.number<std::size_t>("threshold_k").value_or(0);
        if (at < 1 || at > 99) {
            throw core::Error(record_of(where, i), "its threshold_k is not there", "1..99");
        }
        Row named;
        named.method = fields.need("method");
        named.scene = fields.need("scene");
        named.view = fields.need("view");
        named.params = fields.need("params");
        fields.read("width", named.width);
        fields.read("height", named.height);
        const std::string key = cell_key(named);
        // A cell that is there twice (of several numbers of threads) begins again at 1.
        if (key != last_key || at == 1) {
            last_key = key;
            const auto cell = cells.find(key);
            is_wanted = cell != cells.end() && !is_bracket(named.method);
            if (is_wanted) curves.push_back({named.method, cell->second->split == "train", {}});
        }
        if (!is_wanted) continue;
        score::CurveCount& counts = curves.back().counts[at - 1];
        fields.read("k", counts.k);
        fields.read("n_pred", counts.n_pred);
        fields.read("n_truth", counts.n_truth);
    }
    return curves;
}

}  // namespace ink::harness
