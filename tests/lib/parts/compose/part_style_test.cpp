#include "lib/parts/compose/part_style.h"

#include <gtest/gtest.h>

#include "lib/file/json/json_copy.h"
#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

class PartStyleTest : public testing::Test {
 protected:
  /// What a style adds to a feature, as text.
  std::string members(const std::string& style, const std::string& feature, bool painted = false,
                      PartStyle::Members which = PartStyle::Members::all) {
    test::SmallLibrary small;
    small.topology = test::with(small.topology, "\"soft\": {}", "\"soft\": {" + style + "}");
    small.topology =
        test::with(small.topology, "\"features\": []", "\"features\": [{" + feature + "}]");
    library_ = small.read().value();
    const Reading& in = library_->topology().in();
    const PartStyle read(*library_, "soft");
    JsonTree tree("members");
    TreeWriter out(tree);
    out.object();
    read.write_members(
        read.role(in, *in.tree.first(in.need(*library_->topology().node, "features"))), painted,
        which, [](const JsonNode&) { return false; }, out);
    out.close();
    std::string text;
    add_json(tree, tree.root(), text);
    return text;
  }

  std::unique_ptr<PartLibrary> library_;
};

constexpr const char* kHair = R"("name": "fringe", "slot": "front", "role": "hair.line")";

TEST_F(PartStyleTest, ARoleIsPaintedWithItsColour) {
  EXPECT_EQ(members("", kHair), R"({"paint": "hair_line"})");
  EXPECT_EQ(members("", kHair, true), "{}") << "the part has a paint";
}

/// The nearer a sheet is to the feature, the later it speaks.
TEST_F(PartStyleTest, SheetsGoFromRoleToName) {
  const std::string role = R"("hair.line": {"paint": "a", "opacity": 0.1})",
                    slot = R"("front/*": {"paint": "b"})",
                    both = R"("front/hair.line": {"paint": "c"})";
  const auto roles = [](const std::string& sheets) { return "\"roles\": {" + sheets + "}"; };
  EXPECT_EQ(members(roles(role), kHair), R"({"paint": "a", "opacity": 0.1})");
  EXPECT_EQ(members(roles(role + "," + slot), kHair), R"({"opacity": 0.1, "paint": "b"})");
  EXPECT_EQ(members(roles(role + "," + slot + "," + both), kHair),
            R"({"opacity": 0.1, "paint": "c"})");
  EXPECT_EQ(members(roles(both) + R"(, "features": {"fringe": {"paint": "d"}})", kHair),
            R"({"paint": "d"})");
  EXPECT_EQ(members(roles(both) + R"(, "features": {"fringe": {"paint": null}})", kHair), "{}")
      << "null takes a member away";
}

TEST_F(PartStyleTest, WhatIsGoneHasNoPaint) {
  const char* sheet = R"("roles": {"hair.line": {"paint": "a", "contour": {}, "half_width": 2}})";
  for (const char* gone : {R"("gone": ["hair.line"], )", R"("gone": ["front/*"], )",
                           R"("gone": ["front/hair.line"], )", R"("drawn": ["hair"], )"})
    EXPECT_EQ(members(std::string(gone) + sheet, kHair), R"({"half_width": 2})") << gone;
  for (const char* there : {R"("gone": ["hair", "back/*"], )", R"("drawn": ["front/*"], )"})
    EXPECT_NE(members(std::string(there) + sheet, kHair).find("paint"), std::string::npos) << there;
}

/// The rig moves gradients: they stay, and are not seen.
TEST_F(PartStyleTest, AGradientThatIsGoneIsInvisible) {
  const std::string iris = std::string(kHair) + R"(, "paint": {"gradient": "radial"})";
  EXPECT_EQ(members(R"("gone": ["hair.line"])", iris, true), R"({"opacity": 0})");
}

TEST_F(PartStyleTest, FiguresAndPaintsAreApart) {
  const char* sheet = R"("roles": {"hair.line": {"opacity": 1, "contour": {}, "half_width": 2}})";
  EXPECT_EQ(members(sheet, kHair, false, PartStyle::Members::figure), R"({"half_width": 2})");
  EXPECT_EQ(members(sheet, kHair, false, PartStyle::Members::paint),
            R"({"opacity": 1, "contour": {}, "paint": "hair_line"})");
}

TEST_F(PartStyleTest, AHandDrawsInItsSlots) {
  members(R"("hand": {"amplitude": 0.01, "width": 0.2, "slots": ["front"]})", kHair);
  const PartStyle style(*library_, "soft", 7);
  EXPECT_NE(style.hand("front"), nullptr);
  EXPECT_EQ(style.hand("back"), nullptr);
}

}  // namespace
}  // namespace mien
