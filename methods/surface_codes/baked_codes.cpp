#include "methods/surface_codes/baked_codes.h"

#include "methods/surface_codes/surface_code_params.h"

namespace ink::methods {

std::vector<std::uint32_t> baked_codes(const scene::PreparedScene& scene,
                                       BakedMethod method,
                                       double crease_deg) {
    SurfaceCodeParams params;
    params.crease_deg = crease_deg;
    const CodeSetup setup = method == BakedMethod::surface8 ? surface_setup(params) : label_setup();
    SurfaceCodes codes(code_options(params, setup));
    codes.prepare(scene);
    return codes.object_codes(scene, object_length_px(setup));
}

std::shared_ptr<const SmoothMesh> baked_mesh(const scene::PreparedScene& scene, double crease_deg) {
    CodeParams params;
    params.crease_deg = crease_deg;
    return make_smooth_mesh(scene, code_options(params, {}).patches);
}

}  // namespace ink::methods
