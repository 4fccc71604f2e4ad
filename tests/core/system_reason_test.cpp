#include "core/whole_file.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace ink::core {
namespace {

TEST(SystemReason, CallsAFullDiskByItsName) {
    EXPECT_EQ(system_reason(ENOSPC), "disk full (no space left on device)");
    EXPECT_EQ(system_reason(EACCES), "permission denied");
    EXPECT_EQ(system_reason(0), "unknown reason");
}

}  // namespace
}  // namespace ink::core
