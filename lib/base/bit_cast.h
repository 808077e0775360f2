#pragma once
// std::bit_cast, also where the standard library has none yet: libc++ before 14, which Emscripten 3.1.6 comes with.

#include <bit>
#include <type_traits>

namespace mien {

#if defined(__cpp_lib_bit_cast)
using std::bit_cast;
#else
template <class To, class From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}
#endif

}  // namespace mien
