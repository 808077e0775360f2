#pragma once
// What a fuzzer demands of every input.

#include <mien/expected.h>
#include "lib/base/one_line.h"

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace mien::fuzz {

/// Which demand was not met is told before the end. (clang 14 has no std::source_location.)
inline void require(bool holds, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (holds) return;
  std::fprintf(stderr, "%s:%d: not so\n", file, line);
  std::abort();
}

/// An error says something, in one line that any terminal may show.
inline void require_sentence(const Error& error) {
  require(!error.what.empty());
  const std::string text = sentence(error);
  require(one_line(text, std::numeric_limits<std::size_t>::max()) == text);
}

}  // namespace mien::fuzz
