#include "summary/cost_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>

#include "core/tables/csv_table.h"

namespace ink::summary {
namespace {

enum Unit { vertex, vertex_value, triangle, interpolant, covered_pixel, pixel, byte };

constexpr int kMaxSweeps = 200'000;
constexpr double kSettled = 1e-12;  // change of every share in one sweep, of the largest

/// Normal equations of the relative residuals, every column scaled to length 1: units differ by
/// twelve powers of ten, and descent by coordinates would crawl.
struct Normal {
    std::array<PerUnit, kCostUnits> matrix{};
    PerUnit right{};
    PerUnit scale{};
};

Normal normal_equations(std::span<const CostSample> samples) {
    Normal normal;
    for (const CostSample& sample : samples) {
        assert(sample.measured_ns > 0);
        for (std::size_t i = 0; i < kCostUnits; ++i) {
            const double share = sample.counts[i] / sample.measured_ns;
            normal.scale[i] += share * share;
        }
    }
    for (double& scale : normal.scale)
        scale = scale > 0 ? 1 / std::sqrt(scale) : 0;
    for (const CostSample& sample : samples) {
        PerUnit shares;
        for (std::size_t i = 0; i < kCostUnits; ++i)
            shares[i] = sample.counts[i] / sample.measured_ns * normal.scale[i];
        for (std::size_t i = 0; i < kCostUnits; ++i) {
            normal.right[i] += shares[i];
            for (std::size_t j = 0; j < kCostUnits; ++j)
                normal.matrix[i][j] += shares[i] * shares[j];
        }
    }
    return normal;
}

/// Whether a row tells what a frame costs.
bool is_sample(const harness::Row& row) {
    return row.cost && row.cost->declared.is_declared() && row.draw_ns_min && *row.draw_ns_min > 0;
}

/// The part of a run that a row is predicted without.
using Fold = std::string;

struct Cell {
    const harness::Row* row = nullptr;
    Fold fold;
    CostSample sample;
};

struct Cells {
    std::vector<Cell> all;
    std::string_view left_out;
};

Cells cells_of(const std::vector<harness::Row>& rows, const std::vector<harness::Row>& sweep) {
    std::vector<Cell> cells;
    std::set<std::string> scenes;
    for (const std::vector<harness::Row>* part : {&rows, &sweep}) {
        for (const harness::Row& row : *part) {
            if (!is_sample(row)) continue;
            cells.push_back(
                {&row, "", {unit_counts(*row.cost), static_cast<double>(*row.draw_ns_min)}});
            scenes.insert(row.scene);
        }
    }
    const bool by_scene = scenes.size() > 1;
    for (Cell& cell : cells)
        cell.fold = by_scene ? cell.row->scene : cell.row->view;
    return {std::move(cells), by_scene ? "scene" : "view"};
}

std::vector<CostSample> samples_without(const std::vector<Cell>& cells, const Fold& fold) {
    std::vector<CostSample> samples;
    for (const Cell& cell : cells) {
        if (cell.fold != fold) samples.push_back(cell.sample);
    }
    return samples;
}

}  // namespace

const std::array<CostUnit, kCostUnits>& cost_units() {
    static constexpr std::array<CostUnit, kCostUnits> kUnits = {{
        {"vertex", "a vertex put into clip space, its normal turned"},
        {"vertex value", "a number computed at a vertex"},
        {"triangle", "a triangle set up and binned, depth with it"},
        {"interpolant", "a further plane set up for a triangle"},
        {"covered pixel", "a pixel that a triangle covers, seen or not"},
        {"pixel", "a pixel of the frame, empty or not"},
        {"byte", "a byte of a buffer or the image, cleared, read or written"},
    }};
    return kUnits;
}

PerUnit unit_counts(const harness::CostFacts& facts) {
    const method::Cost& c = facts.declared;
    const harness::FrameCounts& f = facts.frame;
    const double vertices = c.shares_vertices ? f.vertices : 3 * f.triangles;
    const double filter_bytes = c.buffer_bytes_per_px + c.filter.read + c.filter.written;
    PerUnit counts{};
    counts[vertex] = vertices;
    counts[vertex_value] = vertices * c.values_per_vertex;
    counts[triangle] = f.triangles;
    counts[interpolant] = f.triangles * c.interpolants;
    counts[covered_pixel] = f.covered_px;
    counts[pixel] = f.frame_px;
    counts[byte] = f.covered_px * (c.fill.read + c.fill.written) + f.frame_px * filter_bytes;
    for (double& count : counts)
        count *= c.passes;
    return counts;
}

double predict_ns(const PerUnit& ns_per_unit, const PerUnit& counts) {
    double ns = 0;
    for (std::size_t i = 0; i < kCostUnits; ++i)
        ns += ns_per_unit[i] * counts[i];
    return ns;
}

PerUnit fit_unit_costs(std::span<const CostSample> samples) {
    const Normal normal = normal_equations(samples);
    PerUnit x{};
    PerUnit gradient{};
    for (std::size_t i = 0; i < kCostUnits; ++i)
        gradient[i] = -normal.right[i];
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
        double change = 0;
        for (std::size_t i = 0; i < kCostUnits; ++i) {
            if (normal.scale[i] == 0) continue;
            const double next = std::max(0.0, x[i] - gradient[i] / normal.matrix[i][i]);
            const double step = next - x[i];
            x[i] = next;
            for (std::size_t j = 0; j < kCostUnits; ++j)
                gradient[j] += step * normal.matrix[i][j];
            change = std::max(change, std::abs(step));
        }
        if (change <= kSettled * *std::max_element(x.begin(), x.end())) break;
    }
    for (std::size_t i = 0; i < kCostUnits; ++i)
        x[i] *= normal.scale[i];
    return x;
}

