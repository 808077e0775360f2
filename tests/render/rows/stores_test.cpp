#include "render/rows/stores.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tests/support/shapes/every_instruction_set.h"

namespace mien::test {
namespace {

TEST(FillRun, WritesTheValueCountTimesAndNothingElse) {
  on_every_set([] {
    for (const std::size_t bytes : {4, 8, 16}) {
      RunPattern value;
      for (std::size_t i = 0; i < value.size(); ++i) value[i] = std::byte(i % bytes + 1);
      for (const int count : {0, 1, 3, 16, 33, 128, 200, 1001})
        for (const Stores stores : {Stores::ordinary, Stores::streamed})
          for (const std::size_t before : {std::size_t{0}, bytes, std::size_t{3}}) {
            const std::size_t size = bytes * std::size_t(count);
            std::vector<std::byte> all(before + size + 80);
            fill_run(all.data() + before, count, value, bytes, stores);
            finish_streams();
            for (std::size_t i = 0; i < all.size(); ++i) {
              const bool in = i >= before && i < before + size;
              ASSERT_EQ(all[i], in ? value[(i - before) % bytes] : std::byte{0})
                  << bytes << ' ' << count << ' ' << i;
            }
          }
    }
  });
}

}  // namespace
}  // namespace mien::test
