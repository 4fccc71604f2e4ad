#include "core/hash.h"

#include <gtest/gtest.h>

#include <numeric>

namespace ink::core {
namespace {

TEST(Hasher, LengthIsPartOfText) {
    EXPECT_NE(Hasher().text("ab").text("c").result(), Hasher().text("a").text("bc").result());
}

TEST(Hasher, SameBytesSameHashInAnyChunksOfEight) {
    const char bytes[] = "0123456789abcdefXYZ";
    const auto whole = Hasher().bytes(bytes, 19).result();
    EXPECT_EQ(whole, Hasher().bytes(bytes, 8).bytes(bytes + 8, 11).result());
    EXPECT_NE(whole, Hasher().bytes(bytes, 18).result());
}

TEST(Hasher, GoldenValueDoesNotChangeBetweenVersions) {
    EXPECT_EQ(Hasher().text("inkbench").hex(), "25a8f370f9f92617");
}

TEST(ImageHash, TellsSizeFromContent) {
    EXPECT_NE(image_hash(Image<int>(2, 3)), image_hash(Image<int>(3, 2)));
}

TEST(ImageHashes, AreThoseOfTheImagesOneByOne) {
    // Seven of a size whose bytes are no multiple of eight, then others.
    std::vector<Image<std::uint8_t>> images(7, Image<std::uint8_t>(13, 3));
    images.emplace_back();
    images.emplace_back(3, 13);
    std::vector<const Image<std::uint8_t>*> all;
    std::vector<std::string> expected;
    for (Image<std::uint8_t>& image : images) {
        std::iota(image.data(), image.data() + image.size(), static_cast<std::uint8_t>(all.size()));
        all.push_back(&image);
        expected.push_back(image_hash(image));
    }
    EXPECT_EQ(image_hashes<std::uint8_t>(all), expected);
    EXPECT_TRUE(image_hashes<std::uint8_t>({}).empty());
}

}  // namespace
}  // namespace ink::core
