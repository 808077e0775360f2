#include <mien/slice.h>

#include <fmt/format.h>

#include <limits>

namespace mien {

SliceRange range_of(SliceKind kind) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  switch (kind) {
    case SliceKind::length:
    case SliceKind::ratio:
      return {0, kEndless, Rule::clamp};
    case SliceKind::angle:
      return {-180, 180, Rule::wrap};
    case SliceKind::color:
      return {0, 1, Rule::clamp};
    default:
      return {-kEndless, kEndless, Rule::free};
  }
}

std::string_view kind_name(SliceKind kind) {
  switch (kind) {
    case SliceKind::point:
      return "point";
    case SliceKind::shift:
      return "shift";
    case SliceKind::length:
      return "length";
    case SliceKind::ratio:
      return "ratio";
    case SliceKind::angle:
      return "angle";
    case SliceKind::frame:
      return "frame";
    case SliceKind::parabola:
      return "parabola";
    case SliceKind::color:
      return "color";
  }
  return "";
}

std::string unit_name(SliceKind kind, std::string_view length_unit) {
  switch (kind) {
    case SliceKind::point:
    case SliceKind::shift:
    case SliceKind::length:
    case SliceKind::parabola:
      return std::string{length_unit};
    case SliceKind::ratio:
      return "ratio";
    case SliceKind::angle:
      return "degrees";
    case SliceKind::frame:
      return fmt::format("1/{}, 1", length_unit);
    case SliceKind::color:
      return "linear light";
  }
  return "";
}

std::string component_name(SliceKind kind, int index) {
  if ((kind == SliceKind::point || kind == SliceKind::shift) && index < 2)
    return std::string(1, "xy"[index]);
  if (kind == SliceKind::color && index < 4) return std::string(1, "rgba"[index]);
  return std::to_string(index);
}

void mirror_differences(SliceKind kind, std::span<double> values, double twice_axis) {
  switch (kind) {
    case SliceKind::point:
    case SliceKind::shift:
    case SliceKind::angle:
      values[0] = 0 - values[0];
      return;               // 0 − x: no −0 for x = 0
    case SliceKind::frame:  // q(2a − x) = −k x + (k0 + 2a k)
      values[1] += twice_axis * values[0];
      values[0] = 0 - values[0];
      return;
    case SliceKind::length:
    case SliceKind::ratio:
    case SliceKind::parabola:
    case SliceKind::color:
      return;
  }
}

void mirror_values(SliceKind kind, std::span<double> values, double twice_axis) {
  if (kind == SliceKind::point)
    values[0] = twice_axis - values[0];
  else
    mirror_differences(kind, values, twice_axis);
}

}  // namespace mien
