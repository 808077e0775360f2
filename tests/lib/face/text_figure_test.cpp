#include <mien/text_figure.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mien {
namespace {

TEST(TextFigure, HasThreeSlices) {
  std::vector<std::string> names;
  for_each_slice(TextFigure{4, 5, 6, "a", nullptr}, [&](const char* part, int slice) {
    names.push_back(part + std::to_string(slice));
  });
  EXPECT_EQ(names, (std::vector<std::string>{"center4", "height5", "tilt6"}));
}

}  // namespace
}  // namespace mien
