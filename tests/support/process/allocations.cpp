#include "tests/support/process/allocations.h"

#include <malloc.h>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> count{0}, bytes{0};
}

long mien::test::allocations() {
  return count;
}

long mien::test::held_bytes() {
  return bytes;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MIEN_OWN_NEW 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MIEN_OWN_NEW 0
#endif
#endif
#ifndef MIEN_OWN_NEW
#define MIEN_OWN_NEW 1
#endif

#if MIEN_OWN_NEW
namespace {
void* counted(std::size_t size, std::size_t alignment) {
  ++count;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* p = std::aligned_alloc(alignment, whole ? whole : alignment);
  if (!p) throw std::bad_alloc();
  bytes += long(malloc_usable_size(p));
  return p;
}
void freed(void* p) {
  if (p) bytes -= long(malloc_usable_size(p));
  std::free(p);
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, std::size_t(alignment));
}
void operator delete(void* p) noexcept {
  freed(p);
}
void operator delete(void* p, std::size_t) noexcept {
  freed(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  freed(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  freed(p);
}
#endif
