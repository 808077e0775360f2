#pragma once
// The command line of bench/whole/frames.

#include <mien/image.h>
#include <mien/view.h>

#include <optional>
#include <string>

namespace mien::bench {

/// Which table is told.
enum class Table {
  cairo,      ///< beside Cairo and the floor
  reuse,      ///< beside frames that are like the one before
  mode,       ///< mixed or stored in another way, beside encoded in 8 bits
  old,        ///< beside another build
  thumbnails  ///< a thousand small pictures
};

struct Options {
  Table table = Table::cairo;
  int threads = 1;
  int rounds = 0;       ///< 0: by size
  double seconds = 20;  ///< most of a case, three rounds aside
  long long most = 200'000'000;
  bool best_instructions = true;  ///< none were asked for
  std::string scenes = "ABCDEF";
  bool json = false;
  std::string old;  ///< the other build's `mien` command
  Blend blend = Blend::srgb;
  Depth depth = Depth::u8;
};

/// Nothing if the words make no sense; `help` says whether help was asked for instead.
std::optional<Options> read_options(int count, char** words, bool& help);

std::string help_text();

}  // namespace mien::bench
