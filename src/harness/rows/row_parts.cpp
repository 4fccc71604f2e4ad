#include "harness/rows/row_parts.h"

#include <fmt/format.h>

#include "core/vocabulary.h"

namespace ink::harness {

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

namespace {

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

}  // namespace

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

}  // namespace ink::harness
