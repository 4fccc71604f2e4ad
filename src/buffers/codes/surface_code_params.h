#pragma once

#include <vector>

#include "buffers/codes/code_method.h"

namespace ink::buffers {

/// The parameters of whatever draws codes of surface distance.
struct SurfaceCodeParams : CodeParams {
    double turn_deg = 5;
    Footprint footprint = Footprint::object;
    double length_px = 2;
    int rounds = 10;
};

/// The rows of SurfaceCodeParams.
template <class P>
[[nodiscard]] core::ParamTable<P> surface_code_table() {
    core::ParamTable<P> table;
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
    return add_code_params(table,
                           "Least edge response of a line pixel: 64 for each step between codes.");
}

/// How codes of surface distance are made and looked at, of one byte or two.
[[nodiscard]] CodeSetup surface_setup(const SurfaceCodeParams& params, int bytes);

/// Settings from the fastest to the most exact, the defaults among them.
[[nodiscard]] std::vector<core::ParamValues> surface_sweep();

/// What of them is worth tuning.
[[nodiscard]] std::vector<method::Tunable> surface_tunables();

}  // namespace ink::buffers
