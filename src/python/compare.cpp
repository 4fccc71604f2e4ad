#include "python/asked.h"

#include <fmt/format.h>

#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/split_list.h"
#include "core/tables/csv_table.h"
#include "core/work_clock.h"
#include "entrants/entrant.h"
#include "experiment/experiment_plan.h"
#include "harness/cells/cell.h"
#include "harness/rows/row_table.h"
#include "methods/method_configs.h"
#include "python/buffers.h"

namespace ink::python {

namespace py = pybind11;

namespace {

/// What a function threw. A method's failure is a row's status; a function's is the caller's.
using Thrown = std::shared_ptr<std::exception_ptr>;

/// Shared, so that nothing of Python is copied while others run.
using Function = std::shared_ptr<const py::function>;

harness::OutsideImage call(const Function& function,
                           const std::string& name,
                           const scene::View& view,
                           entrants::ViewBuffers&& buffers,
                           const std::string& view_json) {
    const py::gil_scoped_acquire python_runs;
    const py::object seen = py::cast(BufferArrays(std::move(buffers), view_json));
    py::object drawn;
    // On the wall: it may work on threads of its own, or on another device.
    const core::Spent spent = core::spent_on([&] { drawn = (*function)(seen); });
    harness::OutsideImage image{image_of(drawn, name), spent.wall_ns};
    if (image.image.width_px() != view.width_px || image.image.height_px() != view.height_px) {
        throw core::Error(
            name,
            fmt::format("its image is {}x{}", image.image.width_px(), image.image.height_px()),
            fmt::format("{}x{}, the size of the view", view.width_px, view.height_px));
    }
    return image;
}

/// A function as a method from outside. The time of a call is that of the method.
method::MethodConfig function_config(const std::string& name,
                                     const Function& function,
                                     double crease_rad,
                                     const Thrown& thrown) {
    return entrants::outside_config(name, "Python", "a function from outside", [=] {
        return [=](const scene::Scene& scene, const scene::View& view) {
            try {
                return call(function,
                            name,
                            view,
                            entrants::view_buffers(scene, view, crease_rad),
                            entrants::view_json(scene, view, {}));
            } catch (...) {
                *thrown = std::current_exception();
                throw;
            }
        };
    });
}

/// A field as its column has it: text, number, True or False, None.
py::object value_of(const core::Column& column, const core::CsvField& field) {
    if (field.is_empty()) return py::none();
    if (column.is_text) return py::str(field.text());
    return py::module_::import("json").attr("loads")(field.text());
}

py::list row_dicts(const std::string& lines) {
    const core::TableInfo& table = harness::rows_table();
    const core::CsvTable rows = core::split_csv(core::heading(table) + lines, table.file);
    py::list dicts;
    for (std::size_t i = 0; i < rows.records.size(); ++i) {
        py::dict dict;
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            dict[py::str(table.columns[c].name)] =
                value_of(table.columns[c], core::CsvField(rows, i, c));
        dicts.append(std::move(dict));
    }
    return dicts;
}

/// Lines of rows.csv, block after block; Ctrl-C is heard in between.
std::string run_blocks(const experiment::Experiment& experiment, const Thrown& thrown) {
    const experiment::Plan plan = [&] {
        const py::gil_scoped_release others_run;
        return experiment::make_plan(experiment, {});
    }();
    std::string lines;
    for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
        const experiment::Block& block = plan.blocks[i];
        experiment::BlockResult result = [&] {
            const py::gil_scoped_release others_run;
            return block.run();
        }();
        if (*thrown) std::rethrow_exception(*thrown);
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (!result.faults.empty()) throw core::Error(block.key, result.faults.front());
        lines += result.lines["rows.csv"];
        const bool is_last = i + 1 == plan.blocks.size();
        if (block.group && (is_last || plan.blocks[i + 1].group != block.group))
            plan.release(*block.group);
    }
    return lines;
}

}  // namespace

const Keywords& compare_keywords() {
    static const Keywords keywords = [] {
        Keywords of_compare{
            core::split_list("grid.scenes, grid.methods, grid.presets, grid.entrants, "
                             "grid.threads, measure.crease_deg, measure.creases, "
                             "measure.weld_epsilon, measure.intersections, measure.repetitions, "
                             "measure.budget_ms, measure.times, measure.crosscheck, "
                             "measure.full_scores, measure.skips_off, grid.antialias, "
                             "measure.coverage, measure.line_width_px, seed"),
            {},
            true};
        of_compare.usual.where = of_compare.usual.name = "compare";
        of_compare.usual.budget_ms = harness::MeasureOptions{}.budget_s * 1e3;  // as the command
        of_compare.usual.compare.images = experiment::KeptImages::none;
        return of_compare;
    }();
    return keywords;
}

py::list compare(const py::object& scenes,
                 const py::dict& functions,
                 const py::object& cameras,
                 const py::kwargs& given) {
    py::dict all = given;
    all["scenes"] = scenes;
    Asked asked = read_asked(compare_keywords(), cameras, all);
    if (!asked.view.empty()) {
        throw core::Error("cameras",
                          fmt::format("'{}' is no Camera", asked.view),
                          "a Camera, or a list of them; without any all views of the scenes");
    }
    experiment::Experiment& experiment = asked.experiment;
    const auto thrown = std::make_shared<std::exception_ptr>();
    const double crease_rad = experiment::trace_of(experiment, {}).truth.crease_rad;
    for (const auto& [name, function] : functions) {
        if (PyCallable_Check(function.ptr()) == 0) {
            throw core::Error(text_of(name),
                              fmt::format("'{}' is no function", text_of(function)),
                              "a function of Buffers that returns edge responses");
        }
        const auto shared =
            std::make_shared<const py::function>(py::reinterpret_borrow<py::function>(function));
        experiment.compare.own_methods.push_back(
            function_config(text_of(name), shared, crease_rad, thrown));
    }
    std::vector<method::MethodConfig> configs = experiment::configs_of(experiment);
    methods::apply_settings(experiment.settings, configs);  // which refuses what is not known
    return row_dicts(run_blocks(experiment, thrown));
}

}  // namespace ink::python
