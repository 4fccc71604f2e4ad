#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/house_rules.h"

namespace ink::house {
namespace {

using testing::IsEmpty;

const SourceTree& project() {
    static const SourceTree tree = read_tree(INK_SOURCE_DIR);
    return tree;
}

TEST(House, IsReadWhole) {
    EXPECT_NE(project().find("CMakeLists.txt"), nullptr);
    EXPECT_NE(project().find("src/core/image.h"), nullptr);
    EXPECT_NE(project().find("tests/house/house_test.cpp"), nullptr);
    EXPECT_EQ(project().find("build/release/build.ninja"), nullptr);
}

TEST(House, IncludesFollowTheArrowsOfTheRooms) {
    EXPECT_THAT(check_arrows(project()), IsEmpty());
}

TEST(House, EachForeignLibraryHasOneDoor) {
    EXPECT_THAT(check_libraries(project()), IsEmpty());
}

TEST(House, FoldersAreRooms) {
    EXPECT_THAT(check_folders(project()), IsEmpty());
}

TEST(House, NoFolderIsTooLarge) {
    EXPECT_THAT(check_sizes(project()), IsEmpty());
}

TEST(House, EveryMethodIsWholeAndRegistered) {
    EXPECT_THAT(check_methods(project()), IsEmpty());
}

TEST(House, HeadersAreGuarded) {
    EXPECT_THAT(check_headers(project()), IsEmpty());
}

TEST(House, NoFlagChangesTheImage) {
    EXPECT_THAT(check_flags(project()), IsEmpty());
}

TEST(House, TextKnowsNoMachine) {
    EXPECT_THAT(check_words(project()), IsEmpty());
}

TEST(House, ReadmeIsShort) {
    EXPECT_THAT(check_readme(project()), IsEmpty());
}

TEST(House, PagesAreInPlainWords) {
    EXPECT_THAT(check_prose(project()), IsEmpty());
}

}  // namespace
}  // namespace ink::house
