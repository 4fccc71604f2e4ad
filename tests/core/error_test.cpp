#include "core/error.h"

#include <gtest/gtest.h>

namespace ink::core {
namespace {

TEST(Error, JoinsPlaceFaultAndRemedy) {
    EXPECT_STREQ(Error("file.toml:3", "size is 0", "1..9").what(),
                 "file.toml:3: size is 0 (accepted: 1..9)");
    EXPECT_STREQ(Error("file.toml", "it is empty").what(), "file.toml: it is empty");
}

TEST(Error, IsOneLineWhateverAFileHolds) {
    const Error error("a\nb.toml", "there is no 'c\r\x1b[1m\x7f'", "\t, caf\xc3\xa9");
    EXPECT_STREQ(error.what(), "a?b.toml: there is no 'c??[1m?' (accepted: ?, caf\xc3\xa9)");
    EXPECT_EQ(error.where(), "a\nb.toml") << "the path itself stays";
}

}  // namespace
}  // namespace ink::core
