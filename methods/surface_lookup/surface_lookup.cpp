// New here: a code of surface8, a flag and the face in one word. The code and the depth beside it
// decide nearly all sides, as surface8_depth would; only what is in doubt is looked up in the mesh,
// as id_lookup does.

#include "methods/mesh_lookup/lookup_method.h"

namespace ink::methods {
namespace {

struct SurfaceLookupParams : LookupParams {
    double jump_px = 0.1;
    int trust = 4;
};

class SurfaceLookup : public LookupMethod {
  public:
    using Params = SurfaceLookupParams;
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        add_jump_param(table).number(&Params::trust,
                                     "trust",
                                     {2, 255},
                                     "",
                                     "Least difference of codes that is a line without looking.");
        return method::add_threshold_of_two(add_lookup_params(table));
    }
    explicit SurfaceLookup(const Params& params)
        : LookupMethod(params, CodedLookup{"surface_lookup", params.jump_px, params.trust}) {}
};

}  // namespace

method::MethodInfo surface_lookup_method() {
    return method::method_info<SurfaceLookup>("surface_lookup");
}

}  // namespace ink::methods
