#include "tools/mien/serve/answer_cache.h"

#include <gtest/gtest.h>

namespace mien::command {
namespace {

DrawnFace of_size(std::size_t size) {
  return {kOk, std::make_shared<const std::string>(size, 'x')};
}

TEST(AnswerCache, KeepsWhatItWasGiven) {
  AnswerCache cache(1 << 20);
  EXPECT_EQ(cache.find("a"), nullptr);
  const DrawnFace drawn = of_size(100);
  cache.put("a", drawn);
  ASSERT_NE(cache.find("a"), nullptr);
  EXPECT_EQ(cache.find("a")->bytes, drawn.bytes) << "shared, not copied";
  cache.put("a", of_size(7));
  EXPECT_EQ(cache.find("a")->bytes, drawn.bytes) << "of one meaning there is one picture";
  EXPECT_EQ(cache.count(), 1u);
}

TEST(AnswerCache, ForgetsWhatWasAskedForLongestAgo) {
  AnswerCache cache(10'000);
  for (const char* name : {"a", "b", "c"}) cache.put(name, of_size(3000));
  cache.find("a");
  cache.put("d", of_size(3000));
  EXPECT_NE(cache.find("a"), nullptr);
  EXPECT_EQ(cache.find("b"), nullptr);
  EXPECT_NE(cache.find("c"), nullptr);
  EXPECT_NE(cache.find("d"), nullptr);
}

TEST(AnswerCache, StaysWithinItsMemory) {
  AnswerCache cache(10'000);
  for (int i = 0; i < 1000; ++i) {
    cache.put(std::to_string(i), of_size(std::size_t(i)));
    ASSERT_LE(cache.bytes(), 10'000u);
  }
  EXPECT_GE(cache.count(), 7u);
  const std::size_t before = cache.count();
  cache.put("huge", of_size(20'000));
  EXPECT_EQ(cache.count(), before) << "what does not fit takes nobody's place";
  AnswerCache none(0);
  none.put("a", of_size(0));
  EXPECT_EQ(none.count(), 0u);
}

}  // namespace
}  // namespace mien::command
