// mien_fuzz_pictures: random scenes of a kind as pictures, every pixel judged, for as long as one likes.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/support/random/fuzzed_picture.h"

namespace mien::test {
namespace {

constexpr const char* kUse =
    "mien_fuzz_pictures [--kind lattice|jittered|generic|huge|strokes|painted] [--first N]\n"
    "                   [--count N] [--seconds N] [--each all|one]\n"
    "Draws scenes by their seeds at 24 and 32 px, 8 and 16 bits, in both blends (--each one:\n"
    "in a size and a blend that follow from the seed): no pixel may be off by more than 1 of 255\n"
    "or 32 of 65535. Names each scene in which one is; a run goes on\n"
    "where another ended with --first. Ends with 1 if a pixel is off, with 2 if not understood.\n";

struct Asked {
  std::string kind = "lattice";
  long first = 1, count = 100, seconds = 1'000'000;
  bool one = false;  ///< picture of each scene, not four
};

bool read(int count, char** words, Asked& asked) {
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string name = words[i], value = words[i + 1];
    char* end = nullptr;
    const long number = std::strtol(value.c_str(), &end, 10);
    long* const to = name == "--first"     ? &asked.first
                     : name == "--count"   ? &asked.count
                     : name == "--seconds" ? &asked.seconds
                                           : nullptr;
    if (name == "--kind")
      asked.kind = value;
    else if (name == "--each" && (value == "one" || value == "all"))
      asked.one = value == "one";
    else if (to && end && !*end && number >= 1)
      *to = number;
    else
      return false;
  }
  Scene scene;
  return count % 2 == 1 && fuzzed_scene(asked.kind, 1, scene);
}

int run(const Asked& asked) {
  const auto begin = std::chrono::steady_clock::now();
  FuzzTally all;
  long seed = asked.first;
  for (; seed < asked.first + asked.count; ++seed) {
    const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - begin;
    if (so_far.count() > double(asked.seconds)) break;
    Scene scene;
    fuzzed_scene(asked.kind, std::uint64_t(seed), scene);
    for (const int side : {24, 32}) {
      if (asked.one && (seed / 2 % 2 == 0) != (side == 24)) continue;
      const long over = all.over;
      const Blend blend = seed % 2 ? Blend::linear : Blend::srgb;
      judge_fuzzed(scene, side, all, asked.one ? std::optional(blend) : std::nullopt);
      if (all.over == over) continue;
      fmt::print("{} {}: {} pixels over; {}\n", asked.kind, seed, all.over - over, all.where);
      std::fflush(stdout);
    }
  }
  fmt::print(
      "{} {} to {}: {} pictures, {} pixels; {} over, worst {:.3f} of what is allowed; {} pictures "
      "with doubts, {} pixels by distances, {} asked of the truth, {} of "
      "them disputed\n",
      asked.kind, asked.first, seed - 1, all.pictures, all.pixels, all.over, all.worst, all.doubted,
      all.resolved, all.asked, all.disputed);
  return all.over ? 1 : 0;
}

}  // namespace
}  // namespace mien::test

int main(int count, char** words) {
  mien::test::Asked asked;
  if (!mien::test::read(count, words, asked)) {
    fmt::print(stderr, "{}", mien::test::kUse);
    return 2;
  }
  return mien::test::run(asked);
}
