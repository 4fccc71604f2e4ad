#include <utility>

#include "studies/stress/stress_axis_maker.h"

namespace ink::studies {
namespace {

std::vector<double> shares() {
    return {0, 1, 2, 5, 10, 20, 40, 70, 100};
}

}  // namespace

void add_parameter_axes(std::vector<Axis>& axes) {
    Axis depth = make_axis(
        {"depth", "encoding of depth, format of the depth test", "", AxisScale::named},
        {},
        "How a method writes depth (depth_encoding) and what the depth test stores "
        "(depth_format): q32 is a float of 1/w, z24 and z16 are whole steps; on scenes of great "
        "depth, far 1e5 times as far as near, and depth scaled to these (depth_range = camera). A "
        "method without a parameter keeps its own.",
        depth_cases);
    depth.value_names = depth_names();
    for (std::size_t i = 0; i < depth.value_names.size(); ++i)
        depth.values.push_back(static_cast<double>(i + 1));
    axes.push_back(std::move(depth));
    axes.push_back(make_axis(
        {"code_bits", "bits of the packed code", "bits", AxisScale::linear},
        evenly(3, 16, 1),
        "Ranges of packed codes shrink by powers of two and the response is scaled up by as many "
        "bits. The 16 fractional bits of the rasterizer's code planes are a constant; this axis "
        "varies the whole bits. Methods that pack nothing do not change.",
        code_bits_cases));
    axes.push_back(make_axis(
        {"saturate", "sum of the ranges over what they are by default"},
        {0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4},
        "All ranges of packed codes and their threshold times a factor, as far as the parameters "
        "reach; beyond 1 codes overflow by intent and saturate.",
        saturate_cases));
    axes.push_back(make_axis({"wrap", "sum of the ranges over what they are by default"},
                             {0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4},
                             "The same, but codes wrap and are filtered modulo their range.",
                             wrap_cases));
    Axis threads = make_axis({"threads", "threads", "", AxisScale::linear},
                             evenly(1, 8, 1),
                             "The same images by 1 to 8 threads.",
                             thread_cases);
    threads.same_images = true;
    axes.push_back(std::move(threads));
    Axis simd = make_axis(
        {"simd", "instruction set x threads", "", AxisScale::named},
        {},
        "The same images by every instruction set that the kernels were compiled for and this "
        "machine runs, each on one thread and on four; the points depend on the machine.",
        simd_cases);
    simd.value_names = simd_names();
    for (std::size_t i = 0; i < simd.value_names.size(); ++i)
        simd.values.push_back(static_cast<double>(i + 1));
    simd.same_images = true;
    axes.push_back(std::move(simd));
}

void add_defect_axes(std::vector<Axis>& axes) {
    const auto defect =
        [&](std::string name, std::string what, std::string sentence, StressMaker make) {
            axes.push_back(make_axis(
                {std::move(name), "share of triangles " + std::move(what), "%", AxisScale::linear},
                shares(),
                std::move(sentence),
                make));
        };
    defect("duplicates",
           "that are there twice",
           "Some triangles of a ring, a cube and a drum are listed twice.",
           duplicate_cases);
    defect("t_junctions",
           "that are cut at an edge their neighbour does not share",
           "Some triangles of a ring, a cube and a drum are halved at the middle of a side. Their "
           "neighbours do not share that vertex.",
           t_junction_cases);
    defect("cracks",
           "that are separated by a hairline",
           "Some triangles get vertices of their own, each off by up to a millionth of a unit: "
           "less than the truth's weld tolerance, so the truth has no line there.",
           crack_cases);
    defect("orientation",
           "that are turned inside out",
           "Some triangles run the other way round; the truth does not depend on this.",
           orientation_cases);
    defect("soup",
           "without shared vertices",
           "Some triangles get vertices of their own at the same places, and a place of their own "
           "in the list.",
           soup_cases);
}

}  // namespace ink::studies
