#include "bake/bake.h"

#include <gmock/gmock.h>

#include <cstring>

#include "methods/mesh_lookup/lookup_table.h"
#include "tests/bake/baked_files.h"

namespace ink::bake {
namespace {

class LookupFile : public import::ModelFiles {
  protected:
    [[nodiscard]] import::ImportedModel model_of(const import::GlbFile& file) const {
        return import::import_model(write("a.glb", file.bytes()));
    }
};

/// The mesh's first primitive is of lines.
import::GlbFile two_cubes(){import::GlbFile file = import::cube_file();
import::Json& primitives = file.json["meshes"][0]["primitives"];
primitives.push_back(primitives[0]);
primitives[0]["mode"] = 1;
file.put("nodes", {{"mesh", 0}, {"children", {1}}});
file.put("nodes", {{"mesh", 0}, {"translation", {3, 0, 0}}});
return file;
}  // namespace

TEST_F(LookupFile, HasTheTablesAndOfEachPointAVertexThatIsThere) {
    const import::ImportedModel model = model_of(two_cubes());
    const std::string bytes = lookup_file(model, 40);
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    const methods::LookupTable table = methods::lookup_table(model.scene, 40);
    constexpr std::size_t kFaces = 24, kParts = 2, kPoints = 16;
    ASSERT_EQ(words.size(), 3 + 8 * kFaces + 2 * kParts + 2 * kPoints);
    EXPECT_EQ((std::vector<std::size_t>{words[0], words[1], words[2]}),
              (std::vector{kFaces, kParts, kPoints}));
    EXPECT_EQ(std::memcmp(&words[3], table.faces.data(), 32 * kFaces), 0);
    const std::uint32_t* parts = &words[3 + 8 * kFaces];
    EXPECT_THAT(std::vector(parts, parts + 4), testing::ElementsAre(0, 1, 1, 1));
    const std::vector<float> corners = import::cube_corners<float>();
    for (std::size_t i = 0; i < kPoints; ++i) {
        const std::uint32_t part = parts[4 + 2 * i], v = parts[5 + 2 * i];
        const float x = part == 1 ? 3.0F : 0.0F;
        EXPECT_EQ(table.p_world[i],
                  glm::vec4(corners[3 * v] + x, corners[3 * v + 1], corners[3 * v + 2], 1));
    }
}

TEST_F(LookupFile, RefusesCopiesInOneNode) {
    import::GlbFile file = import::cube_file();
    const std::size_t places = file.accessor(std::vector<float>{0, 0, 0, 3, 0, 0}, "VEC3");
    const import::Json copies = {{"attributes", {{"TRANSLATION", places}}}};
    file.put("nodes", {{"mesh", 0}, {"extensions", {{"EXT_mesh_gpu_instancing", copies}}}});
    EXPECT_THROW((void)lookup_file(model_of(file), 40), core::Error);
}

}  // namespace ink::bake
}  // namespace ink::bake
