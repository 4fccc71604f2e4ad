// Codes that are baked are those that the methods draw.

#include <gtest/gtest.h>

#include "catalogue/catalogue.h"
#include "methods/surface_codes/baked_codes.h"
#include "methods/surface_codes/surface_code_params.h"

namespace ink::methods {
namespace {

class Drawn : public CodePass {
  public:
    using CodePass::CodePass;
    using CodePass::constants_of;
};

TEST(BakedCodes, AreThoseOfTheMethods) {
    for (const char* name : {"cube", "torus", "teapot", "gear", "tiles"}) {
        const scene::Scene scene = catalogue::make_catalogue_scene(name);
        const SurfaceCodeParams surface;
        EXPECT_EQ(baked_codes(scene, BakedMethod::surface8, surface.crease_deg),
                  Drawn(surface, surface_setup(surface)).constants_of(scene))
            << name;
        const CodeParams label;
        EXPECT_EQ(baked_codes(scene, BakedMethod::label8, label.crease_deg),
                  Drawn(label, label_setup()).constants_of(scene))
            << name;
    }
}

}  // namespace
}  // namespace ink::methods
