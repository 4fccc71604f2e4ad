#include "core/hash.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace ink::core
