#include <cmath>
#include <utility>

#include "lab/stress_axes.h"
#include "lab/stress_cases.h"

namespace ink::lab {
namespace {

using Maker = std::vector<StressCase> (*)(const StressPoint&);

/// What an axis is called and what its values are.
struct Heading {
    std::string name;
    std::string title;
    std::string unit = "";
    AxisScale scale = AxisScale::log;
};

/// What is varied, and why it matters.
struct Words {
    std::string sentence;
    std::string reason;
};

StressAxis make_axis(Heading heading, std::vector<double> values, Words words, Maker make) {
    StressAxis axis;
    axis.name = std::move(heading.name);
    axis.title = std::move(heading.title);
    axis.unit = std::move(heading.unit);
    axis.scale = heading.scale;
    axis.values = std::move(values);
    axis.sentence = std::move(words.sentence);
    axis.reason = std::move(words.reason);
    axis.cases = [name = axis.name, make](double value, const StressSize& size) {
        return make({name, value, size});
    };
    return axis;
}

std::vector<double> decades(int low, int high) {
    std::vector<double> values;
    for (int exponent = low; exponent <= high; ++exponent)
        values.push_back(std::pow(10, exponent));
    return values;
}

std::vector<double> steps(double low, double high, double step) {
    std::vector<double> values;
    for (int i = 0; low + i * step <= high; ++i)
        values.push_back(low + i * step);
    return values;
}

std::vector<double> powers_of_two(int low, int high, int step) {
    std::vector<double> values;
    for (int exponent = low; exponent <= high; exponent += step)
        values.push_back(std::ldexp(1, exponent));
    return values;
}

std::vector<double> shares() {
    return {0, 1, 2, 5, 10, 20, 40, 70, 100};
}

void add_places(std::vector<StressAxis>& axes) {
    axes.push_back(make_axis(
        {"near_far", "far distance over near distance"},
        decades(1, 9),
        {"The camera's near plane moves towards the eye while far stays behind the scene; a small "
         "pyramid stands 2.5 near distances before the eye, so that the range is used, and depth "
         "is scaled to near and far (depth_range = camera).",
         "What is scaled to near and far loses the scene behind: 1/w of everything that is not "
         "close is nearly 0."},
        near_far_cases));
    axes.push_back(make_axis(
        {"grazing", "angle at which the gaze meets a floor", "deg"},
        {0.1, 0.2, 0.5, 1, 2, 5, 10, 20},
        {"A flat floor fills the frame of a long lens (0.2 degrees, 1000 units away); things stand "
         "on it. The eye sinks; below 0.2 degrees the floor's far end comes into the picture.",
         "From pixel to pixel the floor's distance grows by 1 / tan of the angle: what does not "
         "know a plane takes its slope for a step."},
        grazing_cases));
    axes.push_back(make_axis(
        {"origin", "distance of scene and camera from the origin", "units"},
        decades(0, 8),
        {"Scene and camera move together away from the origin, by transforms in double.",
         "Everything is made eye-relative in double before it is rounded, so nothing may change."},
        origin_cases));
    axes.push_back(make_axis(
        {"fp32", "distance of scene and camera from the origin", "units"},
        decades(0, 8),
        {"As the axis before, but methods are given world positions rounded to floats, as a "
         "renderer holds them that works in fp32 throughout; the truth is of the exact scene.",
         "A float has 24 bits: at 1e6 units its steps are 1/16 of a unit, at 1e8 they are 8."},
        fp32_cases));
    axes.push_back(make_axis(
        {"scale", "size of the model over its own"},
        powers_of_two(-30, 30, 6),
        {"Scene, camera, near and far grow together by powers of two, 9e-10 to 1e9.",
         "No length in the world means anything to a picture: what changes here has an absolute "
         "tolerance somewhere."},
        scale_cases));
    axes.push_back(make_axis(
        {"zoom", "magnification"},
        powers_of_two(-5, 6, 1),
        {"The focal length grows, aimed at the vertex nearest the eye: from a scene of a few "
         "pixels to one corner of it.",
         "Small pictures crowd lines within the tolerance and below a pixel; large ones leave few "
         "lines, flat faces, and every facet visible."},
        zoom_cases));
    axes.push_back(make_axis(
        {"cube_roll", "roll of the camera", "deg", AxisScale::linear},
        steps(0, 350, 10),
        {"The camera turns about its gaze before a cube, a wedge and a solid of twenty faces.",
         "A sum of depth and normal has no step across a crease where the channels' changes "
         "cancel: at two angles a turn for each crease; filters of channels apart have none."},
        roll_cases));
}

void add_shapes(std::vector<StressAxis>& axes) {
    axes.push_back(make_axis(
        {"gap", "distance between surfaces", "units"},
        {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1},
        {"Coplanar things come apart by a gap: a sheet above another, slits between tiles, a step "
         "between two boxes, the thickness of a plate; each about 2 units wide, 5 units away.",
         "The true lines are there at any gap; a depth that resolves a share of its range only "
         "does not see them."},
        gap_cases));
    axes.push_back(make_axis(
        {"sliver", "length over width of the thinnest triangles"},
        decades(0, 7),
        {"A cube cut by thin strips, a ring each of whose triangles has one sliver, and free "
         "needles.",
         "Slivers inside a flat face must change nothing; needles get thinner than a pixel and "
         "nobody who looks at pixel centres sees them."},
        sliver_cases));
    axes.push_back(make_axis(
        {"facets", "triangles"},
        {8, 32, 128, 512, 2048, 8192, 32768, 131072, 1048576},
        {"A ball, a ring and a rolling sheet from a handful of triangles to a million, far below a "
         "pixel.",
         "Few facets are creases or nearly so; many are smooth, until triangles fall between pixel "
         "centres and a contour is made of edges shorter than a pixel."},
        facet_cases));
}

void add_knobs(std::vector<StressAxis>& axes) {
    StressAxis depth = make_axis(
        {"depth", "encoding of depth, format of the depth test", "", AxisScale::named},
        {},
        {"How a method writes depth (depth_encoding) and what the depth test stores "
         "(depth_format): q32 is a float of 1/w, z24 and z16 are whole steps; on scenes of great "
         "depth. A method without the knob keeps its own.",
         "1/w is flat on a plane; other encodings bend it, and 16 bits step."},
        depth_cases);
    depth.value_names = depth_names();
    for (std::size_t i = 0; i < depth.value_names.size(); ++i)
        depth.values.push_back(static_cast<double>(i + 1));
    axes.push_back(std::move(depth));
    axes.push_back(make_axis(
        {"code_bits", "bits of the packed code", "bits", AxisScale::linear},
        steps(3, 16, 1),
        {"Ranges of packed codes shrink by powers of two and the response is scaled up by as many "
         "bits. The 16 fractional bits of the rasterizer's code planes are a constant: this is how "
         "few whole ones a code does with. Methods that pack nothing are level lines.",
         "A rounded code of a plane has a response of up to 2 units, which with few bits is as "
         "much as a line."},
        code_bits_cases));
    axes.push_back(make_axis(
        {"saturate", "sum of the ranges over what they are by default"},
        {0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4},
        {"All ranges of packed codes and their threshold times a factor, as far as the knobs "
         "reach; beyond 1 codes overflow by intent and saturate.",
         "Where a code stands at its end, both sides of a line are equal."},
        saturate_cases));
    axes.push_back(make_axis({"wrap", "sum of the ranges over what they are by default"},
                             {0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4},
                             {"The same, but codes wrap and are filtered modulo their range.",
                              "A wrapped step is missed only where it is nearly a whole turn."},
                             wrap_cases));
    StressAxis threads = make_axis(
        {"threads", "threads", "", AxisScale::linear},
        steps(1, 8, 1),
        {"The same pictures by 1 to 8 threads.",
         "A picture does not depend on who draws it: what must be 0 is the number of pictures that "
         "differ from those of one thread."},
        thread_cases);
    threads.same_pictures = true;
    axes.push_back(std::move(threads));
    StressAxis simd = make_axis(
        {"simd", "instruction set", "", AxisScale::named},
        {},
        {"The same pictures by every instruction set that the kernels were compiled for and this "
         "machine runs; its points depend on the machine.",
         "Every target gives the bits of the plain one: what must be 0 is the number of pictures "
         "that differ from those of the best."},
        simd_cases);
    simd.value_names = simd_names();
    for (std::size_t i = 0; i < simd.value_names.size(); ++i)
        simd.values.push_back(static_cast<double>(i + 1));
    simd.same_pictures = true;
    axes.push_back(std::move(simd));
}

void add_defects(std::vector<StressAxis>& axes) {
    const auto defect = [&](std::string name, std::string what, Words words, Maker make) {
        axes.push_back(make_axis(
            {std::move(name), "share of triangles " + std::move(what), "%", AxisScale::linear},
            shares(),
            std::move(words),
            make));
    };
    defect("duplicates",
           "that are there twice",
           {"Some triangles of a ring, a cube and a drum are listed twice.",
            "An edge of such a triangle has more than two faces."},
           duplicate_cases);
    defect("t_junctions",
           "that are cut at an edge their neighbour does not share",
           {"Some triangles of a ring, a cube and a drum are halved at the middle of a side, which "
            "their neighbours know nothing of.",
            "Nothing is to be seen, but three edges then have one face each."},
           t_junction_cases);
    defect("cracks",
           "that are torn off by a hairline",
           {"Some triangles get vertices of their own, each off by up to a millionth of a unit: "
            "less than the truth's weld tolerance, so nothing of it is a line.",
            "What welds by equal positions finds lone edges everywhere; what looks at pixels sees "
            "nothing."},
           crack_cases);
    defect("orientation",
           "that are turned inside out",
           {"Some triangles run the other way round; the truth does not care.",
            "Facing told by the order of vertices is wrong for them, and so is a normal averaged "
            "over a patch."},
           orientation_cases);
    defect("soup",
           "without shared vertices",
           {"Some triangles get vertices of their own at the same places, and a place of their own "
            "in the list.",
            "Everyone welds by position first, so nothing may change but what depends on order."},
           soup_cases);
}

std::vector<StressAxis> make_axes() {
    std::vector<StressAxis> axes;
    add_places(axes);
    add_shapes(axes);
    add_knobs(axes);
    add_defects(axes);
    return axes;
}

}  // namespace

const std::vector<StressAxis>& stress_axes() {
    static const std::vector<StressAxis> axes = make_axes();
    return axes;
}

}  // namespace ink::lab
