#pragma once
// The command line of bench/whole/frames.

#include <mien/render/image.h>
#include <mien/render/view/view.h>

#include <optional>
#include <string>

namespace mien::bench {

struct Options {
  int threads = 1;
  int rounds = 0;       ///< 0: by size
  double seconds = 20;  ///< most of a case, three rounds aside
  long long most = 200'000'000;
  std::string scenes = "ABCDEF";
  bool json = false;
  bool reuse = false;
};

/// Nothing if the words make no sense; `help` says whether help was asked for instead.
std::optional<Options> read_options(int count, char** words, bool& help);

std::string help_text();

}  // namespace mien::bench
