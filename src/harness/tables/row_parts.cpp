#include "harness/tables/row_parts.h"

#include <fmt/format.h>

namespace ink::harness {
namespace {

using score::Cause;

/// Adds columns of the line scores: empty fields where a row has none.
class LineColumns {
  public:
    explicit LineColumns(RowTable& table) : table_(table) {}

    /// A count or a sum, at the place in the line scores that `place` gives.
    template <class Place>
    void add(Column column, Place place) {
        table_.add(
            std::move(column),
            [place](const RowRecord& r) {
                return r.row.lines ? csv_text(place(*r.row.lines)) : "";
            },
            [place](const CsvField& field, RowRecord& r) {
                if (!field.is_empty()) field.read(place(lines_of(r)));
            });
    }
    /// What follows from them.
    template <class Value>
    void add_derived(Column column, Value value_of) {
        table_.add(
            std::move(column),
            [value_of](const RowRecord& r) {
                return r.row.lines ? csv_text(value_of(*r.row.lines)) : "";
            },
            [](const CsvField&, RowRecord&) {});
    }

    static LineScores& lines_of(RowRecord& r) {
        if (!r.row.lines) r.row.lines.emplace();
        return *r.row.lines;
    }

  private:
    RowTable& table_;
};

void add_shift(RowTable& table, Column column, double score::Shift::*part) {
    table.add(
        std::move(column),
        [part](const RowRecord& r) {
            const bool has_shift = r.row.lines && r.row.lines->offsets.shift;
            return has_shift ? csv_text((*r.row.lines->offsets.shift).*part) : "";
        },
        [part](const CsvField& field, RowRecord& r) {
            if (field.is_empty()) return;
            auto& shift = LineColumns::lines_of(r).offsets.shift;
            if (!shift) shift.emplace();
            field.read((*shift).*part);
        });
}

void add_cracks(LineColumns& lines) {
    using L = LineScores;
    lines.add_derived({"crack_precision",
                       "0..1",
                       "share of the drawn pixels (unthinned) that have a true crack on one of "
                       "their four sides"},
                      [](const L& l) { return l.cracks.precision(); });
    lines.add_derived({"crack_recall",
                       "0..1",
                       "share of the true cracks with at least one of their two pixels drawn"},
                      [](const L& l) { return l.cracks.recall(); });
    lines.add_derived({"crack_f", "0..1", "harmonic mean of the two"},
                      [](const L& l) { return l.cracks.f(); });
    lines.add(
        {"crack_drawn", "px", "drawn pixels (unthinned) that count for cracks"},
        [](auto& l) -> auto& { return l.cracks.n_drawn; });
    lines.add(
        {"crack_beside", "px", "of them, beside a crack"},
        [](auto& l) -> auto& { return l.cracks.n_beside; });
    lines.add(
        {"crack_found", "", "true cracks found"},
        [](auto& l) -> auto& { return l.cracks.all.n_found; });
    lines.add(
        {"crack_truth", "", "true cracks"}, [](auto& l) -> auto& { return l.cracks.all.n_truth; });
}

void add_offsets(RowTable& table, LineColumns& lines) {
    using L = LineScores;
    lines.add_derived({"offset_px",
                       "px",
                       "mean signed distance of thinned pixels from the nearest curve within 2 px; "
                       "positive to the empty side, else right or down"},
                      [](const L& l) { return l.offsets.all.mean(); });
    lines.add_derived({"offset_spread_px", "px", "standard deviation of that distance"},
                      [](const L& l) { return l.offsets.all.spread(); });
    lines.add_derived({"offset_rms_px", "px", "root mean square of that distance"},
                      [](const L& l) { return l.offsets.all.rms(); });
    lines.add(
        {"offset_n", "px", "thinned pixels near a curve"},
        [](auto& l) -> auto& { return l.offsets.all.n; });
    lines.add(
        {"offset_sum_px", "px", "sum of their signed distances"},
        [](auto& l) -> auto& { return l.offsets.all.sum; });
    lines.add(
        {"offset_sum_sq_px2", "px^2", "sum of their squares"},
        [](auto& l) -> auto& { return l.offsets.all.sum_of_squares; });
    add_shift(table,
              {"shift_x_px",
               "px",
               "translation to the right that explains the offsets best; thinned pixels, so that "
               "what thinning itself moves is part of it (of lines two pixels wide half a pixel)"},
              &score::Shift::x_px);
    add_shift(table, {"shift_y_px", "px", "the same, down"}, &score::Shift::y_px);
}

void add_widths(LineColumns& lines) {
    using L = LineScores;
    lines.add_derived({"width_along_px",
                       "px",
                       "mean width of what is drawn (unthinned), across the true curves, a probe "
                       "each px"},
                      [](const L& l) { return l.widths.all.mean(); });
    lines.add_derived({"width_spread_px", "px", "standard deviation of that width"},
                      [](const L& l) { return l.widths.all.spread(); });
    lines.add(
        {"width_n", "", "probes that met a line"}, [](auto& l) -> auto& { return l.widths.all.n; });
    lines.add(
        {"width_sum_px", "px", "sum of the widths that they met"},
        [](auto& l) -> auto& { return l.widths.all.sum; });
    lines.add(
        {"width_sum_sq_px2", "px^2", "sum of their squares"},
        [](auto& l) -> auto& { return l.widths.all.sum_of_squares; });
}

std::string text_of(const core::Provenance& from, std::size_t library) {
    return csv_field(from.libraries.at(library).second);
}

}  // namespace

void add_line_columns(RowTable& table) {
    LineColumns lines(table);
    lines.add(
        {"positive_px", "px", "drawn pixels (unthinned) that count"},
        [](auto& l) -> auto& { return l.positives.n_drawn; });
    lines.add(
        {"far_positive_px", "px", "of them, further than 2 px from every true one"},
        [](auto& l) -> auto& { return l.positives.n_false; });
    add_cracks(lines);
    add_offsets(table, lines);
    add_widths(lines);
}

void add_cause_columns(RowTable& table) {
    const auto add = [&table](Cause cause, std::string doc) {
        table.add(
            {fmt::format("{}_{}",
                         score::is_miss(cause) ? "false_negatives" : "false_positives",
                         name(cause)),
             "px",
             std::move(doc)},
            [cause](const RowRecord& r) {
                return r.row.causes ? csv_text((*r.row.causes)[cause]) : "";
            },
            [cause](const CsvField& field, RowRecord& r) {
                if (field.is_empty()) return;
                if (!r.row.causes) r.row.causes.emplace();
                field.read((*r.row.causes)[cause]);
            });
    };
    add(Cause::one_triangle, "of false_positives: one triangle fills the stencil");
    add(Cause::one_patch, "of false_positives: triangles of one smooth patch");
    add(Cause::crack, "of false_positives: a true line crosses the stencil, out of reach");
    add(Cause::frame, "of false_positives: the frame took the true line away");
    add(Cause::other, "of false_positives: several surfaces without a true line between");
    add(Cause::cancelled, "of false_negatives: a channel changed enough, the code did not");
    add(Cause::below_threshold, "of false_negatives: no channel changed enough");
    add(Cause::sub_pixel, "of false_negatives: no stencil of pixel centres sees the line");
    add(Cause::thinned, "of false_negatives: drawn, but thinning took it out of reach");
    add(Cause::unexplained, "of false_negatives: the declared code should have drawn it");
    add(Cause::undeclared, "of false_negatives: seen by a stencil, and no code is declared");
}

void add_skip_columns(RowTable& table) {
    // Not among `params`: like `threads` it says how the image was made and not which one, so
    // that two rows that differ in it alone must have one image_hash.
    table.add(
        {"skips_off",
         "",
         "skips that were not allowed, a;b; temporal_reuse never is where one view is drawn "
         "again and again"},
        [](auto& r) -> auto& { return r.row.skips_off; });
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        const auto skip = static_cast<std::size_t>(info.skip);
        const auto add = [&](std::string_view ending, auto count, std::string doc) {
            table.add(
                {fmt::format("skip_{}{}", info.name, ending),
                 std::string(info.unit),
                 std::move(doc)},
                [=](const RowRecord& r) {
                    return r.row.skips ? csv_text((*r.row.skips)[skip].*count) : "";
                },
                [=](const CsvField& field, RowRecord& r) {
                    if (field.is_empty()) return;
                    if (!r.row.skips) r.row.skips.emplace();
                    field.read((*r.row.skips)[skip].*count);
                });
        };
        add("", &raster::SkipCount::skipped, fmt::format("left out in a frame: {}", info.summary));
        add("_of", &raster::SkipCount::of, "how many there were; 0 where this does not apply");
    }
}

