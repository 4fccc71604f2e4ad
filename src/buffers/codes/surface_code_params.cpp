#include "buffers/codes/surface_code_params.h"

#include <glm/trigonometric.hpp>

namespace ink::buffers {

CodeSetup surface_setup(const SurfaceCodeParams& params, int bytes) {
    CodeSetup setup;
    setup.turn_rad = glm::radians(params.turn_deg);
    setup.rounds = params.rounds;
    setup.range = {.lowest = 2, .highest = 255, .least_difference = 2};  // sky is 0
    setup.footprint = params.footprint;
    setup.length_px = params.length_px;
    setup.gain_bits = 6;  // a difference of 2, the least that is a line, is 128
    setup.bytes = bytes;
    return setup;
}

std::vector<core::ParamValues> surface_sweep() {
    return {
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // Samples at pixel centres: the line lies left of or above the border.
        {{"samples", "centre"}},
        // Turning alone makes steps.
        {{"footprint", "none"}},
        // Creases that end inside a patch are left to chance.
        {{"rounds", "0"}},
        // Twice and half as many steps.
        {{"turn_deg", "2.5"}},
        {{"turn_deg", "10"}},
        // Longer steps: less noise, less that is seen behind itself.
        {{"length_px", "4"}},
        // Codes made for each view: exact footprints, for much time.
        {{"footprint", "view"}},
        // Nothing welded but what is bit-identical.
        {{"weld_epsilon", "0"}},
        {},
    };
}

std::vector<method::Tunable> surface_tunables() {
    return {{"turn_deg", {{1, 20}}}, {"length_px", {{0, 12}}}, {"rounds", {{0, 20}}}};
}

}  // namespace ink::buffers
