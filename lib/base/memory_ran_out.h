#pragma once
// The end of every public verb that returns an Expected:
//
//   Expected<Face> read_face(const std::filesystem::path& path) try {
//     …
//   } catch (const std::bad_alloc&) {
//     return memory_ran_out(path.native());
//   }

#include <mien/expected.h>

#include <new>
#include <string_view>

namespace mien {

/// The error, told without memory where there is none: the sentence is short enough to be inside its string.
inline Error memory_ran_out(std::string_view where = {}) noexcept {
  Error error{{}, "out of memory"};
  try {
    error.where = where;
  } catch (const std::bad_alloc&) {  // then it is told without the place
    error.where.clear();
  }
  return error;
}

}  // namespace mien
