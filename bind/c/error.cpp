// Errors as the caller holds them.

#include "bind/c/door_private.h"

struct mien_error {
  mien::Error error;
};

namespace {

// Given where memory for an error is missing; it is never freed.
mien_error* memory_ran_out() noexcept {
  static mien_error error{{"", "memory ran out"}};
  return &error;
}

}  // namespace

extern "C" {

mien_error* mien_error_new(const char* where, size_t where_length, const char* what,
                           size_t what_length) {
  try {
    const auto at = mien::c::text_of(where, where_length, "where");
    const auto said = mien::c::text_of(what, what_length, "what");
    return new mien_error{{std::string(at), std::string(said)}};
  } catch (const mien::c::Refusal& refusal) {
    return mien_error_new("mien_error_new", MIEN_NUL_ENDED, refusal.error.what.c_str(),
                          MIEN_NUL_ENDED);
  } catch (...) {
    return memory_ran_out();
  }
}

const char* mien_error_where(const mien_error* error) {
  return error ? error->error.where.c_str() : "";
}

const char* mien_error_what(const mien_error* error) {
  return error ? error->error.what.c_str() : "";
}

void mien_error_free(mien_error* error) {
  if (error != memory_ran_out()) delete error;
}
}
