#include "tests/support/process/failing_malloc.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {
std::atomic<long> tried{0}, failing{0}, held{0};
std::atomic<bool> ever_after_that{false}, counts{true};

bool fails() {
  if (!counts) return false;
  const long index = ++tried;
  const long wanted = failing.load(std::memory_order_relaxed);
  return wanted > 0 && (index == wanted || (ever_after_that && index > wanted));
}

/// What the real allocator gave, counted.
void* given(void* block) {
  if (block) ++held;
  return block;
}

void* none() {
  errno = ENOMEM;
  return nullptr;
}

bool is_power(std::size_t alignment) {
  return alignment && (alignment & (alignment - 1)) == 0;
}
}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

__attribute__((visibility("default"))) void* malloc(std::size_t size) noexcept {
  return fails() ? none() : given(__libc_malloc(size));
}
__attribute__((visibility("default"))) void* calloc(std::size_t count, std::size_t size) noexcept {
  return fails() ? none() : given(__libc_calloc(count, size));
}
__attribute__((visibility("default"))) void* realloc(void* block, std::size_t size) noexcept {
  if (block && size == 0) --held;
  if (block && size == 0) return __libc_realloc(block, size);
  if (fails()) return none();
  void* const moved = __libc_realloc(block, size);
  return block ? moved : given(moved);
}
__attribute__((visibility("default"))) void* memalign(std::size_t alignment,
                                                      std::size_t size) noexcept {
  return fails() ? none() : given(__libc_memalign(alignment, size));
}
__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment,
                                                           std::size_t size) noexcept {
  return fails() ? none() : given(__libc_memalign(alignment, size));
}
__attribute__((visibility("default"))) int posix_memalign(void** out, std::size_t alignment,
                                                          std::size_t size) noexcept {
  if (!is_power(alignment) || alignment % sizeof(void*) != 0) return EINVAL;
  void* const block = fails() ? nullptr : given(__libc_memalign(alignment, size));
  if (!block) return ENOMEM;
  *out = block;
  return 0;
}
__attribute__((visibility("default"))) void free(void* block) noexcept {
  if (block) --held;
  __libc_free(block);
}

}  // extern "C"

namespace {
/// What the environment asks for, in a program that this was loaded before.
struct Asked {
  Asked() {
    if (const char* const index = std::getenv("MIEN_FAIL_ALLOCATION"))
      mien::test::fail_allocation(std::atol(index), std::getenv("MIEN_FAIL_EVER_AFTER"));
  }
  ~Asked() {
    const char* const file = std::getenv("MIEN_COUNT_ALLOCATIONS");
    if (!file) return;
    char line[32];
    const int length = std::snprintf(line, sizeof line, "%ld\n", tried.load());
    const int out = ::open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out < 0) return;
    if (::write(out, line, std::size_t(length)) < 0) errno = 0;
    ::close(out);
  }
} asked;
}  // namespace

void mien::test::fail_allocation(long index, bool ever_after) {
  failing = 0;
  tried = 0;
  ever_after_that = ever_after;
  failing = index;
  counts = true;
}
void mien::test::stop_failing() {
  counts = false;
}
long mien::test::allocations_tried() {
  return tried;
}
long mien::test::blocks_held() {
  return held;
}

#else

void mien::test::fail_allocation(long, bool) {}
void mien::test::stop_failing() {}
long mien::test::allocations_tried() {
  return 0;
}
long mien::test::blocks_held() {
  return 0;
}

#endif
