#pragma once

#include <glm/trigonometric.hpp>

#include "methods/surface_codes/code_method.h"

namespace ink::methods {

/// The parameters of whatever draws codes of surface distance.
struct SurfaceCodeParams : CodeParams {
    double turn_deg = 5;
    Footprint footprint = Footprint::object;
    double length_px = 2;
    int rounds = 10;
};

/// Appends the rows of SurfaceCodeParams to a table whose struct derives from it.
template <class P>
core::ParamTable<P>& add_surface_code_params(core::ParamTable<P>& table) {
    table
        .number(&P::turn_deg,
                "turn_deg",
                {0.1, 180},
                "deg",
                "Turning of the normal from one triangle to the next that makes a whole step.")
        .choice(&P::footprint,
                "footprint",
                {"none", "object", "view"},
                "What limits steps by length: nothing, the largest object's size, or the view.")
        .number(&P::length_px,
                "length_px",
                {0, 100},
                "px",
                "Least length of a step on the image, by the footprint; 0: no limit.")
        .number(&P::rounds,
                "rounds",
                {0, 100},
                "",
                "Rounds of parting the two sides of creases that end inside a patch.");
    return method::add_threshold(
        add_code_params(table),
        "Least edge response of a line pixel: 64 for each step between codes.");
}

/// How codes of surface distance are made and looked at.
[[nodiscard]] inline CodeSetup surface_setup(const SurfaceCodeParams& params) {
    CodeSetup setup;
    setup.turn_rad = glm::radians(params.turn_deg);
    setup.rounds = params.rounds;
    setup.range = {.lowest = 2, .highest = 255, .least_difference = 2};  // sky is 0
    setup.footprint = params.footprint;
    setup.length_px = params.length_px;
    setup.gain_bits = 6;  // a difference of 2, the least that is a line, is 128
    return setup;
}

}  // namespace ink::methods
