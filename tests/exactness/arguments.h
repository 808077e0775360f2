#pragma once
// What mien_exactness is asked for.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/exact/exact_windows.h"

namespace mien::test {

struct ExactnessArguments {
  std::vector<std::string> faces, poses;  ///< none: all
  std::vector<int> sizes;                 ///< none: all
  Wanted storages = kAllStorages;
  int windows = 200;  ///< anywhere, of pictures too large to be judged whole
  int every = 1;      ///< one in so many pixels that are not of one colour
  bool lit = true;    ///< pixels in which light falls on a slope, too
  std::uint64_t seed = 1;
  int process = 0, processes = 1;
  int first = 1;  ///< combinations before that were judged already
};

inline constexpr const char* kExactnessUse =
    "mien_exactness [--face NAME]... [--pose NAME]... [--size N]... [--blend srgb|linear]\n"
    "               [--depth 8|16] [--windows N] [--every N] [--unlit] [--seed S]\n"
    "               [--processes I/N] [--first K]\n"
    "Judges drawn pictures of the sample faces by the exact ones: no channel of any pixel may be\n"
    "off by more than 1 of 255, or 32 of 65535. Pictures up to 333 px wide are judged whole, "
    "larger\n"
    "ones in windows of 16 x 16 pixels: N anywhere and some at every lit feature.\n"
    "  --every N        of pixels that have more than one colour, one in N\n"
    "  --unlit          no pixels in which light falls on a slope\n"
    "  --processes I/N  the I-th of N processes that share the work, from 1\n"
    "  --first K        begin at combination K: goes on where a run was ended\n"
    "Ends with 1 if a pixel is off by more, with 2 if it was not understood.\n";

/// Nothing, after a sentence on standard error, if they are not understood.
std::optional<ExactnessArguments> read_exactness_arguments(int count, char** words);

}  // namespace mien::test
