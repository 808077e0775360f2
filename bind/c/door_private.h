#pragma once
// The door between C and C++: what every function of the interface passes on its way in and out. Inside, mistakes
// are thrown; the door turns each into a status and an error, and lets nothing through. Each library of the interface
// has its own.

#include <mien/expected.h>
#include "bind/c/mien_c.h"

#include <cstddef>
#include <cstring>
#include <new>
#include <string>
#include <string_view>
#include <utility>

namespace mien::c {

/// A mistake on its way to the door.
struct Refusal {
  mien_status status;
  Error error;
};

/// Writes `*out` if the caller wants to know.
void tell(mien_error** out, const Error& error) noexcept;

/// Passes on what `exception` is about, as a status and an error.
mien_status caught(std::string_view function, mien_error** error) noexcept;

/// Runs one function of the interface.
template <class Work>
mien_status pass(std::string_view function, mien_error** error, const Work& work) noexcept {
  if (error) *error = nullptr;
  try {
    work();
    return MIEN_OK;
  } catch (...) {
    return caught(function, error);
  }
}

[[noreturn]] void misuse(std::string_view argument, std::string what);
[[noreturn]] void refuse(std::string where, std::string what);

/// The value, or the error at the door with that status.
template <class T>
T must(Expected<T> value, mien_status status) {
  if (!value) throw Refusal{status, std::move(value).error()};
  return *std::move(value);
}

/// What a pointer points to; NULL is misuse.
template <class T>
T& need(T* pointer, std::string_view argument) {
  if (!pointer) misuse(argument, "is NULL");
  return *pointer;
}

/// A place for a result, cleared.
template <class T>
T*& place(T** out, std::string_view argument = "out") {
  need(out, argument) = nullptr;
  return *out;
}

/// The text of an argument with its length. NULL is empty if its length is 0.
std::string_view text_of(const char* text, std::size_t length, std::string_view argument);
/// What errors call a text: `name`, or where it is null `otherwise`.
std::string_view name_of(const char* name, std::size_t length, std::string_view otherwise);
/// The same for names of files, which hold no NUL and are not empty.
std::string path_of(const char* path, std::size_t length);

int index_of(int32_t index, std::size_t count, std::string_view argument);
void need_count(int32_t given, std::size_t wanted, std::string_view argument);
double need_finite(double number, std::string_view argument);

/// The size that the caller says its struct has; no less than that of the number itself and no more than `known`.
std::size_t size_of_struct(const uint32_t* size, std::size_t known, std::string_view argument);

/// The caller's struct, brought to this library's size by the defaults in `whole`. An older header's is shorter.
template <class Struct>
Struct whole_struct(const Struct* given, Struct whole, std::string_view argument) {
  std::memcpy(&whole, given,
              size_of_struct(given ? &given->size : nullptr, sizeof(Struct), argument));
  whole.size = sizeof(Struct);
  return whole;
}

/// The defaults of a struct, as far as the caller's reaches.
template <class Struct>
void init_struct(Struct* out, std::size_t size, Struct defaults) noexcept {
  if (!out || size < sizeof(uint32_t) || size > sizeof(Struct)) return;
  defaults.size = uint32_t(size);
  std::memcpy(out, &defaults, size);
}

/// Writes a result into the caller's struct, as far as it reaches.
template <class Struct>
void give_struct(Struct* out, Struct result) {
  const std::size_t size = size_of_struct(out ? &out->size : nullptr, sizeof(Struct), "out");
  result.size = uint32_t(size);
  std::memcpy(out, &result, size);
}

}  // namespace mien::c
