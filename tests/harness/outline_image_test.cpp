#include "harness/images/outline_image.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <glm/vec2.hpp>

#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "tests/core/temp_folder.h"
#include "tests/image_io/display_window.h"

namespace ink::harness {
namespace {

namespace fs = std::filesystem;
using image_io::Rgb;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// 64 x 48 px: lines 2 px wide, and of a figure its inner 40 x 40 px.
bool is_line(int x, int y) {
    return (x / 2 == 15 || y / 2 == 11) && x >= 12 && x < 52 && y >= 4 && y < 44;
}
bool is_figure(int x, int y) {
    return x >= 12 && x < 52 && y >= 4 && y < 44;
}

class OutlineFile : public testing::Test {
  protected:
    OutlineImage read(Polarity polarity = Polarity::automatic) const {
        return read_outline_image(path_, polarity);
    }
    /// A PNG of lines of one colour on a ground of another.
    OutlineImage read_lines(const Rgb& line,
                            const Rgb& ground,
                            Polarity polarity = Polarity::automatic) {
        core::Image<Rgb> image(64, 48);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x)
                image.at(x, y) = is_line(x, y) ? line : ground;
        }
        path_.replace_extension(".png");
        image_io::write_png(image, path_);
        return read(polarity);
    }
    /// An EXR with alpha: lines, the figure under them, and the rest transparent, each as light and
    /// alpha.
    OutlineImage read_with_alpha(const glm::vec2& line,
                                 const glm::vec2& figure,
                                 Polarity polarity = Polarity::automatic) {
        core::Image<float> light(64, 48, 0.0F);
        core::Image<float> alpha(64, 48, 0.0F);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const glm::vec2 both =
                    is_line(x, y) ? line : (is_figure(x, y) ? figure : glm::vec2(0));
                light.at(x, y) = both.x * both.y;
                alpha.at(x, y) = both.y;
            }
        }
        path_.replace_extension(".exr");
        image_io::write_exr({{{"A", alpha}, {"Y", light}}, {}}, path_);
        return read(polarity);
    }

    const core::TempFolder folder_;
    fs::path path_ = folder_ / "outline.png";
};

void expect_lines(const OutlineImage& outline) {
    int wrong = 0;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x)
            wrong += (outline.responses.at(x, y) >= 128) != is_line(x, y) ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0);
}

TEST_F(OutlineFile, GreyIsTakenAsItIs) {
    const OutlineImage dark = read_lines(Rgb(10), Rgb(250));
    expect_lines(dark);
    EXPECT_TRUE(dark.is_inverted);
    EXPECT_THAT(dark.notes, IsEmpty());
    EXPECT_EQ(dark.responses.at(30, 10), 245);
    const OutlineImage light = read_lines(Rgb(200), Rgb(0));
    expect_lines(light);
    EXPECT_FALSE(light.is_inverted);
}

TEST_F(OutlineFile, ColouredLinesCountByWhatSeparatesThemBest) {
    const OutlineImage red = read_lines({255, 0, 0}, Rgb(0));
    expect_lines(red);
    EXPECT_THAT(red.notes, ElementsAre("lines by the red channel"));
    const OutlineImage yellow = read_lines({255, 255, 0}, Rgb(255));
    expect_lines(yellow);
    EXPECT_TRUE(yellow.is_inverted);
    EXPECT_THAT(yellow.notes, ElementsAre("lines by the blue channel"));
    const OutlineImage pale = read_lines({100, 120, 200}, {150, 120, 100});
    expect_lines(pale);
    EXPECT_THAT(pale.notes,
                ElementsAre("lines by the distance from the ground's colour (150,120,100)"));
    const OutlineImage black = read_lines({10, 0, 20}, {250, 255, 255});
    expect_lines(black);
    EXPECT_THAT(black.notes, IsEmpty()) << "luma does as well";
}

TEST_F(OutlineFile, APolarityThatIsGivenHolds) {
    const OutlineImage yellow = read_lines({255, 255, 0}, Rgb(255), Polarity::dark_on_light);
    expect_lines(yellow);
    EXPECT_TRUE(yellow.is_inverted);
    const OutlineImage other = read_lines({255, 255, 0}, Rgb(255), Polarity::light_on_dark);
    EXPECT_FALSE(other.is_inverted);
    EXPECT_EQ(other.responses.at(0, 0), 255);
}

TEST_F(OutlineFile, AShadingCountsByItsLuma) {
    core::Image<Rgb> image(64, 48, Rgb(255));
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            if (is_figure(x, y) && x < 30) image.at(x, y) = {255, 180, 60};
            if (is_line(x, y)) image.at(x, y) = Rgb(0);
        }
    }
    image_io::write_png(image, path_);
    const OutlineImage shaded = read();
    EXPECT_THAT(shaded.notes, IsEmpty());
    expect_lines(shaded);
}

TEST_F(OutlineFile, AlphaIsLaidOverTheOppositeOfItsLines) {
    const OutlineImage black = read_with_alpha({0, 1}, {0, 0});
    expect_lines(black);
    EXPECT_THAT(black.notes, testing::Contains("its alpha laid over white"));
    const OutlineImage white = read_with_alpha({1, 1}, {0, 0});
    expect_lines(white);
    EXPECT_THAT(white.notes, testing::Contains("its alpha laid over black"));
    const OutlineImage on_white = read_with_alpha({0, 1}, {1, 1});
    expect_lines(on_white);
    EXPECT_THAT(on_white.notes, testing::Contains("its alpha laid over white"));
    const OutlineImage on_black = read_with_alpha({1, 1}, {0, 1});
    expect_lines(on_black);
    EXPECT_THAT(on_black.notes, testing::Contains("its alpha laid over black"));
    const OutlineImage told = read_with_alpha({0.2F, 1}, {0, 0}, Polarity::light_on_dark);
    EXPECT_THAT(told.notes, testing::Contains("its alpha laid over black"));
}

TEST_F(OutlineFile, AlphaThatHidesNothingIsNotMentioned) {
    core::Image<float> ground(64, 48, 1.0F);
    path_.replace_extension(".exr");
    image_io::write_exr({{{"A", ground}, {"Y", ground}}, {}}, path_);
    EXPECT_THAT(read().notes, ElementsAre(HasSubstr("float values")));
}

TEST(CroppedImage, HasGroundWhereItHoldsNothing) {
    const core::TempFolder folder;
    const fs::path path = folder / "crop.exr";
    for (const bool is_dark : {true, false}) {
        core::Image<float> light(40, 30, is_dark ? 1.0F : 0.0F);
        for (int x = 0; x < 40; ++x)
            light.at(x, 15) = is_dark ? 0.0F : 1.0F;
        image_io::write_exr({{{"Y", light}}, {}}, path);
        image_io::set_display_window(path, {-12, -9, 51, 38});
        const OutlineImage outline = read_outline_image(path);
        EXPECT_EQ(outline.is_inverted, is_dark);
        EXPECT_THAT(
            outline.notes,
            testing::Contains("its display window, of which it holds 40 x 30 px from 12,9"));
        ASSERT_EQ(outline.responses.width_px(), 64);
        ASSERT_EQ(outline.responses.height_px(), 48);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const bool is_line = y == 24 && x >= 12 && x < 52;
                EXPECT_EQ(outline.responses.at(x, y), is_line ? 255 : 0) << x << "," << y;
            }
        }
    }
}

}  // namespace
}  // namespace ink::harness
