#include "sdf/arrange/reach.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/support/every_instruction_set.h"
#include "tests/support/random.h"

namespace mien::test {
namespace {

TEST(Reach, MeetsWhatHasAPointInCommonOnEveryInstructionSet) {
  on_every_set([] {
    Random r(7);
    int met = 0;
    for (std::size_t count = 0; count < 150; ++count) {
      std::vector<float> low(count + kReachSpare), high(count + kReachSpare);
      for (std::size_t i = 0; i < low.size(); ++i) {
        low[i] = float(r.below(41));
        high[i] = low[i] + float(r.below(5));
      }
      const float from = float(r.below(41)), to = from + float(r.below(5));
      std::vector<std::uint8_t> bits((count + 7) / 8);
      meeting({low.data(), high.data(), count}, from, to, bits.data());
      for (std::size_t i = 0; i < count; ++i) {
        const bool meets = low[i] <= to && high[i] >= from;
        ASSERT_EQ(bits[i / 8] >> i % 8 & 1, int(meets)) << i << " of " << count;
        met += meets;
      }
    }
    EXPECT_GT(met, 500);
  });
}

}  // namespace
}  // namespace mien::test