CostFit predict_costs(const std::vector<harness::Row>& rows,
                      const std::vector<harness::Row>& sweep) {
    const auto [cells, left_out] = cells_of(rows, sweep);
    std::map<Fold, PerUnit> prices;
    for (const Cell& cell : cells) {
        if (prices.count(cell.fold) != 0) continue;
        const std::vector<CostSample> others = samples_without(cells, cell.fold);
        if (others.size() >= kCostUnits) prices[cell.fold] = fit_unit_costs(others);
    }
    CostFit fit;
    for (const Cell& cell : cells) {
        const auto found = prices.find(cell.fold);
        if (found == prices.end()) continue;
        const double predicted_ns = predict_ns(found->second, cell.sample.counts);
        if (!(predicted_ns > 0)) continue;
        fit.predictions.push_back({cell.row->cell,
                                   cell.row->setting,
                                   std::llround(predicted_ns),
                                   cell.sample.measured_ns / predicted_ns - 1});
    }
    if (fit.predictions.empty()) return {};
    fit.cells = cells.size();
    fit.left_out = left_out;
    std::vector<CostSample> all;
    for (const Cell& cell : cells)
        all.push_back(cell.sample);
    fit.ns_per_unit = fit_unit_costs(all);
    return fit;
}

const core::TableInfo& cost_fit_table() {
    static const core::TableInfo table{
        "cost_fit.csv",
        "A line per kind of work: the price that the cost model found for one of it, the same for "
        "all methods.",
        {{"unit", "", "the kind of work"},
         {"ns_per_unit", "ns", "what one costs, fitted to all timed cells", true},
         {"doc", "", "what one of it is"},
         {"cells", "", "timed cells that the prices were fitted to", true},
         {"left_out", "", "scene or view: each prediction is from a fit without its own"}}};
    return table;
}

std::string cost_fit_csv(const CostFit& fit) {
    std::string text = core::heading(cost_fit_table());
    for (std::size_t i = 0; i < kCostUnits; ++i) {
        text += fmt::format("{},{},{},{},{}\n",
                            cost_units()[i].name,
                            fit.ns_per_unit[i],
                            core::csv_field(std::string(cost_units()[i].doc)),
                            fit.cells,
                            fit.left_out);
    }
    return text;
}

const core::TableOf<CostPrediction>& predictions_table() {
    static const auto kTable = [] {
        using P = CostPrediction;
        core::TableOf<P> table(
            "predictions.csv",
            "A line per cell of a method, and per setting of sweep.csv, whose time the cost model "
            "predicts from what cost.csv (or sweep.csv) has of it.");
        table.add_derived({"cell", "", "of rows.csv"}, &P::cell);
        table.part_if([](const P& of) { return of.setting != 0; })
            .add_derived({"setting", "", "as in sweep.csv; empty for the method's own"},
                         &P::setting);
        table.add_derived({"predicted_ns",
                           "ns",
                           "draw_ns_min by the cost model, fitted without this scene (or view)",
                           true},
                          &P::predicted_ns);
        table.add_derived({"cost_residual", "", "draw_ns_min over that, less 1", true},
                          &P::residual);
        return table;
    }();
    return kTable;
}

}  // namespace ink::summary
