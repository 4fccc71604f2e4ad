#include "image_io/image_file.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "core/error.h"
#include "image_io/exr_file.h"
#include "image_io/open_image_io.h"
#include "tests/core/error_text.h"
#include "tests/core/temp_folder.h"

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
    const auto values = floats({0, 0.21586F, 1, 7, -2});
    write_exr({{{"Y", values}}, {}}, file("light.exr"));
    const auto picture = read_picture(file("light.exr"));
    constexpr std::uint8_t kShown[] = {0, 128, 255, 255, 0};
    for (int x = 0; x < 5; ++x)
        EXPECT_EQ(picture.colour.at(x, 0), Rgb(kShown[x])) << x;
}

TEST_F(ImageFile, APictureHasNoValueThatIsNoNumber) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const auto refused = [&](float value, float alpha) {
        ink::core::Image<float> light(3, 2, 0.5F);
        ink::core::Image<float> cover(3, 2, 1.0F);
        light.at(2, 1) = value;
        cover.at(1, 0) = alpha;
        write_exr({{{"A", cover}, {"Y", light}}, {}}, file("a.exr"));
        return ink::core::error_text([&] { return read_picture(file("a.exr")); });
    };
    EXPECT_EQ(refused(2, 1), "");
    EXPECT_THAT(refused(std::nanf(""), 1),
                testing::HasSubstr("channel Y is not a number at pixel 2,1"));
    for (const float infinite : {kInfinity, -kInfinity})
        EXPECT_THAT(refused(infinite, 1), testing::HasSubstr("channel Y is infinite at pixel 2,1"));
    EXPECT_THAT(refused(1, std::nanf("")),
                testing::HasSubstr("channel A is not a number at pixel 1,0"));
}

/// Numbers of so many bytes each, the lowest byte first.
void put(std::vector<std::uint8_t>& bytes, int n_bytes, const std::vector<unsigned>& values) {
    for (const unsigned value : values) {
        for (int i = 0; i < n_bytes; ++i)
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
}

using Bytes = std::vector<std::uint8_t>;

Bytes with_pixels(Bytes header, const Gray& image) {
    header.insert(header.end(), image.data(), image.data() + image.size());
    return header;
}

/// A TIFF of strips whose directory comes before them.
Bytes tiff_of(const Gray& image) {
    constexpr unsigned kStripRows = 16;
    const auto width = static_cast<unsigned>(image.width_px());
    const auto height = static_cast<unsigned>(image.height_px());
    const unsigned strips = height / kStripRows;
    constexpr unsigned kEntries = 9;
    constexpr unsigned kOffsets = 8 + 2 + 12 * kEntries + 4;
    const unsigned counts = kOffsets + 4 * strips;
    const unsigned pixels = counts + 4 * strips;
    Bytes file = {'I', 'I', 42, 0};
    put(file, 4, {8});
    put(file, 2, {kEntries});
    const auto entry = [&](unsigned tag, unsigned count, unsigned value) {
        put(file, 2, {tag, 4});
        put(file, 4, {count, value});
    };
    entry(256, 1, width);
    entry(257, 1, height);
    entry(258, 1, 8);  // bits
    entry(259, 1, 1);  // not compressed
    entry(262, 1, 1);  // black is 0
    entry(273, strips, kOffsets);
    entry(277, 1, 1);  // grey
    entry(278, 1, kStripRows);
    entry(279, strips, counts);
    put(file, 4, {0});
    for (unsigned i = 0; i < strips; ++i)
        put(file, 4, {pixels + i * kStripRows * width});
    for (unsigned i = 0; i < strips; ++i)
        put(file, 4, {kStripRows * width});
    return with_pixels(file, image);
}

/// One image in every format whose pixels come behind what tells of them; writes into `folder`.
std::map<std::string, Bytes> files_of(const Gray& image, const fs::path& folder) {
    std::map<std::string, Bytes> files = {{"a.tif", tiff_of(image)}};
    const Colour colours = ink::core::mapped<Rgb>(image, [](std::uint8_t v) { return Rgb(v); });
    for (const char* name : {"a.ppm", "a.jpg", "a.tga", "a.bmp", "a.hdr"}) {
        const std::string path = folder / name;
        const auto output = OIIO::ImageOutput::create(path);
        const OIIO::ImageSpec spec(image.width_px(), image.height_px(), 3, OIIO::TypeDesc::UINT8);
        EXPECT_TRUE(output && output->open(path, spec) &&
                    output->write_image(OIIO::TypeDesc::UINT8, colours.data()) && output->close())
            << name;
        files[name] = bytes_of(path);
    }
    return files;
}

TEST_F(ImageFile, NoFormatIsReadWhereItIsCutOff) {
    std::map<std::string, Bytes> files = files_of(noise(), folder_.path());
    ink::core::Image<float> light(64, 64);
    const Gray grey = noise();
    std::transform(grey.data(), grey.data() + grey.size(), light.data(), [](int v) {
        return static_cast<float>(v) / 255;
    });
    write_exr({{{"Y", light}}, {}}, file("whole.exr"));
    files["a.exr"] = bytes_of(file("whole.exr"));
    for (const auto& [name, whole] : files) {
        SCOPED_TRACE(name);
        const Colour pixels = read_picture(file_of(name, whole)).colour;
        EXPECT_GT(std::set<int>(&pixels.data()->r, &pixels.data()->r + 3 * pixels.size()).size(),
                  9U);
        const auto cut_at = [&](std::size_t kept) {
            return file_of("cut" + name.substr(1),
                           {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(kept)});
        };
        const std::size_t step = whole.size() / 40 + 1;
        for (std::size_t kept = 1; kept < whole.size(); kept += step) {
            const fs::path cut = cut_at(kept);
            try {
                EXPECT_EQ(read_picture(cut).colour, pixels) << kept;
            } catch (const ink::core::Error& error) {
                EXPECT_EQ(error.where(), cut.string());
            }
        }
        EXPECT_THAT(
            ink::core::error_text([&] { return read_picture(cut_at(whole.size() * 3 / 4)); }),
            testing::HasSubstr("the file is cut off"));
    }
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

}  // namespace
