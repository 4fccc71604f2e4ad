#include "cli/listing.h"

#include <fmt/format.h>

#include <algorithm>

#include "catalogue/catalogue.h"
#include "cli/shader_counts.h"
#include "core/error.h"
#include "core/param.h"
#include "experiment/dictionary.h"
#include "harness/rows/row_table.h"
#include "methods/registry.h"
#include "raster/skips.h"
#include "shade/shading.h"
#include "studies/stress/stress_axes.h"

namespace ink::cli {
namespace {

/// What a method or a shading is, and who described it.
std::string name_lines(const auto& info) {
    return fmt::format(
        "  {:<10} {}\n  {:<10} source: {}\n", info.name, info.summary, "", info.source);
}

std::string list_methods() {
    std::string text = "methods (inkbench compare --methods a,b)\n";
    for (const method::MethodInfo& info : methods::registry()) {
        text += name_lines(info);
        text +=
            fmt::format("  {:<10} cost: {}\n", "", method::cost_sentence(info.make({})->cost()));
        const std::string shader = shader_text(info.name);
        if (!shader.empty()) text += fmt::format("  {:<10} shader: {}\n", "", shader);
    }
    return text;
}

std::string list_scenes() {
    std::string text = "scenes (inkbench compare --scenes a,b)\n";
    for (const catalogue::CatalogueEntry& entry : catalogue::catalogue()) {
        const scene::Scene made = entry.make();
        text += fmt::format("  {:<16} {:<8} {:<12} {:>6} triangles, {} views  {}\n",
                            entry.name,
                            scene::split_name(entry.split),
                            entry.kind,
                            scene::triangle_count(made),
                            made.cameras.size(),
                            entry.summary);
    }
    return text;
}

std::string list_parameters(const std::string& owner, const std::vector<core::Param>& params) {
    std::string text = fmt::format("  {}\n", owner);
    for (const core::Param& param : params) {
        text += fmt::format("    {:<16} {:<10} {}{}{}  {}\n",
                            param.name,
                            core::format_param(param, param.default_value),
                            core::accepted_values(param),
                            param.unit.empty() ? "" : ", ",
                            param.unit,
                            param.doc);
    }
    return text;
}

std::string list_params() {
    std::string text = "parameters (--set key=value, or --set method.key=value)\n";
    for (const method::MethodInfo& info : methods::registry())
        text += list_parameters(info.name, info.params);
    return text;
}

std::string list_shadings() {
    std::string text = "shadings (inkbench draw --shading NAME --set-shade key=value)\n";
    for (const shade::ShadingInfo& info : shade::shadings()) {
        text += name_lines(info);
        text += list_parameters("parameters of " + info.name, info.params);
    }
    return text;
}

std::string list_metrics() {
    std::string text = "columns of rows.csv\n";
    for (const core::Column& column : harness::rows_table().info().columns)
        text += fmt::format("  {:<22} {:<10} {}\n", column.name, column.unit, column.doc);
    return text;
}

std::string list_skips() {
    std::string text = "skips (--no-skip a,b or all; the image is the same)\n";
    for (const raster::SkipInfo& info : raster::skip_infos())
        text += fmt::format("  {:<18} {:<10} {}\n", info.name, info.unit, info.summary);
    return text;
}

std::string list_axes() {
    std::string text = "axes of difficulty (inkbench stress --axes a,b)\n";
    for (const studies::Axis& axis : studies::stress_axes()) {
        text += fmt::format("  {:<14} {}: {} .. {}, {} points\n  {:<14} {}\n",
                            axis.name,
                            axis.title,
                            studies::format_value(axis, axis.values.front()),
                            studies::format_value(axis, axis.values.back()),
                            axis.values.size(),
                            "",
                            axis.sentence);
    }
    return text;
}

}  // namespace

std::string listing(const std::string& what) {
    std::string text;
    if (what == "all" || what == "methods") text += list_methods();
    if (what == "all" || what == "scenes") text += list_scenes();
    if (what == "all" || what == "params") text += list_params();
    if (what == "all" || what == "metrics") text += list_metrics();
    if (what == "columns") text += experiment::dictionary_text();
    if (what == "all" || what == "skips") text += list_skips();
    if (what == "all" || what == "shadings") text += list_shadings();
    if (what == "all" || what == "axes") text += list_axes();
    return text;
}

}  // namespace ink::cli
