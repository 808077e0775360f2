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
#include <string>
#include <string_view>

namespace mien {

/// How every message about missing memory begins. Short enough to be inside its string.
inline constexpr std::string_view kMemoryRanOut = "memory ran out";

/// The error, told without memory where there is none.
inline Error memory_ran_out(std::string_view where = {}) noexcept {
  Error error{{}, std::string(kMemoryRanOut)};
  try {
    error.where = where;
  } catch (const std::bad_alloc&) {  // then it is told without the place
    error.where.clear();
  }
  return error;
}

}  // namespace mien
