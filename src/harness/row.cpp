#include "harness/row.h"

#include <fmt/format.h>

#include <functional>

#include "core/provenance.h"
#include "harness/csv.h"

namespace ink::harness {
namespace {

using score::Cause;

/// A column: its name, how a row fills it, and what it means. One table, so that they cannot drift
/// apart.
struct Column {
    std::string name;
    std::function<std::string(const Row&)> field;
    std::string doc;
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
Column column(std::string name, T Row::*field, std::string doc) {
    return {
        std::move(name), [field](const Row& row) { return text_of(row.*field); }, std::move(doc)};
}

/// A count that means something only where the cell came out.
Column counted(std::string name, std::int64_t Row::*field, std::string doc) {
    return {std::move(name),
            [field](const Row& row) { return row.is_ok() ? text_of(row.*field) : ""; },
            std::move(doc)};
}

template <class T>
Column chance(std::string name, T value_of, std::string doc) {
    return {std::move(name),
            [value_of](const Row& row) { return row.chance ? text_of(value_of(*row.chance)) : ""; },
            std::move(doc)};
}

Column recall(const std::string& line_class) {
    return {"recall_" + line_class,
            [line_class](const Row& row) {
                const auto found = row.recall_by_class.find(line_class);
                return found == row.recall_by_class.end() ? "" : text_of(found->second);
            },
            "recall of this class, by a matching of its own"};
}

Column truth_px(const std::string& line_class) {
    return {"truth_px_" + line_class,
            [line_class](const Row& row) {
                const auto found = row.truth_px_by_class.find(line_class);
                return found == row.truth_px_by_class.end() ? "" : text_of(found->second);
            },
            "true pixels of this class"};
}

/// A value of the line scores: empty where there are none, or where `value` says nothing.
template <class Value>
Column of_lines(std::string name, Value value, std::string doc) {
    return {std::move(name),
            [value](const Row& row) { return row.lines ? text_of(value(*row.lines)) : ""; },
            std::move(doc)};
}

void add_line_scores(std::vector<Column>& columns) {
    using L = LineScores;
    const auto add = [&columns](std::string name, auto value, std::string doc) {
        columns.push_back(of_lines(std::move(name), value, std::move(doc)));
    };
    add(
        "crack_precision",
        [](const L& l) { return l.cracks.precision(); },
        "share of the drawn pixels (unthinned) that have a true crack on one of their four sides");
    add(
        "crack_recall",
        [](const L& l) { return l.cracks.recall(); },
        "share of the true cracks with at least one of their two pixels drawn");
    add(
        "crack_f", [](const L& l) { return l.cracks.f(); }, "harmonic mean of the two");
    add(
        "offset_px",
        [](const L& l) { return l.offsets.all.mean(); },
        "mean signed distance of thinned pixels from the nearest curve within 2 px; positive to "
        "the empty side, else right or down");
    add(
        "offset_spread_px",
        [](const L& l) { return l.offsets.all.spread(); },
        "standard deviation of that distance");
    add(
        "offset_rms_px",
        [](const L& l) { return l.offsets.all.rms(); },
        "root mean square of that distance");
    add(
        "shift_x_px",
        [](const L& l) {
            return l.offsets.shift ? std::optional(l.offsets.shift->x_px) : std::nullopt;
        },
        "translation to the right that explains the offsets best; thinned pixels, so that what "
        "thinning itself moves is part of it (of lines two pixels wide half a pixel)");
    add(
        "shift_y_px",
        [](const L& l) {
            return l.offsets.shift ? std::optional(l.offsets.shift->y_px) : std::nullopt;
        },
        "the same, down");
    add(
        "width_along_px",
        [](const L& l) { return l.widths.all.mean(); },
        "mean width of what is drawn (unthinned), across the true curves, a probe each px");
    add(
        "width_spread_px",
        [](const L& l) { return l.widths.all.spread(); },
        "standard deviation of that width");
    add(
        "false_ink_px",
        [](const L& l) { return l.ink.n_false; },
        "drawn pixels (unthinned) further than 2 px from every true one");
}

void add_line_counts(std::vector<Column>& columns) {
    using L = LineScores;
    const auto add = [&columns](std::string name, auto value, std::string doc) {
        columns.push_back(of_lines(std::move(name), value, std::move(doc)));
    };
    add(
        "ink_px", [](const L& l) { return l.ink.n_drawn; }, "drawn pixels (unthinned) that count");
    add(
        "crack_drawn",
        [](const L& l) { return l.cracks.n_drawn; },
        "drawn pixels (unthinned) that count for cracks");
    add(
        "crack_beside", [](const L& l) { return l.cracks.n_beside; }, "of them, beside a crack");
    add(
        "crack_found", [](const L& l) { return l.cracks.all.n_found; }, "true cracks found");
    add(
        "crack_truth", [](const L& l) { return l.cracks.all.n_truth; }, "true cracks");
    add(
        "offset_n", [](const L& l) { return l.offsets.all.n; }, "thinned pixels near a curve");
    add(
        "width_n", [](const L& l) { return l.widths.all.n; }, "probes that met a line");
}

Column wrong_px(score::Cause cause, std::string doc) {
    return {fmt::format("{}_{}", score::is_miss(cause) ? "missing" : "off_line", name(cause)),
            [cause](const Row& row) { return row.causes ? text_of((*row.causes)[cause]) : ""; },
            std::move(doc)};
}

void add_skips(std::vector<Column>& columns) {
    // Not among `params`, and so not in a cell's key: like `threads` it says how the picture was
    // made and not which one, so that two rows that differ in it alone must have one image_hash.
    columns.push_back(column("skips_off",
                             &Row::skips_off,
                             "skips that were not allowed, a;b; still_tiles never is where one "
                             "view is drawn again and again"));
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        const auto skip = static_cast<std::size_t>(info.skip);
        const auto add = [&](std::string_view ending, auto count, std::string doc) {
            columns.push_back({fmt::format("skip_{}{}", info.name, ending),
                               [=](const Row& row) {
                                   return row.skips ? text_of((*row.skips)[skip].*count) : "";
                               },
                               std::move(doc)});
        };
        add("",
            &raster::SkipCount::skipped,
            fmt::format("{} left undone in a frame. {}", info.unit, info.summary));
        add("_of",
            &raster::SkipCount::of,
            fmt::format("{} there were; 0 where this does not apply", info.unit));
    }
}

Column constant(std::string name, const std::string& value) {
    return {std::move(name), [value](const Row&) { return csv_field(value); }, "provenance"};
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
        column("method", &Row::method, "method, or bracket: none, sampled, oracle"),
        column("scene", &Row::scene, "built-in scene, or stem of the model file"),
        column("view", &Row::view, "name of the camera"),
        column("split", &Row::split, "train or heldout"),
        column("width", &Row::width, "of the picture, px"),
        column("height", &Row::height, "of the picture, px"),
        column("threads", &Row::threads, "the method might use"),
        column("seed", &Row::seed, "as given: of chance pictures and of drawing scenes again"),
        column("params", &Row::params, "every parameter, key=value;key=value"),
        column("status", &Row::status, "ok, or why there are no metrics"),
        column("f_2px", &Row::f_2px, "F of one-to-one matches within 2 px, 0..1"),
        column("f_1px", &Row::f_1px, "the same within 1 px"),
        column("precision_2px", &Row::precision_2px, "matched share of the drawn pixels"),
        column("recall_2px", &Row::recall_2px, "matched share of the true pixels"),
        recall("contour"),
        recall("boundary"),
        recall("crease"),
        recall("intersection"),
        recall("seam"),
        column("mean_width_px", &Row::mean_width_px, "drawn pixels per thinned pixel"),
        column("ap", &Row::ap, "area under the precision envelope over 99 thresholds"),
        column("prepare_ns", &Row::prepare_ns, "once per topology"),
        column("draw_ns", &Row::draw_ns, "median time of a frame"),
        column("bytes_per_px", &Row::bytes_per_px, "of the method's buffers, depth included"),
        column("image_hash", &Row::image_hash, "of the strengths"),
        counted("truth_px", &Row::truth_px, "true pixels that count"),
        counted("k_2px", &Row::k_2px, "matches within 2 px"),
        counted("n_pred", &Row::n_pred, "drawn pixels after thinning"),
        counted("n_truth", &Row::n_truth, "true pixels"),
        counted("surplus", &Row::surplus, "drawn pixels left over beside a matched line"),
        counted("off_line", &Row::off_line, "drawn pixels with no true one in reach"),
        counted("lost", &Row::lost, "true pixels left over beside a drawn line"),
        counted("missing", &Row::missing, "true pixels with no drawn one in reach"),
        column("k_1px", &Row::k_1px, "matches within 1 px"),
        column("n_pred_1px", &Row::n_pred_1px, "drawn pixels after thinning, at 1 px"),
        chance(
            "f_chance_2px",
            [](const score::CurveCount& c) { return c.f(); },
            "F of a random picture of as many pixels, within 2 px"),
        chance(
            "k_chance_2px", [](const score::CurveCount& c) { return c.k; }, "its matches"),
        chance(
            "n_pred_chance",
            [](const score::CurveCount& c) { return c.n_pred; },
            "its drawn pixels that count"),
        truth_px("contour"),
        truth_px("boundary"),
        truth_px("crease"),
        truth_px("intersection"),
        truth_px("seam"),
        column("pose_ns", &Row::pose_ns, "once after prepare, or when something moved"),
        column("draw_ns_q25", &Row::draw_ns_q25, "lower quartile"),
        column("draw_ns_q75", &Row::draw_ns_q75, "upper quartile"),
        column("draw_ns_min", &Row::draw_ns_min, "least"),
        column("draw_n", &Row::draw_n, "timed frames"),
        column("predicted_ns",
               &Row::predicted_ns,
               "draw_ns_min by the cost model, fitted without this scene (or view)"),
        column("cost_residual", &Row::cost_residual, "draw_ns_min over that, less 1"),
        counted("truth_merged_px", &Row::truth_merged_px, "true pixels that thinning took away"),
        column("crowded_share", &Row::crowded_share, "share of true pixels too dense to score"),
        column("witness_disagreement",
               &Row::witness_disagreement,
               "share of the lines that only truth or only witness has, 0.25 px, per class"),
        wrong_px(Cause::one_triangle, "of off_line: one triangle fills the stencil"),
        wrong_px(Cause::one_patch, "of off_line: triangles of one smooth patch"),
        wrong_px(Cause::crack, "of off_line: a true line crosses the stencil, out of reach"),
        wrong_px(Cause::frame, "of off_line: the frame took the true line away"),
        wrong_px(Cause::other, "of off_line: several surfaces without a true line between"),
        wrong_px(Cause::cancelled, "of missing: a channel changed enough, the code did not"),
        wrong_px(Cause::below_threshold, "of missing: no channel changed enough"),
        wrong_px(Cause::sub_pixel, "of missing: no stencil of pixel centres sees the line"),
        wrong_px(Cause::thinned, "of missing: drawn, but thinning took it out of reach"),
        wrong_px(Cause::unexplained, "of missing: the declared code should have drawn it"),
        wrong_px(Cause::undeclared, "of missing: seen by a stencil, and no code is declared"),
        column("triangles", &Row::triangles, "of the scene, instances counted"),
        column("weld_epsilon",
               &Row::weld_epsilon,
               "the truth joins vertices this near, as a share of each part's diagonal"),
        column("contour_sky_px", &Row::contour_sky_px, "length of true contours before the sky"),
        column("contour_other_px", &Row::contour_other_px, "the same before another object"),
        column("contour_self_px", &Row::contour_self_px, "the same before their own object"),
    };
    add_line_scores(columns);
    add_line_counts(columns);
    add_skips(columns);
    add_provenance(columns);
    return columns;
}

const std::vector<Column>& columns() {
    static const std::vector<Column> kColumns = make_columns();
    return kColumns;
}

}  // namespace

Place place_of(const Row& row) {
    return {row.scene, row.view, row.width, row.height};
}

const std::vector<std::string>& row_columns() {
    static const std::vector<std::string> kNames = [] {
        std::vector<std::string> names;
        for (const Column& c : columns())
            names.push_back(c.name);
        return names;
    }();
    return kNames;
}

std::vector<std::pair<std::string, std::string>> described_columns() {
    std::vector<std::pair<std::string, std::string>> described;
    for (const Column& c : columns())
        described.emplace_back(c.name, c.doc);
    return described;
}

std::string to_csv(const Row& row) {
    std::string line;
    for (const Column& c : columns()) {
        if (&c != &columns().front()) line += ',';
        line += c.field(row);
    }
    return line;
}

bool is_bracket(std::string_view method) {
    return method == "none" || method == "sampled" || method == "oracle";
}

}  // namespace ink::harness
