#include "studies/roll_table.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "harness/tables/table_of.h"

namespace ink::studies {
namespace {

/// Angles are written with ten digits: a degree that is read and turned into radians and back
/// is then the same text.
std::string degrees_text(double angle_rad) {
    return fmt::format("{:.10g}", angle_rad * 180 / std::numbers::pi);
}

void read_degrees(const harness::CsvField& field, double& angle_rad) {
    angle_rad = field.as<double>() * std::numbers::pi / 180;
}

/// The columns that say of which crease of which cell a line is.
template <class Record>
void add_crease(harness::TableOf<Record>& table) {
    table.add(
        {"cell", "", "of rows.csv"}, [](auto& r) -> auto& { return r.cell; });
    table.add(
        {"crease", "", "0, 1, 2: by the number of its edge"},
        [](auto& r) -> auto& { return r.crease; });
}

struct SampleRecord {
    std::int64_t cell = 0;
    int crease = 0;
    bool is_predicted = false;
    RollSample sample;
};

const harness::TableOf<SampleRecord>& samples() {
    static const harness::TableOf<SampleRecord> kTable = [] {
        harness::TableOf<SampleRecord> table(
            "roll.csv",
            "A line per cell of study `roll`, crease and angle: how a method draws a crease of a "
            "cube while the camera rolls once round.");
        add_crease(table);
        table.add(
            {"roll_deg", "deg", "by which the camera is rolled"},
            [](const SampleRecord& r) { return degrees_text(r.sample.roll_rad); },
            [](const harness::CsvField& f, SampleRecord& r) {
                read_degrees(f, r.sample.roll_rad);
            });
        table.add(
            {"length_px", "px", "of the crease that is visible"},
            [](auto& r) -> auto& { return r.sample.length_px; });
        table.add(
            {"covered_px", "px", "of that, with a drawn pixel within 2 px"},
            [](auto& r) -> auto& { return r.sample.covered_px; });
        table.add(
            {"predicted_step",
             "codes",
             "of the code across the crease; empty for a method that declares none"},
            [](const SampleRecord& r) {
                return r.is_predicted ? harness::csv_text(r.sample.step) : "";
            },
            [](const harness::CsvField& f, SampleRecord& r) {
                r.is_predicted = !f.is_empty();
                if (r.is_predicted) f.read(r.sample.step);
            });
        table.add(
            {"predicted_blind", "", "true: the code cannot show it, as predicted"},
            [](const SampleRecord& r) {
                return r.is_predicted ? harness::csv_text(r.sample.is_blind) : "";
            },
            [](const harness::CsvField& f, SampleRecord& r) {
                if (!f.is_empty()) f.read(r.sample.is_blind);
            });
        return table;
    }();
    return kTable;
}

struct VanishingRecord {
    std::int64_t cell = 0;
    int crease = 0;
    Vanishing at;
};

/// From prediction to measurement the short way, by the angles as they are written.
std::string error_text(const Vanishing& at) {
    if (!at.measured_rad) return "";
    const double turn_deg =
        std::stod(degrees_text(*at.measured_rad)) - std::stod(degrees_text(at.predicted_rad));
    return fmt::format("{:.3g}", std::remainder(turn_deg, 360.0));
}

const harness::TableOf<VanishingRecord>& vanishings() {
    static const harness::TableOf<VanishingRecord> kTable = [] {
        harness::TableOf<VanishingRecord> table(
            "vanishing.csv",
            "A line per cell of study `roll`, crease and angle at which a code has no step across "
            "it: where the crease was lost.");
        add_crease(table);
        table.add(
            {"predicted_deg", "deg", "the angle without a step"},
            [](const VanishingRecord& r) { return degrees_text(r.at.predicted_rad); },
            [](const harness::CsvField& f, VanishingRecord& r) {
                read_degrees(f, r.at.predicted_rad);
            });
        table.add(
            {"measured_deg",
             "deg",
             "middle of the angles near it at which less than half was drawn"},
            [](const VanishingRecord& r) {
                return r.at.measured_rad ? degrees_text(*r.at.measured_rad) : "";
            },
            [](const harness::CsvField& f, VanishingRecord& r) {
                if (!f.is_empty()) read_degrees(f, r.at.measured_rad.emplace());
            });
        table.add(
            {"error_deg", "deg", "measured less predicted, the short way round"},
            [](const VanishingRecord& r) { return error_text(r.at); },
            [](const harness::CsvField&, VanishingRecord&) {});
        table.add(
            {"recall_there", "0..1", "share of the crease drawn at exactly this angle"},
            [](auto& r) -> auto& { return r.at.recall_there; });
        return table;
    }();
    return kTable;
}

}  // namespace

harness::Row roll_row(const RollCurve& curve, const RollOptions& options) {
    harness::Row row;
    row.method = curve.method;
    row.scene = "cube_roll";
    row.view = "roll";
    row.width = options.size_px;
    row.height = options.size_px;
    row.threads = options.measure.threads;
    row.params = curve.params;
    row.status = curve.status;
    row.triangles = 12;
    return row;
}

const harness::TableInfo& roll_table() {
    return samples().info();
}

std::string roll_lines(std::int64_t cell, const RollCurve& curve) {
    std::string lines;
    for (const RollSample& sample : curve.samples)
        lines += samples().line({cell, curve.crease, curve.is_predicted, sample});
    return lines;
}

const harness::TableInfo& vanishing_table() {
    return vanishings().info();
}

std::string vanishing_lines(std::int64_t cell, const RollCurve& curve) {
    std::string lines;
    for (const Vanishing& at : curve.vanishing)
        lines += vanishings().line({cell, curve.crease, at});
    return lines;
}

std::vector<RollCurve> read_rolls(const harness::CsvTable& roll,
                                  const harness::CsvTable& vanishing,
                                  const harness::RowIndex& rows) {
    std::vector<RollCurve> curves;
    std::map<std::pair<std::int64_t, int>, std::size_t> index;
    const std::vector<SampleRecord> read = samples().read(roll);
    for (std::size_t i = 0; i < read.size(); ++i) {
        const auto [at, is_new] = index.try_emplace({read[i].cell, read[i].crease}, curves.size());
        if (is_new) {
            const harness::Row& row = rows.find(harness::CsvField(roll, i, 0)).row;
            curves.push_back({.method = row.method,
                              .params = row.params,
                              .status = row.status,
                              .crease = read[i].crease,
                              .is_predicted = read[i].is_predicted});
        }
        RollCurve& curve = curves[at->second];
        if (curve.is_predicted != read[i].is_predicted)
            harness::CsvField(roll, i, 5).refuse("a prediction at every angle or at none");
        curve.samples.push_back(read[i].sample);
    }
    const std::vector<VanishingRecord> lost = vanishings().read(vanishing);
    for (std::size_t i = 0; i < lost.size(); ++i) {
        const auto found = index.find({lost[i].cell, lost[i].crease});
        if (found == index.end())
            harness::CsvField(vanishing, i, 0).refuse("a cell and crease of roll.csv");
        curves[found->second].vanishing.push_back(lost[i].at);
    }
    return curves;
}

}  // namespace ink::studies
