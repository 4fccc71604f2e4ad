#include "given_images/score_files.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/error.h"
#include "draw/exr_layers.h"
#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "tests/core/error_text.h"
#include "tests/core/temp_folder.h"

namespace ink::given_images {
namespace {

namespace fs = std::filesystem;
using Gray = core::Image<std::uint8_t>;
using testing::HasSubstr;

/// A vertical line of `value` at column 8 on `ground`.
Gray line_image(std::uint8_t value, std::uint8_t ground) {
    Gray image(32, 24, ground);
    for (int y = 0; y < 24; ++y)
        image.at(8, y) = value;
    return image;
}

class ScoreFiles : public testing::Test {
  protected:
    fs::path write(const std::string& name, const Gray& image) const {
        const fs::path path = folder_ / name;
        fs::create_directories(path.parent_path());
        image_io::write_png(image, path);
        return path;
    }

    const core::TempFolder folder_;
};

TEST_F(ScoreFiles, FindsDarkLinesOnLightByItself) {
    const fs::path truth = write("truth.png", line_image(1, 0));
    const fs::path light = write("light.png", line_image(255, 0));
    const fs::path dark = write("dark.png", line_image(0, 255));
    for (const auto& [path, is_inverted] : {std::pair(light, false), std::pair(dark, true)}) {
        const FilesScore scored = score_files(path, truth, {});
        EXPECT_EQ(scored.is_inverted, is_inverted) << path;
        EXPECT_EQ(scored.score.f(), 1) << path;
        EXPECT_TRUE(scored.doubts.empty());
    }
    EXPECT_LT(score_files(dark, truth, {.polarity = harness::Polarity::light_on_dark}).score.f(),
              1);
}

TEST_F(ScoreFiles, TakesAnImageOfOneValueAsItIs) {
    const fs::path truth = write("truth.png", line_image(1, 0));
    EXPECT_FALSE(score_files(write("white.png", Gray(32, 24, 255)), truth, {}).is_inverted);
    EXPECT_FALSE(score_files(write("black.png", Gray(32, 24, 0)), truth, {}).is_inverted);
}

TEST_F(ScoreFiles, RefusesAColouredPreviewAsTruth) {
    core::Image<image_io::Rgb> preview(32, 24, image_io::Rgb(255));
    preview.at(3, 3) = image_io::Rgb(255, 0, 0);
    image_io::write_png(preview, folder_ / "preview.png");
    const fs::path drawn = write("drawn.png", line_image(255, 0));
    EXPECT_THAT(core::error_text([&] { return score_files(drawn, folder_ / "preview.png", {}); }),
                HasSubstr("preview.png: it is in colour"));
}

/// An EXR as `truth -o` writes it, as far as the score reads it.
fs::path write_exr_truth(const fs::path& path) {
    core::Image<std::uint32_t> labels(32, 24, 0);
    core::Image<std::uint32_t> below(32, 24, 0);
    for (int y = 0; y < 24; ++y) {
        labels.at(8, y) = 1;
        labels.at(20, y) = 4;
        below.at(20, y) = 1;
    }
    image_io::write_exr({{{"class.label", labels}, {"class.below_crease", below}},
                         {{"ink:ignore_label", 7.0}, {"ink:band_px", 6.0}}},
                        path);
    return path;
}

TEST_F(ScoreFiles, TakesIgnoreAndBandFromAnExr) {
    const fs::path truth = write_exr_truth(folder_ / "truth.exr");
    const fs::path drawn = write("drawn.png", line_image(255, 0));
    const FilesScore scored = score_files(drawn, truth, {});
    EXPECT_EQ(scored.options.ignore_label, 7);
    EXPECT_EQ(scored.options.band_px, 6);
    EXPECT_EQ(scored.score.n_truth, 12) << "24 rows less the band; flat intersections are ignored";
    EXPECT_EQ(scored.score.f(), 1);
    const FilesScore all =
        score_files(drawn, truth, {.intersections = score::Intersections::all, .band_px = 0});
    EXPECT_EQ(all.options.band_px, 0) << "the caller's own";
    EXPECT_EQ(all.score.n_truth, 48);
}

TEST_F(ScoreFiles, TakesIgnoreAndBandFromTheTextsOfAPng) {
    const fs::path truth = folder_ / "truth.png";
    image_io::write_png(line_image(1, 0),
                        truth,
                        {{"ink:labels", "0 none 1 contour"},
                         {"ink:ignore_label", "7"},
                         {"ink:band_px", "6"},
                         {"ink:below_crease_px", "3"}});
    const fs::path drawn = write("drawn.png", line_image(255, 0));
    const FilesScore scored = score_files(drawn, truth, {});
    EXPECT_EQ(scored.options.ignore_label, 7);
    EXPECT_EQ(scored.options.band_px, 6);
    EXPECT_EQ(scored.score.n_truth, 12);
    EXPECT_EQ(scored.score.classes.size(), 1U) << "a lone 1 is a class";
    EXPECT_THAT(scored.doubts, testing::ElementsAre(HasSubstr("3 px")));
    EXPECT_TRUE(
        score_files(drawn, truth, {.intersections = score::Intersections::all}).doubts.empty());
    image_io::write_png(line_image(1, 0), truth, {{"ink:band_px", "wide"}});
    EXPECT_EQ(score_files(drawn, truth, {}).options.band_px, 0) << "not ours";
}

TEST_F(ScoreFiles, AnotherSizeNamesTheCommandForTheRightTruth) {
    const fs::path drawn = write("drawn.png", Gray(40, 24, 0));
    const fs::path truth = folder_ / "truth.png";
    const auto refusal = [&] {
        return core::error_text([&] { return score_files(drawn, truth, {}); });
    };
    write("truth.png", line_image(1, 0));
    EXPECT_THAT(refusal(), HasSubstr("inkbench score " + drawn.string() + " --model MODEL"));
    image_io::write_png(line_image(1, 0), truth, {{"ink:command", "inkbench truth cube"}});
    EXPECT_THAT(refusal(), HasSubstr("inkbench truth cube --size 40x24 -o " + truth.string()));
}

TEST_F(ScoreFiles, SaysWhatSeemsToBeWrong) {
    const fs::path truth = write("truth.png", line_image(1, 0));
    const auto doubts = [&](const Gray& image) {
        return score_files(write("drawn.png", image), truth, {}).doubts;
    };
    Gray shifted(32, 24, 0);
    for (int y = 0; y < 24; ++y)
        shifted.at(13, y) = 255;
    EXPECT_THAT(doubts(shifted),
                testing::ElementsAre(HasSubstr("drawn.png: it seems to be shifted by 5 px")));
    EXPECT_THAT(doubts(Gray(32, 24, 0)), testing::ElementsAre(HasSubstr("drawn.png: it is blank")));
    Gray half(32, 24, 0);
    for (int y = 0; y < 24; ++y)
        std::fill(half.row(y), half.row(y) + 20, std::uint8_t{255});
    EXPECT_THAT(
        doubts(half),
        testing::ElementsAre(HasSubstr("62 % of it count as drawn; if its lines are dark on "
                                       "light, score it with --polarity dark")));
}

TEST_F(ScoreFiles, RefusesAnExrWithoutLabels) {
    image_io::write_exr({{{"Y", core::Image<float>(4, 4, 1.0F)}}, {}}, folder_ / "other.exr");
    const fs::path drawn = write("drawn.png", line_image(255, 0));
    EXPECT_THROW((void)score_files(drawn, folder_ / "other.exr", {}), core::Error);
}

TEST_F(ScoreFiles, NoValueIsInfinite) {
    core::Image<float> light(32, 24, 0.0F);
    light.at(5, 7) = std::numeric_limits<float>::infinity();
    fs::create_directories(folder_ / "drawn");
    image_io::write_exr({{{"Y", light}}, {}}, folder_ / "drawn/a.exr");
    const fs::path truth = write("truth/a.png", line_image(1, 0));
    const auto scores =
        score_folders(folder_ / "drawn", folder_ / "truth", {}, [](const auto&, const auto&) {});
    EXPECT_THAT(scores.at(0).status, HasSubstr("a.exr: channel Y is infinite at pixel 5,7"));
    image_io::write_exr(
        {{{"class.label", core::Image<std::uint32_t>(32, 24, 0)}, {draw::kCoverageChannel, light}},
         {}},
        folder_ / "truth.exr");
    const fs::path drawn = write("drawn.png", line_image(255, 0));
    EXPECT_THAT(core::error_text([&] { return score_files(drawn, folder_ / "truth.exr", {}); }),
                HasSubstr("is inf at pixel 5,7"));
}

TEST_F(ScoreFiles, PictureShowsHitsMissesAndFalseLines) {
    Gray labels = line_image(1, 0);
    Gray drawn = line_image(255, 0);
    for (int y = 0; y < 24; ++y)
        labels.at(28, y) = 3;  // missing
    for (int y = 0; y < 24; ++y)
        drawn.at(18, y) = 255;  // false
    const FilesScore scored =
        score_files(write("drawn.png", drawn), write("truth.png", labels), {});
    const draw::RgbImage picture = picture_of(scored);
    EXPECT_NE(picture.at(28, 12), picture.at(8, 12));
    EXPECT_NE(picture.at(18, 12), picture.at(8, 12));
    EXPECT_NE(picture.at(18, 12), picture.at(28, 12));
    EXPECT_EQ(picture.at(2, 2), glm::u8vec3(255)) << "paper";
}

TEST_F(ScoreFiles, FoldersPairByNameAndSayWhatIsMissing) {
    write("truth/a/front.png", line_image(1, 0));
    write_exr_truth(folder_ / "truth/a/back.exr");
    write("truth/b/front.png", line_image(1, 0));
    write("truth/b/back.png", line_image(1, 0));
    write("drawn/a/front.png", line_image(255, 0));
    write("drawn/a/back.png", line_image(0, 255));
    write("drawn/b/back.png", Gray(8, 8, 0));
    std::vector<std::string> named;
    const auto scores =
        score_folders(folder_ / "drawn", folder_ / "truth", {}, [&](const auto& name, const auto&) {
            named.push_back(name);
        });
    ASSERT_EQ(scores.size(), 4U);
    EXPECT_THAT(named, testing::ElementsAre("a/back", "a/front"));
    EXPECT_EQ(scores[0].score->f(), 1);
    EXPECT_THAT(scores[2].status, HasSubstr("size")) << scores[2].name;
    EXPECT_THAT(scores[3].status, HasSubstr("no image of this name")) << scores[3].name;
    EXPECT_EQ(pooled(scores).n_truth, 12 + 24);
    write("drawn/a/back.webp.png", Gray(8, 8, 0));
    write("drawn/extra.png", Gray(8, 8, 0));
    std::ofstream(folder_ / "drawn/times.csv") << "scene,view,draw_ms\n";
    EXPECT_THAT(files_without_truth(folder_ / "drawn", folder_ / "truth"),
                testing::ElementsAre("a/back.webp.png", "extra.png"));
    EXPECT_THROW((void)score_folders(folder_ / "drawn", folder_ / "nowhere", {}, {}), core::Error);
}

TEST_F(ScoreFiles, AnExportedViewHasOneTruthUnderItsOwnName) {
    write("views/torus/front/ids.png", line_image(1, 0));
    write_exr_truth(folder_ / "views/torus/front/truth.exr");
    std::ofstream(folder_ / "views/torus/front/camera.json") << "{}";
    write("drawn/torus/front.png", line_image(0, 255));
    const auto scores =
        score_folders(folder_ / "drawn", folder_ / "views", {}, [](const auto&, const auto&) {});
    ASSERT_EQ(scores.size(), 1U) << "ids are no truth";
    EXPECT_EQ(scores[0].name, "torus/front");
    ASSERT_TRUE(scores[0].score) << scores[0].status;
    EXPECT_EQ(scores[0].score->f(), 1);
}

}  // namespace
}  // namespace ink::given_images
