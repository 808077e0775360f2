// Parts: every item in one of them, and each with its share of every job.

#include <gtest/gtest.h>

#include <set>

#include "tests/tools/mien/batch/batch_fixture.h"

namespace mien {
namespace {

class SplitTest : public BatchTest {
 protected:
  /// The items of a part, as its manifest says.
  std::vector<std::string> items(const std::string& part_of) const {
    std::vector<std::string> names;
    const std::string text = read_text(manifest(part_of));
    for (std::size_t at = 0; (at = text.find("{\"item\": \"", at)) != std::string::npos;) {
      at += 10;
      names.push_back(text.substr(at, text.find('"', at) - at));
    }
    return names;
  }
  static std::string numbered(const std::string& name, int count) {
    return R"({"run": ["new", "--seed", "{n}"], "each": {"n": {"from": 1, "to": )" +
           std::to_string(count) + R"(}}, "output": ")" + name + R"({n}.json"})";
  }
};

TEST_F(SplitTest, EveryItemIsInOnePart) {
  plan(numbered("a", 1) + "," + numbered("b", 1) + "," + numbered("c", 7) + "," + numbered("d", 3) +
       "," + numbered("e", 16));
  for (const int of : {1, 2, 3, 5, 8, 31}) {
    std::set<std::string> all;
    std::size_t count = 0, most = 0;
    for (int part = 1; part <= of; ++part) {
      const std::string which = std::to_string(part) + "/" + std::to_string(of);
      ASSERT_EQ(batch("out", which).code, 0);
      const auto names = items(std::to_string(part) + "-of-" + std::to_string(of));
      all.insert(names.begin(), names.end());
      count += names.size();
      most = std::max(most, names.size());
    }
    EXPECT_EQ(all.size(), 28u) << of;
    EXPECT_EQ(count, 28u) << of;
    EXPECT_LE(most, 28u / std::size_t(of) + 3) << of;
    EXPECT_EQ(join().code, 0) << of;
  }
}

// What is slow is not one worker's alone.
TEST_F(SplitTest, EveryPartHasItsShareOfEveryJob) {
  plan(numbered("a", 4) + "," + numbered("b", 12));
  for (int part = 1; part <= 4; ++part) {
    ASSERT_EQ(batch("out", std::to_string(part) + "/4").code, 0);
    const auto names = items(std::to_string(part) + "-of-4");
    EXPECT_EQ(std::ranges::count_if(names, [](const auto& one) { return one[0] == 'a'; }), 1);
    EXPECT_EQ(names.size(), 4u);
  }
}

}  // namespace
}  // namespace mien
