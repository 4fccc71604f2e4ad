#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/error.h"
#include "studies/stress/stress_axis_maker.h"

namespace ink::studies {
namespace {

std::vector<double> decades(int low, int high) {
    std::vector<double> values;
    for (int exponent = low; exponent <= high; ++exponent)
        values.push_back(std::pow(10, exponent));
    return values;
}

std::vector<double> powers_of_two(int low, int high, int step) {
    std::vector<double> values;
    for (int exponent = low; exponent <= high; exponent += step)
        values.push_back(std::ldexp(1, exponent));
    return values;
}

void add_places(std::vector<Axis>& axes) {
    axes.push_back(make_axis(
        {"near_far", "far distance over near distance"},
        decades(1, 9),
        "The camera's near plane moves towards the eye while far stays behind the scene; a small "
        "pyramid is 2.5 near distances before the eye, so that the range is used, and depth is "
        "scaled to near and far (depth_range = camera).",
        near_far_cases));
    axes.push_back(make_axis(
        {"grazing", "angle at which the view direction meets a floor", "deg"},
        {0.1, 0.2, 0.5, 1, 2, 5, 10, 20},
        "A flat floor fills the frame of a long lens (0.2 degrees, 1000 units away); things stand "
        "on it. The eye sinks; below 0.2 degrees the floor's far end comes into the image.",
        grazing_cases));
    axes.push_back(make_axis(
        {"grazing_linear", "angle at which the view direction meets a floor", "deg"},
        {0.1, 0.2, 0.5, 1, 2, 5, 10, 20},
        "The same floor, but depth is written as distance itself (depth_encoding = linear) and "
        "nothing guards against slopes (guard = none), for methods that have these parameters.",
        grazing_linear_cases));
    axes.push_back(
        make_axis({"origin", "distance of scene and camera from the origin", "units"},
                  decades(0, 8),
                  "Scene and camera move together away from the origin, by transforms in double.",
                  origin_cases));
    axes.push_back(
        make_axis({"fp32", "distance of scene and camera from the origin", "units"},
                  decades(0, 8),
                  "As the axis before, but methods are given world positions rounded to floats, as "
                  "in a renderer that works in fp32 throughout; the truth is of the exact scene.",
                  fp32_cases));
    axes.push_back(
        make_axis({"scale", "size of the model over its own"},
                  powers_of_two(-30, 30, 6),
                  "Scene, camera, near and far grow together by powers of two, 9e-10 to 1e9.",
                  scale_cases));
    axes.push_back(make_axis({"zoom", "magnification"},
                             powers_of_two(-5, 6, 1),
                             "The focal length grows, aimed at the vertex nearest the eye: from a "
                             "scene of a few pixels to one of its corners.",
                             zoom_cases));
    axes.push_back(make_axis({"cube_roll", "roll of the camera", "deg", AxisScale::linear},
                             evenly(0, 350, 10),
                             "The camera turns about its view direction before a cube, a wedge and "
                             "a solid of twenty faces.",
                             roll_cases));
}

void add_shapes(std::vector<Axis>& axes) {
    axes.push_back(make_axis(
        {"gap", "distance between surfaces", "units"},
        {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1},
        "Coplanar things come apart by a gap: a sheet above another, slits between tiles, a step "
        "between two boxes, the thickness of a plate; each about 2 units wide, 5 units away.",
        gap_cases));
    axes.push_back(make_axis(
        {"sliver", "length over width of the thinnest triangles"},
        decades(0, 7),
        "A cube cut by thin strips, a ring each of whose triangles has one sliver, and free "
        "needles.",
        sliver_cases));
    axes.push_back(make_axis(
        {"facets", "triangles"},
        {8, 32, 128, 512, 2048, 8192, 32768, 131072, 1048576},
        "A ball, a ring and a rolling sheet from a handful of triangles to a million, far below a "
        "pixel.",
        facet_cases));
}

std::vector<Axis> make_axes() {
    std::vector<Axis> axes;
    add_places(axes);
    add_shapes(axes);
    add_parameter_axes(axes);
    add_defect_axes(axes);
    return axes;
}

}  // namespace

Axis make_axis(StressHeading heading,
               std::vector<double> values,
               std::string sentence,
               StressMaker make) {
    Axis axis;
    axis.name = std::move(heading.name);
    axis.title = std::move(heading.title);
    axis.unit = std::move(heading.unit);
    axis.scale = heading.scale;
    axis.values = std::move(values);
    axis.sentence = std::move(sentence);
    axis.is_crosschecked = false;
    axis.scores_crowded = true;
    axis.counts_faults = true;
    axis.cases = [name = axis.name, make](double value, const CaseSize& size) {
        return make({name, value, size});
    };
    return axis;
}

std::vector<double> evenly(double low, double high, double step) {
    std::vector<double> values;
    for (int i = 0; low + i * step <= high; ++i)
        values.push_back(low + i * step);
    return values;
}

const Axis& find_stress_axis(const std::string& name) {
    std::vector<std::string> names;
    for (const Axis& axis : stress_axes()) {
        if (axis.name == name) return axis;
        names.push_back(axis.name);
    }
    throw core::Error(
        "--axes", fmt::format("there is no axis '{}'", name), core::known_names(names, name));
}

const std::vector<Axis>& stress_axes() {
    static const std::vector<Axis> axes = make_axes();
    return axes;
}

}  // namespace ink::studies
