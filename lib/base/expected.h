#pragma once
// A value, or a sentence why there is none. Used where mien meets the outside: files and names.

#include <cassert>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace mien {

/// Why something failed.
struct Error {
  std::string
      where;  ///< its address: "faces/a.json:12:7: /features/2/points", "out/a.png", "--set";
              ///< may be empty
  std::string what;  ///< one sentence, no full stop: "expected 2 numbers, got 3"
};

/// "where: what" on one line, for people to read.
inline std::string sentence(const Error& error) {
  return error.where.empty() ? error.what : error.where + ": " + error.what;
}

/// A T, or the Error that explains its absence: std::expected<T, Error> for C++20, with the same names.
/// An Error converts to it implicitly. Nothing here throws. Asking for the value or the error that is not
/// there is a bug in the program, which an assertion catches.
template <class T>
class [[nodiscard]] Expected {
 public:
  using value_type = T;
  using error_type = Error;

  Expected(T value) : held_(std::in_place_index<0>, std::move(value)) {}
  Expected(Error error) : held_(std::in_place_index<1>, std::move(error)) {}

  bool has_value() const noexcept { return held_.index() == 0; }
  explicit operator bool() const noexcept { return has_value(); }

  const T& operator*() const& noexcept { return held<0>(held_); }
  T& operator*() & noexcept { return held<0>(held_); }
  T&& operator*() && noexcept { return std::move(held<0>(held_)); }
  const T* operator->() const noexcept { return &held<0>(held_); }
  T* operator->() noexcept { return &held<0>(held_); }
  const T& value() const& noexcept { return **this; }
  T& value() & noexcept { return **this; }
  T&& value() && noexcept { return *std::move(*this); }
  const Error& error() const& noexcept { return held<1>(held_); }
  Error&& error() && noexcept { return std::move(held<1>(held_)); }

  template <class U>
  T value_or(U&& other) const& {
    return has_value() ? **this : static_cast<T>(std::forward<U>(other));
  }
  template <class U>
  T value_or(U&& other) && {
    return has_value() ? *std::move(*this) : static_cast<T>(std::forward<U>(other));
  }

  /// next(value), which returns another Expected; or the error.
  template <class Next>
  auto and_then(Next&& next) const& -> std::invoke_result_t<Next, const T&> {
    if (has_value()) return std::invoke(std::forward<Next>(next), **this);
    return error();
  }
  template <class Next>
  auto and_then(Next&& next) && -> std::invoke_result_t<Next, T&&> {
    if (has_value()) return std::invoke(std::forward<Next>(next), *std::move(*this));
    return std::move(*this).error();
  }

  /// Expected{change(value)}; or the error.
  template <class Change>
  auto transform(Change&& change) const& -> Expected<std::invoke_result_t<Change, const T&>> {
    if (has_value()) return std::invoke(std::forward<Change>(change), **this);
    return error();
  }
  template <class Change>
  auto transform(Change&& change) && -> Expected<std::invoke_result_t<Change, T&&>> {
    if (has_value()) return std::invoke(std::forward<Change>(change), *std::move(*this));
    return std::move(*this).error();
  }

  /// The value; or else(error), which returns another Expected<T>.
  template <class Else>
  Expected or_else(Else&& otherwise) const& {
    if (has_value()) return *this;
    return std::invoke(std::forward<Else>(otherwise), error());
  }

 private:
  template <std::size_t kIndex, class Held>
  static auto& held(Held& variant) noexcept {
    auto* const found = std::get_if<kIndex>(&variant);
    assert(found && "an Expected was asked for what it does not hold");
    return *found;
  }

  std::variant<T, Error> held_;
};

/// Success without a value: `Expected<Done>`.
struct Done {};

}  // namespace mien
