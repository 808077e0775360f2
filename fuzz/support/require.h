#pragma once
// What a fuzzer demands of every input.

#include <mien/expected.h>
#include "lib/base/one_line.h"

#include <cstdlib>
#include <limits>
#include <string>

namespace mien::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// An error says something, in one line that any terminal may show.
inline void require_sentence(const Error& error) {
  require(!error.what.empty());
  const std::string text = sentence(error);
  require(one_line(text, std::numeric_limits<std::size_t>::max()) == text);
}

}  // namespace mien::fuzz
