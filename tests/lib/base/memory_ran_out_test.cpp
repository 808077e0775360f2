#include "lib/base/memory_ran_out.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/process/allocations.h"

namespace mien {
namespace {

TEST(MemoryRanOut, IsTold) {
  EXPECT_EQ(sentence(memory_ran_out("a.json")), "a.json: memory ran out");
}

TEST(MemoryRanOut, IsToldWithoutMemory) {
  const long before = test::allocations();
  const Error error = memory_ran_out();
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(error.what, kMemoryRanOut);
}

}  // namespace
}  // namespace mien
