#pragma once
// A value, or the sentence that says why there is none. Used at the borders only: files and names.

#include <string>
#include <utility>
#include <variant>

namespace mien {

/// Why something could not be read or written.
struct Error {
  std::string where;  ///< address: "faces/a.json:12:7: /features/2/points", "out/a.png", "--set";
                      ///< may be empty
  std::string what;   ///< one sentence, no full stop: "expected 2 numbers, got 3"
};

/// "where: what" on one line, as it is shown to people.
inline std::string sentence(const Error& error) {
  return error.where.empty() ? error.what : error.where + ": " + error.what;
}

/// A T, or the Error that explains its absence.
template <class T>
class [[nodiscard]] Expected {
 public:
  Expected(T value) : held_(std::in_place_index<0>, std::move(value)) {}
  Expected(Error error) : held_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return held_.index() == 0; }
  const T& operator*() const& { return std::get<0>(held_); }
  T& operator*() & { return std::get<0>(held_); }
  T&& operator*() && { return std::get<0>(std::move(held_)); }
  const T* operator->() const { return &std::get<0>(held_); }
  T* operator->() { return &std::get<0>(held_); }
  const Error& error() const { return std::get<1>(held_); }

 private:
  std::variant<T, Error> held_;
};

/// Success without a value: `Expected<Done>`.
struct Done {};

}  // namespace mien
