// Codes that are baked are those that the methods draw.

#include <gtest/gtest.h>

#include <set>

#include "catalogue/catalogue.h"
#include "methods/registry.h"
#include "methods/surface_codes/baked_codes.h"
#include "methods/surface_codes/code_method.h"

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

TEST(BakedCodes, AreWhatTheirMethodsShow) {
    const scene::Scene scene = catalogue::make_catalogue_scene("cube");
    const scene::View view{.camera = scene.cameras.at(0), .width_px = 320, .height_px = 180};
    for (const auto& [name, kind] :
         {std::pair{"surface8", BakedMethod::surface8}, std::pair{"label8", BakedMethod::label8}}) {
        const method::MethodInfo& info = find_method(name);
        const auto drawing = info.make({});
        drawing->prepare(scene);
        drawing->pose(scene);
        std::set<std::uint32_t> shown;
        const auto layers = drawing->layers({view, 1});
        for (std::size_t i = 0; i < layers[0].codes[0].size(); ++i)
            shown.insert(layers[0].codes[0].data()[i]);
        shown.erase(0);
        const auto codes = baked_codes(scene, kind, 40);
        std::set<std::uint32_t> facing;
        std::size_t triangle = 0;
        for (const scene::Instance& instance : scene.instances) {
            const scene::Mesh& mesh = scene.meshes[instance.mesh];
            for (const scene::Triangle& t : mesh.triangles) {
                const glm::dvec3 a = scene::to_world(instance, mesh.positions[t[0]]);
                const glm::dvec3 b = scene::to_world(instance, mesh.positions[t[1]]);
                const glm::dvec3 c = scene::to_world(instance, mesh.positions[t[2]]);
                if (glm::dot(glm::cross(b - a, c - a), view.camera.eye_world - a) > 0)
                    facing.insert(codes[triangle]);
                ++triangle;
            }
        }
        EXPECT_EQ(shown, facing) << name;
    }
}

}  // namespace
}  // namespace ink::methods
