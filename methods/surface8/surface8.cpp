// New here: distances over the surface in a byte, constant over each triangle,
//
//     D    = the shortest way over the patch from one of its ends; a way costs a step at most, less
//            where the surface hardly turns                     (surface_codes/surface_distance.h)
//     code = 2 + fold(floor(D + phase)), to and fro in 0..253 (surface_codes/surface_codes.h) edge
//     response = min(255, 64 |difference of codes|) of a pixel's neighbouring samples
//
// so that codes differ by a step at most where a smooth surface goes on, and by more across lines.

#include "methods/surface_codes/code_method.h"

namespace ink::methods {
namespace {

class Surface8 : public CodeMethod {
  public:
    struct Params : SurfaceCodeParams {
        bool repaired = false;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.flag(&Params::repaired,
                   "repaired",
                   "Raise and lower codes until random views show few wrong lines; they then "
                   "follow no view.");
        return add_surface_code_params(table);
    }
    explicit Surface8(const Params& params) : CodeMethod(params, setup_of(params)) {}

  private:
    static CodeSetup setup_of(const Params& params) {
        CodeSetup setup = surface_setup(params);
        setup.is_repaired = params.repaired;
        return setup;
    }
};

}  // namespace

method::MethodInfo surface8_method() {
    return method::method_info<Surface8>("surface8");
}

}  // namespace ink::methods
