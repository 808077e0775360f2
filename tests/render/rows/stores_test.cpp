#include <mien/render/rows/stores.h>

#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "tests/support/every_instruction_set.h"

namespace mien {
namespace {

using test::on_every_set;

TEST(FillRows, FillsWhatIsAskedAndNothingElse) {
  on_every_set([] {
    for (const int count : {1, 5, 16, 33}) {
      std::array<std::uint32_t, 40 * 3> pixels{};
      for (const Stores stores : {Stores::ordinary, Stores::streamed}) {
        pixels = {};
        fill_rows(pixels.data() + 1, 40, 2, count, 7, stores);
        finish_streams();
        for (int i = 0; i < int(pixels.size()); ++i) {
          const int x = i % 40, y = i / 40;
          EXPECT_EQ(pixels[std::size_t(i)], y < 2 && x >= 1 && x <= count ? 7u : 0u);
        }
      }
    }
  });
}

TEST(StreamRows, CopiesRowsAndNothingElse) {
  on_every_set([] {
    std::array<std::uint32_t, 256> from;
    std::iota(from.begin(), from.end(), 1u);
    alignas(64) std::array<std::uint32_t, 48 * 17> pixels{};
    stream_rows(from.data(), 16, 16, pixels.data() + 16, 48);
    finish_streams();
    for (int i = 0; i < int(pixels.size()); ++i) {
      const int x = i % 48 - 16, y = i / 48;
      const bool in = x >= 0 && x < 16 && y < 16;
      EXPECT_EQ(pixels[std::size_t(i)], in ? from[std::size_t(16 * y + x)] : 0u) << x << ' ' << y;
    }
  });
}

}  // namespace
}  // namespace mien
