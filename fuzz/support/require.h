#pragma once
// What a fuzzer demands of every input.

#include <mien/expected.h>

#include <cstdlib>
#include <string>

namespace mien::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// An error says something, in one line.
inline void require_sentence(const Error& error) {
  require(!error.what.empty());
  require(sentence(error).find('\n') == std::string::npos);
}

}  // namespace mien::fuzz
