#include "image_io/image_file.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "core/error.h"
#include "image_io/exr_file.h"
#include "image_io/picture_file.h"
#include "tests/core/temp_folder.h"
#include "tests/score/oracle_files.h"

namespace {

namespace fs = std::filesystem;
using ink::image_io::encode_png;
using ink::image_io::read_gray;
using ink::image_io::read_picture;
using ink::image_io::Rgb;
using ink::image_io::write_exr;
using ink::image_io::write_png;
using Gray = ink::core::Image<std::uint8_t>;
using Colour = ink::core::Image<Rgb>;

class ImageFile : public testing::Test {
  protected:
    fs::path file(const std::string& name) const { return folder_ / name; }
    fs::path file_of(const std::string& name, const std::vector<std::uint8_t>& bytes) const {
        std::ofstream out(file(name), std::ios::binary);
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
        return file(name);
    }
    std::size_t files_in_folder() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), {}));
    }

    const ink::core::TempFolder folder_;
};

/// The message of the Error that reading `path` throws; "" if none.
std::string refusal_of(const fs::path& path) {
    try {
        static_cast<void>(read_gray(path));
    } catch (const ink::core::Error& error) {
        EXPECT_EQ(error.where(), path.string());
        return error.what();
    }
    return "";
}

Gray every_value() {
    Gray image(16, 16);
    for (std::size_t i = 0; i < image.size(); ++i)
        image.data()[i] = static_cast<std::uint8_t>(i);
    return image;
}

/// A noisy image, so that its file does not fit into a few hundred bytes.
Gray noise() {
    Gray image(64, 64);
    unsigned state = 1;
    for (std::size_t i = 0; i < image.size(); ++i) {
        state = state * 1664525U + 1013904223U;
        image.data()[i] = static_cast<std::uint8_t>(state >> 24);
    }
    return image;
}

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(ImageFile, KeepsEveryGreyAsItIs) {
    write_png(every_value(), file("grey.png"));
    EXPECT_EQ(read_gray(file("grey.png")), every_value());
}

TEST_F(ImageFile, ReadsColourAsLuma) {
    Colour image(5, 1);
    image.at(0, 0) = {255, 0, 0};
    image.at(1, 0) = {0, 255, 0};
    image.at(2, 0) = {0, 0, 255};
    image.at(3, 0) = {255, 255, 255};
    image.at(4, 0) = {10, 20, 30};
    write_png(image, file("colour.png"));
    const Gray gray = read_gray(file("colour.png"));
    EXPECT_EQ(gray.at(0, 0), 76);   // 0.299 * 255
    EXPECT_EQ(gray.at(1, 0), 150);  // 0.587 * 255 = 149.7
    EXPECT_EQ(gray.at(2, 0), 29);   // 0.114 * 255
    EXPECT_EQ(gray.at(3, 0), 255);
    EXPECT_EQ(gray.at(4, 0), 18);  // 2.99 + 11.74 + 3.42 = 18.15
}

TEST_F(ImageFile, EncodesTheBytesThatItWrites) {
    write_png(noise(), file("noise.png"));
    const auto bytes = encode_png(noise());
    EXPECT_EQ(bytes_of(file("noise.png")), bytes);
    EXPECT_EQ(encode_png(noise()), bytes);
    ASSERT_GT(bytes.size(), 8U);
    EXPECT_EQ(std::string(bytes.begin() + 1, bytes.begin() + 4), "PNG");
    EXPECT_EQ(bytes[25], 0);  // colour type of the header: grey, no palette and no alpha
    EXPECT_EQ(encode_png(Colour(3, 2))[25], 2);
}

TEST_F(ImageFile, LeavesNothingBesideWhatItWrote) {
    write_png(noise(), file("a.png"));
    write_png(every_value(), file("a.png"));
    EXPECT_EQ(files_in_folder(), 1U);
    EXPECT_EQ(read_gray(file("a.png")), every_value());
}

