#include "render/image/file/system_error.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace mien {
namespace {

TEST(SystemError, IsWhatPeopleKnow) {
  EXPECT_EQ(system_error(ENOSPC), "No space left on device");
}

}  // namespace
}  // namespace mien
