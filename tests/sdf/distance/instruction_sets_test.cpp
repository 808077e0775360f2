#include "sdf/distance/instruction_sets.h"

#include <gtest/gtest.h>

namespace mien::batch {
namespace {

TEST(InstructionSets, ThePortableOneIsAlwaysThereAndOnlyNewOnesFuse) {
  const auto sets = instruction_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_EQ(sets.back().name, "SCALAR");
  EXPECT_FALSE(sets.back().fused);
  for (const InstructionSet& set : sets) {
    const bool is_new = set.name == "AVX3" || set.name == "AVX2";
    EXPECT_EQ(set.fused, is_new) << set.name;
  }
}

}  // namespace
}  // namespace mien::batch
