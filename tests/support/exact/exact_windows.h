#pragma once
// Windows of pictures, drawn by region in both blends at 8 and 16 bits, judged by one exact truth.

#include <mien/image.h>
#include <mien/scene.h>
#include <mien/view.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/exact/exact_truth.h"

namespace mien::test {

/// How a picture is stored, and what it may be off by [levels of `top`]; with dither one more.
struct Storage {
  Blend blend;
  Depth depth;
  int top;
  double allowed;
  const char* name;
};
inline constexpr Storage kStorages[] = {{Blend::linear, Depth::u8, 255, 1, "linear 8"},
                                        {Blend::linear, Depth::u16, 65535, 32, "linear 16"},
                                        {Blend::srgb, Depth::u8, 255, 1, "srgb 8"},
                                        {Blend::srgb, Depth::u16, 65535, 32, "srgb 16"}};

struct Tally {
  long judged = 0, over = 0;
  double worst = 0;   ///< [levels]
  std::string where;  ///< of the worst
};
using Tallies = std::array<Tally, std::size(kStorages)>;

/// Which storages are asked for.
using Wanted = std::array<bool, std::size(kStorages)>;
inline constexpr Wanted kAllStorages{true, true, true, true};

/// Which pixels are looked at, besides those in one colour with their neighbours.
using Choice = std::function<bool(int x, int y)>;

/// Draws the window and judges its pixels.
void judge_window(const Scene& scene, View view, const PixelRect& window, const ExactTruth& truth,
                  const Wanted& wanted, const Choice& choice, Tallies& tallies);

/// Windows anywhere, and around what is lit: outlines of reliefs, their insides, domes.
std::vector<PixelRect> windows_of(const Scene& scene, const View& view, int side, int anywhere,
                                  int each_relief, std::uint64_t seed);

}  // namespace mien::test
