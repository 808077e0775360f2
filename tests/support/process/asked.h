#pragma once
// How much a test is asked to do beyond its share of the suite.

#include <cstdlib>

namespace mien::test {

/// The number in an environment variable.
inline int asked_of(const char* name, int otherwise) {
  const char* asked = std::getenv(name);
  return asked ? std::atoi(asked) : otherwise;
}

}  // namespace mien::test
