#include "bind/c/door_private.h"
#include "lib/base/memory_ran_out.h"

#include <cmath>
#include <exception>

namespace mien::c {

void tell(mien_error** out, const Error& error) noexcept {
  if (out)
    *out = mien_error_new(error.where.data(), error.where.size(), error.what.data(),
                          error.what.size());
}

mien_status caught(std::string_view function, mien_error** error) noexcept {
  try {
    try {
      throw;
    } catch (Refusal& refusal) {
      std::string& where = refusal.error.where;
      if (refusal.status == MIEN_MISUSE) where = std::string(function) + ": " + where;
      tell(error, refusal.error);
      return refusal.error.what.starts_with(kMemoryRanOut) ? MIEN_NO_MEMORY : refusal.status;
    } catch (const std::bad_alloc&) {
      if (error) *error = mien_error_new("", 0, kMemoryRanOut.data(), kMemoryRanOut.size());
      return MIEN_NO_MEMORY;
    } catch (const std::exception& unexpected) {
      tell(error, {std::string(function), std::string("unexpected: ") + unexpected.what()});
      return MIEN_UNEXPECTED;
    }
  } catch (...) {  // not an exception of the standard library's, or no memory for the sentence
    if (error) *error = mien_error_new("", 0, "unexpected", MIEN_NUL_ENDED);
    return MIEN_UNEXPECTED;
  }
}

void misuse(std::string_view argument, std::string what) {
  throw Refusal{MIEN_MISUSE, {std::string(argument), std::move(what)}};
}

void refuse(std::string where, std::string what) {
  throw Refusal{MIEN_REFUSED, {std::move(where), std::move(what)}};
}

std::string_view text_of(const char* text, std::size_t length, std::string_view argument) {
  if (!text && length != 0) misuse(argument, "is NULL");
  if (!text) return {};
  const std::string_view whole{text, length == MIEN_NUL_ENDED ? std::strlen(text) : length};
  if (whole.size() > std::size_t(PTRDIFF_MAX)) misuse(argument, "is longer than memory");
  return whole;
}

std::string_view name_of(const char* name, std::size_t length, std::string_view otherwise) {
  return name ? text_of(name, length, "name") : otherwise;
}

std::string path_of(const char* path, std::size_t length) {
  const std::string_view text = text_of(path, length, "path");
  if (text.empty()) misuse("path", "is empty");
  if (text.find('\0') != std::string_view::npos)
    misuse("path", "holds a NUL, which no file's name does");
  return std::string(text);
}

int index_of(int32_t index, std::size_t count, std::string_view argument) {
  if (index < 0 || std::size_t(index) >= count)
    misuse(argument, "is " + std::to_string(index) + ", and there are " + std::to_string(count));
  return index;
}

void need_count(int32_t given, std::size_t wanted, std::string_view argument) {
  if (given < 0 || std::size_t(given) != wanted)
    misuse(argument,
           "is " + std::to_string(given) + ", and the numbers are " + std::to_string(wanted));
}

double need_finite(double number, std::string_view argument) {
  if (!std::isfinite(number)) refuse(std::string(argument), "expected a finite number");
  return number;
}

std::size_t size_of_struct(const uint32_t* size, std::size_t known, std::string_view argument) {
  const std::size_t said = need(size, argument);
  if (said < sizeof(uint32_t))
    misuse(argument, "has no size: its _init function, or sizeof, gives it one");
  if (said > known)
    misuse(argument, "is of " + std::to_string(said) + " bytes, and this library knows " +
                         std::to_string(known) + ": it is older than the header");
  return said;
}

}  // namespace mien::c
