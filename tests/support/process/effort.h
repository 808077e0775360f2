#pragma once
// How often a test repeats itself. The release suite proves exactness and does all of it; under a
// sanitizer, ten to thirty times slower, the same tests look at the same code with a share of the
// samples: memory and threads err on a kind of input, not on its thousandth example.

#include <algorithm>

namespace mien::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

/// One in this many samples is taken.
inline constexpr int kThinning = kSanitized ? 16 : 1;

/// n repetitions, fewer under a sanitizer; also the share of them that must have been of a kind.
constexpr int times(int n) {
  return std::max(n / kThinning, 1);
}

}  // namespace mien::test
