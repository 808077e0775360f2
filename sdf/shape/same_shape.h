#pragma once
// Shapes that are equal, number for number: their outlines are drawn and crossed once.

#include <mien/shape.h>

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace mien {

inline bool same_numbers(const Polyline& a, const Polyline& b) {
  return a.half_width == b.half_width && a.points == b.points;
}

inline bool same_numbers(const Path& a, const Path& b) {
  if (a.rule != b.rule || a.loops.size() != b.loops.size()) return false;
  for (std::size_t i = 0; i < a.loops.size(); ++i) {
    const auto &s = a.loops[i].sides, &t = b.loops[i].sides;
    if (s.size() != t.size() ||
        (!s.empty() && std::memcmp(s.data(), t.data(), s.size() * sizeof(s[0])) != 0))
      return false;
  }
  return true;
}

template <class Held>
bool same_numbers(const Held& a, const Held& b) {
  static_assert(std::is_trivially_copyable_v<Held> && sizeof(Held) % sizeof(double) == 0);
  return std::memcmp(&a, &b, sizeof a) == 0;
}

inline bool same_shape(const Shape& a, const Shape& b) {
  return a.index() == b.index() &&
         std::visit(
             [&](const auto& s) { return same_numbers(s, std::get<std::decay_t<decltype(s)>>(b)); },
             a);
}

/// The same for equal shapes.
inline std::uint64_t hash_of(const Shape& shape) {
  const auto mixed = [](std::uint64_t h, double v) {
    std::uint64_t bits;
    std::memcpy(&bits, &v, sizeof bits);
    h = (h ^ bits) * 0x9e3779b97f4a7c15ull;
    return h ^ (h >> 29);
  };
  const auto some_of = [&](std::uint64_t h, const double* v, std::size_t count) {
    for (std::size_t i = 0; i < count && i < 6; ++i) h = mixed(h, v[i]);
    return h;
  };
  return std::visit(
      [&](const auto& s) {
        using Held = std::decay_t<decltype(s)>;
        const std::uint64_t h = shape.index() + 1;
        if constexpr (std::is_same_v<Held, Polyline>)
          return s.points.empty() ? h
                                  : mixed(some_of(h, &s.points[0].x, 2), double(s.points.size()));
        else if constexpr (std::is_same_v<Held, Path>)
          return s.loops.empty() || s.loops[0].sides.empty()
                     ? h
                     : some_of(h, &s.loops[0].sides[0].p0.x, sizeof(QuadBezier) / sizeof(double));
        else
          return some_of(h, reinterpret_cast<const double*>(&s), sizeof s / sizeof(double));
      },
      shape);
}

}  // namespace mien
