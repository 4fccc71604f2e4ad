#include "experiment/options/option_table.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "tests/core/error_text.h"
#include "tests/core/temp_folder.h"

namespace ink::experiment {
namespace {

using testing::HasSubstr;

class ModelList : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path list(const std::string& text) const {
        std::ofstream(folder_ / "list.toml") << text;
        return folder_ / "list.toml";
    }
    [[nodiscard]] std::string refusal(const std::string& text) const {
        return core::error_text([&] { return read_model_list(list(text)); });
    }

    const core::TempFolder folder_;
};

TEST_F(ModelList, TellsKindAndSplitOfModelsAloneAndInPackages) {
    const auto models =
        read_model_list(list("[[model]]\nfile = 'a.glb'\nkind = 'vehicle'\n"
                             "[[package]]\nname = 'p'\n"
                             "[[package.model]]\nname = 'b'\nfile = 'b.obj'\n"
                             "kind = 'scan'\nsplit = 'train'\nsha256 = '0'\n"));
    ASSERT_EQ(models.size(), 2U);
    EXPECT_EQ(models[0].file, "a.glb");
    EXPECT_EQ(models[0].kind, "vehicle");
    EXPECT_EQ(models[0].split, scene::Split::real);
    EXPECT_EQ(models[1].kind, "scan");
    EXPECT_EQ(models[1].split, scene::Split::train);
}

TEST_F(ModelList, RefusesWhatSaysNothing) {
    EXPECT_THAT(refusal(""), HasSubstr("it lists no model"));
    EXPECT_THAT(refusal("[[model]]\nfile = 'a'\n"), HasSubstr("kind"));
    EXPECT_THAT(refusal("[[model]]\nfile = 'a'\nkind = 'b'\nsplit = 'heldout'\n"),
                HasSubstr("there is no split 'heldout' (accepted: train, real)"));
    EXPECT_THAT(refusal("[[model]]\nfile = 'a'\nkind = 'b'\n[[model]]\nfile = 'a'\nkind = 'c'\n"),
                HasSubstr("'a' is listed twice"));
    EXPECT_THROW((void)read_model_list(folder_ / "none.toml"), core::Error);
}

TEST_F(ModelList, AListedFileHasItsKindAndSplitAndABuiltInSceneKeepsItsOwn) {
    std::ofstream(folder_ / "roof.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n";
    harness::ViewRequest request;
    request.listed = {{"roof.obj", "architecture", scene::Split::train},
                      {"gear", "foliage", scene::Split::real}};
    const auto scenes = harness::load_scenes({(folder_ / "roof.obj").string(), "gear"}, request);
    EXPECT_EQ(scenes[0].scene.kind, "architecture");
    EXPECT_EQ(scenes[0].scene.split, scene::Split::train);
    EXPECT_EQ(scenes[1].scene.kind, "assembly");
    EXPECT_EQ(scenes[1].scene.split, scene::Split::train);
}

}  // namespace
}  // namespace ink::experiment
