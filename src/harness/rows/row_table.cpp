#include "harness/rows/row_table.h"

#include <fmt/format.h>

#include <functional>

#include "core/vocabulary.h"
#include "score/intersections.h"

namespace ink::harness {
namespace {

/// What a column of a recall group means: `doc`, which speaks of "this class".
std::string group_doc(const core::Term& group, std::string doc) {
    constexpr std::string_view kClass = "this class";
    if (group.text.empty()) return doc;
    return doc.replace(doc.find(kClass), kClass.size(), group.text);
}

/// Adds a column per recall group, empty where the view has none of it. `add(found, column)` adds
/// what is written of a group; `with_parts` also for those that are a part of a class.
template <class T, class Add>
void add_by_class(RowTable& table,
                  std::map<std::string, T> Row::*field,
                  const core::Column& column,
                  Add add,
                  bool with_parts = true) {
    for (const core::Term& group : core::vocabulary().recall_groups) {
        if (!with_parts && !group.text.empty()) continue;
        const std::string key(group.name);
        const auto found = table.part(&RowRecord::row)
                               .part_if([=](const Row& row) { return (row.*field).contains(key); })
                               .part([=](Row & row) -> auto& { return (row.*field)[key]; });
        add(found, core::Column{column.name + key, column.unit, group_doc(group, column.doc)});
    }
}

/// F at 2 px with another choice of what counts, and its counts.
void add_choice(RowTable& table,
                const std::string& suffix,
                const std::string& doc,
                std::optional<score::CurveCount> Row::*field) {
    using C = score::CurveCount;
    const auto choice = table.part(&RowRecord::row).part(field);
    choice.add_derived({"f_2px_" + suffix, "0..1", "F within 2 px " + doc}, &C::f);
    choice.add({"k_2px_" + suffix, "px", "its matches"}, &C::k);
    choice.add({"n_pred_" + suffix, "px", "its drawn pixels that count"}, &C::n_pred);
    choice.add({"n_truth_" + suffix, "px", "its true pixels"}, &C::n_truth);
}

void add_place(RowTable& table) {
    table.add({"cell", "", "number of the cell; side tables name it by this"}, &RowRecord::cell);
    table.add({"study", "", "what it was measured for: compare, stress, motion, tune"},
              &RowRecord::study);
    const auto row = table.part(&RowRecord::row);
    row.add({"axis", "", "of a study: what grows, as in axes.csv; empty where nothing does"},
            &Row::axis);
    row.add({"value", "of axis", "where on the axis; of named values the number"}, &Row::value);
    row.add({"method", "", "method, or baseline: none, sampled, exact_corner, oracle"},
            &Row::method);
    row.add({"scene", "", "built-in scene, or stem of the model file"}, &Row::scene);
    row.add({"view", "", "name of the camera, the path or the place on an axis"}, &Row::view);
    row.add({"projection",
             "",
             "perspective or parallel; parallel views have one depth encoding: inverse, linear and "
             "log are the same"},
            &Row::projection);
    row.add({"split", "", "train, heldout or real"}, &Row::split);
    row.add({"scene_kind", "", "of thing that the scene is; empty where no list says it"},
            &Row::scene_kind);
    row.add({"width", "px", "of the image"}, &Row::width);
    row.add({"height", "px", "of the image"}, &Row::height);
    row.add({"threads", "", "the method might use"}, &Row::threads);
    row.add({"seed", "", "as given: of random images and of resampling scenes"}, &Row::seed);
    row.add({"params", "", "every parameter, key=value;key=value"}, &Row::params);
    row.add({"threshold", "", "edge response (1..255) from which a pixel counts as drawn"},
            &Row::threshold);
    row.add({"status", "", "ok, or why there are no metrics"}, &Row::status);
}

void add_scores(RowTable& table) {
    const auto row = table.part(&RowRecord::row);
    row.add({"f_2px", "0..1", "F of one-to-one matches within 2 px"}, &Row::f_2px);
    row.add({"f_1px", "0..1", "the same within 1 px"}, &Row::f_1px);
    row.add({"precision_2px", "0..1", "matched share of the drawn pixels"}, &Row::precision_2px);
    row.add({"recall_2px", "0..1", "matched share of the true pixels"}, &Row::recall_2px);
    add_by_class(table,
                 &Row::by_class,
                 {"recall_", "0..1", "recall of this class, by a matching of its own"},
                 [](const auto& found, auto column) {
                     found.add_derived(std::move(column), &score::CurveCount::f);
                 });
    row.add({"mean_width_px", "px", "drawn pixels per thinned pixel"}, &Row::mean_width_px);
    row.add({"ap", "0..1", "area under the precision envelope over 99 thresholds"}, &Row::ap);
    row.add({"prepare_ns", "ns", "once per topology", true}, &Row::prepare_ns);
    row.add({"draw_ns",
             "ns",
             "lower quartile of a frame's times, by `clock`: the one that ranks; of one thread, "
             "each as "
             "it would be at the machine's best speed, by the yardstick beside it",
             true},
            &Row::draw_ns);
    row.add({"bytes_per_px", "B/px", "of the method's buffers, depth included"},
            &Row::bytes_per_px);
    row.add({"image_hash", "", "of the edge responses; of a sequence, of all its images"},
            &Row::image_hash);
}

void add_counts(RowTable& table) {
    const auto row = table.part(&RowRecord::row);
    const auto scored = row.part_if(&Row::is_scored);
    scored.add({"truth_px", "px", "true pixels that count"}, &Row::truth_px);
    scored.add({"k_2px", "px", "matches within 2 px"}, &Row::k_2px);
    scored.add({"n_pred", "px", "drawn pixels after thinning"}, &Row::n_pred);
    scored.add({"n_truth", "px", "true pixels"}, &Row::n_truth);
    scored.add({"unmatched_duplicates", "px", "drawn pixels left over beside a matched line"},
               &Row::unmatched_duplicates);
    scored.add({"false_positives", "px", "drawn pixels with no true one in reach"},
               &Row::false_positives);
    scored.add({"unmatched_truth", "px", "true pixels left over beside a drawn line"},
               &Row::unmatched_truth);
    scored.add({"false_negatives", "px", "true pixels with no drawn one in reach"},
               &Row::false_negatives);
    row.add({"k_1px", "px", "matches within 1 px"}, &Row::k_1px);
    row.add({"n_pred_1px", "px", "drawn pixels after thinning, at 1 px"}, &Row::n_pred_1px);
    const auto random = row.part(&Row::random_baseline);
    using C = score::CurveCount;
    random.add_derived(
        {"f_random_2px", "0..1", "F of a random image of as many pixels, within 2 px"}, &C::f);
    random.add({"k_random_2px", "px", "its matches"}, &C::k);
    random.add({"n_pred_random", "px", "its drawn pixels that count"}, &C::n_pred);
    add_choice(
        table, "above_crease", "if flatter intersections are ignored", &Row::above_crease_2px);
    add_choice(
        table, "all_intersections", "if all intersections count", &Row::all_intersections_2px);
    add_choice(table, "with_crowded", "if crowded pixels count too", &Row::with_crowded_2px);
    add_by_class(table,
                 &Row::by_class,
                 {"k_", "px", "matches of this class within 2 px, of its own matching"},
                 [](const auto& found, auto column) { found.add(std::move(column), &C::k); });
    add_by_class(table,
                 &Row::by_class,
                 {"truth_px_", "px", "true pixels of this class"},
                 [](const auto& found, auto column) { found.add(std::move(column), &C::n_truth); });
}

void add_times(RowTable& table) {
    const auto row = table.part(&RowRecord::row);
    row.add({"pose_ns", "ns", "once after prepare, or when something moved", true}, &Row::pose_ns);
    row.add({"draw_ns_median", "ns", "median of a frame's times", true}, &Row::draw_ns_median);
    row.add({"draw_ns_q75", "ns", "upper quartile", true}, &Row::draw_ns_q75);
    row.add({"draw_ns_min", "ns", "least", true}, &Row::draw_ns_min);
    row.part_if([](const Row& r) { return r.draw_n != 0; })
        .add({"draw_n", "", "timed frames", true}, &Row::draw_n);
    row.add({"draw_wall_ns", "ns", "lower quartile of time on the wall", true}, &Row::draw_wall_ns);
    row.add({"draw_cpu_ns",
             "ns",
             "lower quartile of processor time: of the thread, of all threads, or of the program",
             true},
            &Row::draw_cpu_ns);
    row.add({"yardstick_ns",
             "ns",
             "least time of a fixed piece of work, timed between the drawings of the view: times "
             "of two "
             "runs compare as ratios to it",
             true},
            &Row::yardstick_ns);
    row.add({"time_doubt",
             "",
             "why the times are uncertain: waited (on the wall half as long again as the thread "
             "worked), spread (the median exceeds the least by half); empty if they are not",
             true},
            &Row::time_doubt);
    row.add({"clock",
             "",
             "that times are by: thread (processor time of the one thread), wall (of several "
             "threads), children (processor time of a program from outside and those it started), "
             "own (what a method from outside says); empty where nothing was drawn"},
            &Row::clock);
}

/// Adds a column per cause: what false_positives and false_negatives are made of.
void add_cause_columns(RowTable& table) {
    const auto causes = table.part(&RowRecord::row).part(&Row::causes);
    for (std::size_t i = 0; i < score::kCauseCount; ++i) {
        const auto cause = static_cast<score::Cause>(i);
        const char* of = score::is_miss(cause) ? "false_negatives" : "false_positives";
        const std::string_view text = core::vocabulary().causes[i].text;
        causes.add({fmt::format("{}_{}", of, name(cause)), "px", std::string(text)},
                   [cause](auto& counts) -> decltype(auto) { return counts[cause]; });
    }
}

void add_truth(RowTable& table) {
    const auto row = table.part(&RowRecord::row);
    const auto scored = row.part_if(&Row::is_scored);
    scored.add({"truth_merged_px", "px", "true pixels that thinning took away"},
               &Row::truth_merged_px);
    row.part_if([](const Row& r) { return r.is_scored() || r.crowded_share > 0; })
        .add({"crowded_share", "0..1", "share of true pixels too dense to score"},
             &Row::crowded_share);
    scored.add({"rounding_px", "px", "that rounding of coordinates may move a vertex in view by"},
               &Row::rounding_px);
    row.add({"reference_disagreement",
             "0..1",
             "share of the lines that only truth or only cross-check has, 0.25 px, per class, "
             "where a third construction sides against the truth"},
            &Row::reference_disagreement);
    const auto checked =
        row.part_if([](const Row& r) { return r.reference_disagreement.has_value(); });
    checked.add({"crosscheck_px", "px", "the length of line, both ways, of which that is a share"},
                &Row::crosscheck_px);
    checked.add({"crosscheck_abstained",
                 "0..1",
                 "share of that length on which the cross-check abstains: it differs from the "
                 "truth, and the third construction sides with the truth"},
                &Row::crosscheck_abstained);
    add_by_class(
        table,
        &Row::coincident_px_by_class,
        {"crosscheck_coincident_",
         "px",
         "of what it abstains on, lines of this class that lie on another line, which "
         "both have"},
        [](const auto& found, auto column) { found.add(std::move(column), std::identity()); },
        false);
    add_cause_columns(table);
    row.part_if([](const Row& r) { return r.triangles != 0; })
        .add({"triangles", "", "of the scene, instances counted"}, &Row::triangles);
    row.add({"crease_deg", "deg", "crease angle of the truth; a method's own is in params"},
            &Row::crease_deg);
    row.add_named(
        {"creases",
         "",
         "which edges of two faces are creases of the truth: those of the angle, or those that the "
         "model's file marks"},
        &Row::creases,
        {scene::kCreaseSourceNames.begin(), scene::kCreaseSourceNames.end()});
    row.add_named({"intersections",
                   "",
                   "which intersections count: all, or above_crease: those that bend at least by "
                   "the crease angle, flatter ones being ignored"},
                  &Row::intersections,
                  {score::kIntersectionNames.begin(), score::kIntersectionNames.end()});
    row.add({"weld_epsilon",
             "0..1",
             "the truth joins vertices this near, as a share of each part's diagonal"},
            &Row::weld_epsilon);
    row.add({"contour_sky_px", "px", "length of true contours before the sky"},
            &Row::contour_sky_px);
    row.add({"contour_other_px", "px", "the same before another object"}, &Row::contour_other_px);
    row.add({"contour_self_px", "px", "the same before their own object"}, &Row::contour_self_px);
}

/// A text of the provenance: its column, and where it stands.
struct Source {
    core::Column column;
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

/// Adds what was left undone: two columns per skip, and which skips were not allowed.
void add_skip_columns(RowTable& table) {
    const auto row = table.part(&RowRecord::row);
    // Not among `params`: like `threads` it says how the image was made and not which one, so
    // that two rows that differ in it alone must have one image_hash.
    row.add({"skips_off",
             "",
             "skips that were not allowed, a;b; temporal_reuse never is where one view is drawn "
             "again and again"},
            &Row::skips_off);
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        const auto count = row.part(&Row::skips).part([skip = info.skip](auto& of) -> auto& {
            return of[static_cast<std::size_t>(skip)];
        });
        const std::string name = fmt::format("skip_{}", info.name);
        const std::string unit(info.unit);
        count.add({name, unit, fmt::format("left out in a frame: {}", info.summary)},
                  &raster::SkipCount::skipped);
        count.add({name + "_of", unit, "how many there were; 0 where this does not apply"},
                  &raster::SkipCount::of);
    }
}

/// Adds what the row comes from: program, machine, libraries. read_provenance() reads them.
void add_provenance_columns(RowTable& table) {
    const auto row = table.part(&RowRecord::row);
    for (const Source& source : sources()) {
        const auto text = source.text;
        row.add_derived(source.column, [text](const Row& r) { return provenance_of(r).*text; });
        if (source.column.name == "commit") {
            row.add_derived({"dirty", "", "true: the work tree differed from that commit"},
                            [](const Row& r) { return provenance_of(r).dirty; });
        }
    }
    const auto& libraries = core::provenance().libraries;
    for (std::size_t i = 0; i < libraries.size(); ++i) {
        row.add_derived({libraries[i].first, "", "version of the library"},
                        [i](const Row& r) { return provenance_of(r).libraries.at(i).second; });
    }
}

/// The provenance that record `i` names, null if it is that of this program on this machine.
/// `known` keeps those that were read, so that rows of one source share it.
std::shared_ptr<const core::Provenance> read_provenance(
    const core::CsvTable& table,
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
        core::CsvField(table, i, table.find(source.column.name)).read(read.*source.text);
    core::CsvField(table, i, table.find("dirty")).read(read.dirty);
    bool is_ours = read.dirty == core::provenance().dirty;
    for (const Source& source : sources())
        is_ours = is_ours && read.*source.text == core::provenance().*source.text;
    for (auto& [library, version] : read.libraries)
        core::CsvField(table, i, table.find(library)).read(version);
    is_ours = is_ours && read.libraries == core::provenance().libraries;
    if (!is_ours) found->second = std::make_shared<const core::Provenance>(std::move(read));
    return found->second;
}

RowTable make_rows_table() {
    RowTable table("rows.csv",
                   "A line per cell: one method with its settings on one view, or on one "
                   "sequence or mesh of a study. It is complete in itself; the side tables add "
                   "to it and name it by `cell`. Fields are empty where nothing was measured.");
    add_place(table);
    add_scores(table);
    add_counts(table);
    add_times(table);
    add_truth(table);
    add_ink_columns(table.part(&RowRecord::row).part(&Row::soft));
    add_skip_columns(table);
    add_provenance_columns(table);
    return table;
}

}  // namespace

const RowTable& rows_table() {
    static const RowTable kTable = make_rows_table();
    return kTable;
}

std::string row_line(std::int64_t cell, const std::string& study, const Row& row) {
    return rows_table().line({cell, study, row});
}

std::vector<RowRecord> read_rows(const core::CsvTable& csv) {
    std::vector<RowRecord> records = rows_table().read(csv);
    std::map<std::string, std::shared_ptr<const core::Provenance>> known;
    std::map<std::int64_t, std::size_t> cells;
    for (std::size_t i = 0; i < records.size(); ++i) {
        Row& row = records[i].row;
        if (row.random_baseline) row.random_baseline->n_truth = row.n_truth;
        for (auto& [name, found] : row.by_class)
            found.n_pred = found.n_truth;
        row.cell = records[i].cell;
        row.provenance = read_provenance(csv, i, known);
        if (!cells.emplace(records[i].cell, i).second)
            core::CsvField(csv, i, csv.find("cell")).refuse("every cell once");
    }
    return records;
}

void add_ink_columns(const core::PartOf<score::SoftScore>& soft) {
    using S = score::SoftScore;
    soft.add_derived({"soft_f",
                      "0..1",
                      "of grey lines: 2 sum min(I, C) / sum (I + C), I the drawn share of a pixel "
                      "and C the true one; only with --coverage"},
                     &S::f);
    soft.add({"ink_line_width_px", "px", "of the true lines that C is the share of"},
             &S::line_width_px);
    soft.add({"ink_matched_px", "px^2", "drawn ink that is true: sum min(I, C)"}, &S::matched_px);
    soft.add({"ink_misplaced_px", "px^2", "drawn ink that is true up to 2 px beside"},
             &S::misplaced_px);
    soft.add({"ink_surplus_px", "px^2", "other drawn ink"}, &S::surplus_px);
    soft.add({"ink_missing_px", "px^2", "other true ink"}, &S::missing_px);
}

}  // namespace ink::harness
