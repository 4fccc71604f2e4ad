#include <fmt/format.h>

#include "core/error.h"
#include "shade/shading.h"

namespace ink::shade {
namespace {

/// The rows of ToneParams for a struct that derives from it.
template <class P>
core::ParamTable<P> tone_table() {
    core::ParamTable<P> table;
    table
        .choice(&P::by,
                "by",
                {"vertex", "face", "patch"},
                "What has one tone: nothing (found at vertices, interpolated), each triangle, or "
                "each flat patch.")
        .choice(&P::normals,
                "normals",
                {"file", "patch", "facet"},
                "The file's normals, per corner over its smooth patch, or one per triangle.")
        .number(&P::crease_deg,
                "crease_deg",
                {0, 180},
                "deg",
                "Least dihedral deviation of an edge between two smooth patches.")
        .number(&P::ambient, "ambient", {0, 1}, "", "Light that arrives everywhere.")
        .number(&P::splash_alpha,
                "splash_alpha",
                {0, 1},
                "",
                "Splashback: the part of (alpha |cos t| + 1 - alpha)^p that the angle t between "
                "light and normal has; 0 is none.")
        .number(&P::splash_power, "splash_power", {0, 64}, "", "Splashback: p, a whole number.");
    return table;
}

core::ParamTable<ToonParams> toon_table() {
    auto table = tone_table<ToonParams>();
    return table
        .number(&ToonParams::steps, "steps", {1, 32}, "", "Levels in the table of 32 entries.")
        .number(&ToonParams::dark, "dark", {0, 1}, "", "The lowest level; the highest is 1.");
}

core::ParamTable<GoochParams> gooch_table() {
    auto table = tone_table<GoochParams>();
    return table
        .choice(&GoochParams::lit,
                "lit",
                {"cool", "warm"},
                "Colour of the lit side: cool as the formula is printed, warm as in the paper's "
                "pictures.")
        .number(&GoochParams::blue, "blue", {0, 1}, "", "Blue in the cool colour.")
        .number(&GoochParams::yellow, "yellow", {0, 1}, "", "Yellow in the warm colour.")
        .number(&GoochParams::cool_share,
                "cool_share",
                {0, 1},
                "",
                "The surface's part in the cool colour (the paper's alpha).")
        .number(&GoochParams::warm_share,
                "warm_share",
                {0, 1},
                "",
                "The surface's part in the warm colour (the paper's beta).");
}

core::ParamTable<StrokeParams> stroke_table() {
    auto table = tone_table<StrokeParams>();
    return table
        .number(&StrokeParams::single_from,
                "single_from",
                {0, 1},
                "",
                "Darkness (1 - brightness) at which strokes begin.")
        .number(&StrokeParams::crossed_from,
                "crossed_from",
                {0, 1},
                "",
                "Darkness at which strokes across them begin; at least single_from.")
        .number(
            &StrokeParams::spacing_px, "spacing_px", {2, 64}, "px", "From one stroke to the next.");
}

template <class P>
ShadingInfo shading_info(std::string name,
                         std::string source,
                         std::string summary,
                         const core::ParamTable<P>& table) {
    return {name, std::move(source), std::move(summary), table.params(), [name, table](auto& v) {
                return Style{table.read(v, name)};
            }};
}

ShadingInfo strokes() {
    ShadingInfo info = shading_info("strokes",
                                    "CoRgi",
                                    "pen strokes where it is dark, crossed where it is darker",
                                    stroke_table());
    info.make = [make = info.make](const core::ParamValues& values) {
        const Style style = make(values);
        const auto& params = std::get<StrokeParams>(style);
        if (params.crossed_from < params.single_from) {
            throw core::Error("strokes",
                              fmt::format("parameter crossed_from cannot be {}: single strokes "
                                          "begin at {}",
                                          params.crossed_from,
                                          params.single_from),
                              "a number of at least single_from");
        }
        return style;
    };
    return info;
}

std::vector<ShadingInfo> make_list() {
    return {
        shading_info("gouraud",
                     "Gouraud 1971; MOTE's omni lights with ranges",
                     "the lamps' light by Lambert's law, each lamp ending at its range",
                     tone_table<GouraudParams>()),
        shading_info("toon", "CoRgi", "levels of grey from a table of 32 entries", toon_table()),
        shading_info("gooch",
                     "Gooch et al. 1998; TechnicalQuake",
                     "cool to warm by the angle to the light",
                     gooch_table()),
        strokes()};
}

}  // namespace

const std::vector<ShadingInfo>& shadings() {
    static const std::vector<ShadingInfo> list = make_list();
    return list;
}

const ShadingInfo& find_shading(const std::string& name) {
    std::vector<std::string> names = {"none"};
    for (const ShadingInfo& info : shadings()) {
        if (info.name == name) return info;
        names.push_back(info.name);
    }
    throw core::Error(
        "--shading", fmt::format("there is no shading '{}'", name), core::known_names(names, name));
}

}  // namespace ink::shade