TEST_F(ImageFile, LeavesNothingWhereItCannotWrite) {
    EXPECT_THROW(write_png(noise(), file("no/such/folder/a.png")), ink::core::Error);
    // A folder in the file's place lets the file beside it be written, but not renamed.
    fs::create_directory(file("taken.png"));
    EXPECT_THROW(write_png(noise(), file("taken.png")), ink::core::Error);
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(ImageFile, LeavesNothingOfAnEmptyImage) {
    EXPECT_THROW(write_png(Gray(), file("empty.png")), ink::core::Error);
    EXPECT_THROW(static_cast<void>(encode_png(Colour(0, 5))), ink::core::Error);
    EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(ImageFile, RefusesWhatIsNoImage) {
    EXPECT_THAT(refusal_of(file("missing.png")), testing::HasSubstr("no such file"));
    EXPECT_THAT(refusal_of(folder_.path()), testing::HasSubstr("not a file"));
    EXPECT_THAT(refusal_of(file_of("empty.png", {})), testing::HasSubstr("empty"));
    const std::string text = "v 0 0 0\nf 1 2 3\n";
    EXPECT_NE(refusal_of(file_of("text.png", {text.begin(), text.end()})), "");
    EXPECT_NE(refusal_of(file_of("text.obj", {text.begin(), text.end()})), "");
    EXPECT_THAT(refusal_of(file("missing.png")), testing::Not(testing::HasSubstr("\n")));
}

TEST_F(ImageFile, RefusesAnImageThatIsCutOffAnywhere) {
    const auto whole = encode_png(noise());
    for (std::size_t kept = 8; kept < whole.size(); kept += 97) {
        const std::vector<std::uint8_t> cut(whole.begin(),
                                            whole.begin() + static_cast<std::ptrdiff_t>(kept));
        EXPECT_THAT(refusal_of(file_of("cut.png", cut)), testing::HasSubstr("cut off")) << kept;
    }
    std::vector<std::uint8_t> without_end = whole;
    without_end.pop_back();
    EXPECT_THAT(refusal_of(file_of("cut.png", without_end)), testing::HasSubstr("cut off"));
}

/// A portable anymap: the one format whose files can be written down.
std::vector<std::uint8_t> anymap(const std::string& header, std::size_t n_bytes) {
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    bytes.insert(bytes.end(), n_bytes, 1);
    return bytes;
}

TEST_F(ImageFile, RefusesSixteenBitsAndAbsurdSizes) {
    EXPECT_THAT(refusal_of(file_of("deep.pgm", anymap("P5\n2 2\n65535\n", 8))),
                testing::HasSubstr("not 8-bit"));
    EXPECT_THAT(refusal_of(file_of("huge.pgm", anymap("P5\n100000 100000\n255\n", 8))),
                testing::ContainsRegex("100000 ?x ?100000"));
}

TEST_F(ImageFile, KeepsTexts) {
    write_png(every_value(), file("texts.png"), {{"ink:band_px", "6"}, {"ink:command", "a 'b c'"}});
    const auto read = ink::image_io::read_gray_file(file("texts.png"));
    EXPECT_EQ(read.pixels, every_value());
    EXPECT_EQ(read.texts.at("ink:band_px"), "6");
    EXPECT_EQ(read.texts.at("ink:command"), "a 'b c'");
}

TEST_F(ImageFile, APictureMayHaveSixteenBits) {
    std::vector<std::uint8_t> bytes = anymap("P5\n3 1\n65535\n", 0);
    for (const int v : {0, 0x80, 0xff})
        bytes.insert(bytes.end(), 2, static_cast<std::uint8_t>(v));
    const auto picture = read_picture(file_of("deep.pgm", bytes));
    EXPECT_THAT(picture.notes, testing::ElementsAre("16 bits rounded to 8"));
    EXPECT_EQ(picture.colour.at(0, 0), Rgb(0));
    EXPECT_EQ(picture.colour.at(1, 0), Rgb(128));
    EXPECT_EQ(picture.colour.at(2, 0), Rgb(255));
    EXPECT_TRUE(picture.alpha.is_empty());
}

/// A row of floats.
ink::core::Image<float> floats(const std::vector<float>& values) {
    ink::core::Image<float> image(static_cast<int>(values.size()), 1);
    std::copy(values.begin(), values.end(), image.data());
    return image;
}

TEST_F(ImageFile, APictureOfFloatsIsWhatAScreenShows) {
    const auto values = floats({0, 0.21586F, 1, 7, std::nanf("")});
    write_exr({{{"Y", values}}, {}}, file("light.exr"));
    const auto picture = read_picture(file("light.exr"));
    constexpr std::uint8_t kShown[] = {0, 128, 255, 255, 0};
    for (int x = 0; x < 5; ++x)
        EXPECT_EQ(picture.colour.at(x, 0), Rgb(kShown[x])) << x;
}

TEST_F(ImageFile, APictureOfLightHasItsAlphaTakenOut) {
    write_exr({{{"A", floats({0.5F, 0})}, {"Y", floats({0.5F, 0})}}, {}}, file("alpha.exr"));
    const auto picture = read_picture(file("alpha.exr"));
    EXPECT_EQ(picture.colour.at(0, 0), Rgb(255));
    EXPECT_EQ(picture.alpha.at(0, 0), 128);
    EXPECT_EQ(picture.alpha.at(1, 0), 0);
}

TEST_F(ImageFile, OfLayersAPictureIsTheFirstInColour) {
    const auto one = floats({1});
    write_exr({{{"View.Combined.R", one},
                {"View.Combined.G", floats({0})},
                {"View.Combined.B", floats({0})},
                {"View.Depth.Y", floats({3})}},
               {}},
              file("layers.exr"));
    const auto picture = read_picture(file("layers.exr"));
    EXPECT_EQ(picture.colour.at(0, 0), Rgb(255, 0, 0));
    EXPECT_THAT(picture.notes, testing::Contains("layer View.Combined of it"));
    write_exr({{{"id", ink::core::Image<std::uint32_t>(2, 2)}}, {}}, file("ids.exr"));
    EXPECT_THROW((void)read_picture(file("ids.exr")), ink::core::Error);
}

TEST_F(ImageFile, ReadsWhatTheOraclesOwnReaderReads) {
    const Gray labels = read_gray(oracle_file("cases/classes.gt.png"));
    EXPECT_EQ(labels.width_px(), 200);
    EXPECT_EQ(labels.height_px(), 160);
    std::array<int, 256> n_of{};
    for (std::size_t i = 0; i < labels.size(); ++i)
        ++n_of[labels.data()[i]];
    EXPECT_EQ(n_of[1], 228);
    EXPECT_EQ(n_of[2], 151);
    EXPECT_EQ(n_of[3], 61);
    EXPECT_EQ(n_of[4], 181);
}

}  // namespace
