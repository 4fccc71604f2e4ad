#include "image_io/exr_file.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <limits>
#include <map>

#include "core/error.h"
#include "core/whole_file.h"
#include "image_io/image_file.h"
#include "tests/core/temp_folder.h"
#include "tests/image_io/display_window.h"

namespace ink::image_io {
namespace {

namespace fs = std::filesystem;

class Exr : public testing::Test {
  protected:
    [[nodiscard]] fs::path file(const std::string& file_name) const { return folder_ / file_name; }

    const core::TempFolder folder_;
};

/// 3 x 2 px: ids with the largest one, depths with infinity, and a grey.
ExrFile small_file() {
    core::Image<std::uint32_t> ids(3, 2, 0xffffffffU);
    ids.at(0, 0) = 16777217;  // no float holds it
    ids.at(2, 1) = 7;
    core::Image<float> depth(3, 2, std::numeric_limits<float>::infinity());
    depth.at(1, 0) = 0.1F;
    core::Image<float> gray(3, 2, 0);
    gray.at(1, 1) = 0.5F;
    gray.at(2, 1) = 0.1F;
    ExrFile file;
    file.channels = {{"id.triangle", ids}, {"Z", depth}, {"sampled.Y", HalfImage{gray}}};
    file.attributes = {{"ink:scene", "cube \"one\""}, {"ink:crease_deg", 40.25}};
    return file;
}

TEST_F(Exr, ReadsBackEveryChannelInItsOwnType) {
    write_exr(small_file(), file("a.exr"));
    const ExrFile back = read_exr(file("a.exr"));
    ASSERT_EQ(back.channels.size(), 3U);
    EXPECT_EQ(back.channels[0].name, "Z");
    EXPECT_EQ(back.channels[1].name, "id.triangle");
    EXPECT_EQ(back.channels[2].name, "sampled.Y");
    const auto* depth = std::get_if<core::Image<float>>(&back.channels[0].pixels);
    const auto* ids = std::get_if<core::Image<std::uint32_t>>(&back.channels[1].pixels);
    const auto* gray = std::get_if<HalfImage>(&back.channels[2].pixels);
    ASSERT_TRUE(depth != nullptr && ids != nullptr && gray != nullptr);
    EXPECT_EQ(depth->at(1, 0), 0.1F);
    EXPECT_EQ(depth->at(0, 1), std::numeric_limits<float>::infinity());
    EXPECT_EQ(ids->at(0, 0), 16777217U);
    EXPECT_EQ(ids->at(2, 1), 7U);
    EXPECT_EQ(ids->at(1, 0), 0xffffffffU);
    EXPECT_EQ(gray->pixels.at(1, 1), 0.5F);
    EXPECT_NEAR(gray->pixels.at(2, 1), 0.1F, 1.0 / 16384) << "rounded to 11 bits";
}

TEST_F(Exr, KeepsItsAttributes) {
    write_exr(small_file(), file("a.exr"));
    std::map<std::string, std::variant<std::string, double, std::array<float, 16>>> found;
    for (const ExrAttribute& attribute : read_exr(file("a.exr")).attributes)
        found[attribute.name] = attribute.value;
    ASSERT_TRUE(found.contains("ink:scene") && found.contains("ink:crease_deg"));
    EXPECT_EQ(std::get<std::string>(found.at("ink:scene")), "cube \"one\"");
    EXPECT_EQ(std::get<double>(found.at("ink:crease_deg")), 40.25);
}

TEST_F(Exr, IsItsDisplayWindow) {
    core::Image<float> light(4, 3);
    core::Image<std::uint32_t> ids(4, 3);
    for (int i = 0; i < 12; ++i) {
        light.data()[i] = static_cast<float>(i + 1) / 16;
        ids.data()[i] = static_cast<std::uint32_t>(i + 1);
    }
    write_exr({{{"Y", light}, {"id", ids}}, {}}, file("whole.exr"));
    const Picture whole = read_picture(file("whole.exr"));
    EXPECT_TRUE(whole.alpha.is_empty());
    // As written, a crop, overscan, both, and a window beside all pixels.
    const std::array<std::int32_t, 4> windows[] = {
        {0, 0, 3, 2}, {-2, -1, 5, 4}, {1, 1, 2, 1}, {1, -3, 9, 1}, {-9, 0, -2, 3}, {2, 2, 3, 9}};
    for (const auto& window : windows) {
        SCOPED_TRACE(testing::PrintToString(window));
        write_exr({{{"Y", light}, {"id", ids}}, {}}, file("a.exr"));
        set_display_window(file("a.exr"), window);
        const ExrFile read = read_exr(file("a.exr"));
        const Picture picture = read_picture(file("a.exr"));
        const auto& read_light = std::get<core::Image<float>>(read.channels[0].pixels);
        const auto& read_ids = std::get<core::Image<std::uint32_t>>(read.channels[1].pixels);
        const int width = window[2] - window[0] + 1;
        const int height = window[3] - window[1] + 1;
        ASSERT_EQ(read_light.width_px(), width);
        ASSERT_EQ(read_ids.height_px(), height);
        ASSERT_EQ(picture.colour.width_px(), width);
        ASSERT_EQ(picture.colour.height_px(), height);
        bool holds_all = true;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const int from_x = x + window[0];
                const int from_y = y + window[1];
                const bool is_held = light.contains(from_x, from_y);
                holds_all = holds_all && is_held;
                EXPECT_EQ(read_light.at(x, y), is_held ? light.at(from_x, from_y) : 0);
                EXPECT_EQ(read_ids.at(x, y), is_held ? ids.at(from_x, from_y) : 0);
                if (is_held) {
                    EXPECT_EQ(picture.colour.at(x, y), whole.colour.at(from_x, from_y));
                } else {
                    ASSERT_FALSE(picture.alpha.is_empty());
                    EXPECT_EQ(picture.alpha.at(x, y), 0);
                }
            }
        }
        EXPECT_EQ(picture.alpha.is_empty(), holds_all);
    }
}

