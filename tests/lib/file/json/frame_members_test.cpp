#include "lib/file/json/frame_members.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(FrameMembers, GiveWhatStandsBesideAFrameToThoseWhoAsk) {
  constexpr const char* kText = R"({"time": 1, "blendShapes": {"jawOpen": 0.5}, "headYaw": 0.25})";
  const FaceLimits limits;
  const auto tree = JsonTree::read(kText, "f", limits, 70'000);
  ASSERT_TRUE(tree);
  const Reading in(*tree, limits, nullptr);
  std::vector<FrameMember> beside;
  const auto members = frame_members(in, tree->root(), &beside);
  ASSERT_EQ(members.size(), 1u);
  EXPECT_EQ(members[0].name, "jawOpen");
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_EQ(beside[0].name, "headYaw");
  EXPECT_EQ(tree->where(*beside[0].value), "f:70000:57: /headYaw") << "lines of the whole file";
  EXPECT_THROW(frame_members(in, tree->root()), Refusal);
}

}  // namespace
}  // namespace mien
