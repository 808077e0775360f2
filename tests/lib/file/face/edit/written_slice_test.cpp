#include <gtest/gtest.h>

#include <array>
#include <string>

#include "lib/file/face/edit/written_slice_private.h"
#include "lib/picture/color_text.h"
#include "lib/picture/srgb.h"

namespace mien {
namespace {

/// A list of one value, rewritten.
std::string rewritten(const std::string& text, SliceKind kind, const std::vector<double>& values) {
  const auto tree = JsonTree::read(text, "t", {});
  if (!tree) return sentence(tree.error());
  Slice slice{.kind = kind, .size = int(values.size())};
  TextEdits to(text);
  write_slice(*tree, *tree->first(tree->root()), slice, values, to);
  return to.text();
}

std::vector<double> numbers(const Color& c) {
  return {c.r, c.g, c.b, c.a};
}

TEST(WrittenSlice, LeavesWhatIsRightAlready) {
  EXPECT_EQ(rewritten("[ [1.50, -2] ]", SliceKind::point, {1.5, -2.25}), "[ [1.50, -2.25] ]");
  EXPECT_EQ(rewritten(R"([[1, 2,"bend"]])", SliceKind::point, {3, 2}), R"([[3, 2,"bend"]])");
  EXPECT_EQ(rewritten("[0.10]", SliceKind::length, {0.1}), "[0.10]");
  EXPECT_EQ(rewritten("[0.10]", SliceKind::length, {0.2}), "[0.2]");
  EXPECT_EQ(rewritten(R"([[[0, "a"], [1.0, "b"]]])", SliceKind::ratio, {0.5, 1}),
            R"([[[0.5, "a"], [1.0, "b"]]])");
}

TEST(WrittenSlice, SpellsColoursAsTheFileDoes) {
  const std::vector<double> plain = numbers(*color_from_text("#c98a5e"));
  EXPECT_EQ(rewritten(R"(["#000000"])", SliceKind::color, plain), R"(["#c98a5e"])");
  EXPECT_EQ(rewritten(R"([[0, 0, 0]])", SliceKind::color, plain), "[[201, 138, 94]]");
  const std::vector<double> clear = numbers(*color_from_text("#c98a5e80"));
  EXPECT_EQ(rewritten(R"(["#000000"])", SliceKind::color, clear), R"(["#c98a5e80"])");
  EXPECT_EQ(rewritten(R"([[0, 0, 0]])", SliceKind::color, clear), "[[201, 138, 94, 128]]");
}

// A colour between those of eight bits reads back within a few roundings.
TEST(WrittenSlice, SpellsOtherColoursAsChannels) {
  const std::vector<double> wanted{0.123, 0.0012, 0.987, 0.3};
  const std::string text = rewritten(R"(["#000000"])", SliceKind::color, wanted);
  const auto tree = JsonTree::read(text, "t", {});
  ASSERT_TRUE(tree) << text;
  std::array<double, 4> c{};
  const JsonNode* channel = tree->first(*tree->first(tree->root()));
  for (double& one : c) one = channel->number, channel = tree->next(*channel);
  const std::vector<double> read = numbers(color_from_srgb255(c[0], c[1], c[2], c[3]));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(read[i], wanted[i], 1e-15) << text;
}

TEST(WrittenSlice, MirrorsOnlyWhatReadsBackExactly) {
  const std::array<double, 2> plain{0.25, 0.5}, tiny{1e-20, 0.5};
  EXPECT_EQ(written_mirrored(SliceKind::point, plain, 0), (std::vector<double>{-0.25, 0.5}));
  EXPECT_EQ(written_mirrored(SliceKind::point, plain, 2), (std::vector<double>{1.75, 0.5}));
  EXPECT_FALSE(written_mirrored(SliceKind::point, tiny, 2));
  EXPECT_EQ(written_mirrored(SliceKind::length, plain, 2), (std::vector<double>{0.25, 0.5}));
}

}  // namespace
}  // namespace mien
