#pragma once
// std::from_chars, also for floating-point numbers where the standard library has none yet: libc++ before 20, so macOS,
// FreeBSD and Emscripten. Both round correctly, so a file means the same numbers everywhere.

#include <charconv>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
#include <fast_float/fast_float.h>

#include <cmath>
#include <string_view>
#endif

namespace mien {

using std::from_chars;

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000

/// fast_float 3.9 reads 1e999 as infinity and 1e-999 as 0; std::from_chars says that they are out of range, and so
/// does this. A number is out of range if digits other than 0 became 0 or infinity.
inline std::from_chars_result from_chars(const char* first, const char* last, double& value) {
  double read = 0.0;
  const auto [end, failed] = fast_float::from_chars(first, last, read);
  if (failed != std::errc{}) return {end, failed};
  const std::string_view text(first, std::size_t(end - first));
  const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
  const bool digits = mantissa.find_first_of("0123456789") != std::string_view::npos;
  const bool zero = mantissa.find_first_of("123456789") == std::string_view::npos;
  if (digits && (std::isinf(read) || (read == 0.0 && !zero)))
    return {end, std::errc::result_out_of_range};
  value = read;
  return {end, std::errc{}};
}

#endif

}  // namespace mien