namespace {

/// A text of the provenance: its column, and where it stands.
struct Source {
    Column column;
    std::string core::Provenance::*text;
};

const std::vector<Source>& sources() {
    using P = core::Provenance;
    static const std::vector<Source> kSources = {
        {{"version", "", "of the program"}, &P::version},
        {{"commit", "", "that it was built from"}, &P::commit},
        {{"compiler", "", "name and version"}, &P::compiler},
        {{"flags", "", "build type and flags"}, &P::flags},
        {{"cpu", "", "model name"}, &P::cpu},
        {{"simd", "", "instruction set that the kernels ran on"}, &P::simd},
    };
    return kSources;
}

const core::Provenance& provenance_of(const RowRecord& r) {
    return r.row.provenance ? *r.row.provenance : core::provenance();
}

}  // namespace

void add_provenance_columns(RowTable& table) {
    for (const Source& source : sources()) {
        const auto text = source.text;
        table.add_derived(source.column,
                          [text](const RowRecord& r) { return provenance_of(r).*text; });
        if (source.column.name == "commit") {
            table.add_derived({"dirty", "", "true: the work tree differed from that commit"},
                              [](const RowRecord& r) { return provenance_of(r).dirty; });
        }
    }
    const auto& libraries = core::provenance().libraries;
    for (std::size_t i = 0; i < libraries.size(); ++i) {
        table.add(
            {libraries[i].first, "", "version of the library"},
            [i](const RowRecord& r) { return text_of(provenance_of(r), i); },
            [](const CsvField&, RowRecord&) {});
    }
}

std::shared_ptr<const core::Provenance> read_provenance(
    const CsvTable& table,
    std::size_t i,
    std::map<std::string, std::shared_ptr<const core::Provenance>>& known) {
    const std::size_t first = table.find(sources().front().column.name);
    std::string key;
    for (std::size_t column = first; column < table.columns.size(); ++column)
        key += table.records[i][column] + ",";
    const auto [found, is_new] = known.try_emplace(key);
    if (!is_new) return found->second;
    core::Provenance read = core::provenance();
    for (const Source& source : sources())
        CsvField(table, i, table.find(source.column.name)).read(read.*source.text);
    CsvField(table, i, table.find("dirty")).read(read.dirty);
    bool is_ours = read.dirty == core::provenance().dirty;
    for (const Source& source : sources())
        is_ours = is_ours && read.*source.text == core::provenance().*source.text;
    for (auto& [library, version] : read.libraries)
        CsvField(table, i, table.find(library)).read(version);
    is_ours = is_ours && read.libraries == core::provenance().libraries;
    if (!is_ours) found->second = std::make_shared<const core::Provenance>(std::move(read));
    return found->second;
}

}  // namespace ink::harness