TEST_F(Exr, IsTheSameFileTwice) {
    write_exr(small_file(), file("a.exr"));
    write_exr(small_file(), file("b.exr"));
    const auto bytes = core::read_whole_file(file("a.exr"));
    EXPECT_GT(bytes.value_or("").size(), 100U);
    for (const ExrAttribute& attribute : read_exr(file("a.exr")).attributes) {
        EXPECT_FALSE(attribute.name == "DateTime" && std::get<std::string>(attribute.value) != "")
            << "or tomorrow's file differs";
    }
    EXPECT_EQ(bytes, core::read_whole_file(file("b.exr")));
}

TEST_F(Exr, RefusesAnEmptyImageAndLeavesNothing) {
    EXPECT_THROW(write_exr({}, file("a.exr")), core::Error);
    ExrFile empty;
    empty.channels = {{"Y", core::Image<float>()}};
    EXPECT_THROW(write_exr(empty, file("a.exr")), core::Error);
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(Exr, RefusesAFolderThatIsNotThere) {
    EXPECT_THROW(write_exr(small_file(), file("none") / "a.exr"), core::Error);
}

TEST_F(Exr, RefusesToReadWhatIsNone) {
    EXPECT_THROW(static_cast<void>(read_exr(file("none.exr"))), core::Error);
    std::ofstream(file("text.exr")) << "not an image";
    EXPECT_THROW(static_cast<void>(read_exr(file("text.exr"))), core::Error);
    write_exr(small_file(), file("a.exr"));
    fs::resize_file(file("a.exr"), fs::file_size(file("a.exr")) - 20);
    EXPECT_THROW(static_cast<void>(read_exr(file("a.exr"))), core::Error);
}

}  // namespace
}  // namespace ink::image_io
