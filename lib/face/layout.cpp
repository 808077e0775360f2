#include <mien/layout.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace mien {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// A kind's own range and rule.
void set_range(Slice& slice) {
  switch (slice.kind) {
    case SliceKind::point:
    case SliceKind::shift:
    case SliceKind::frame:
    case SliceKind::parabola:
      slice.rule = Rule::free, slice.lo = -kEndless, slice.hi = kEndless;
      return;
    case SliceKind::length:
    case SliceKind::ratio:
      slice.rule = Rule::clamp, slice.lo = 0, slice.hi = kEndless;
      return;
    case SliceKind::angle:
      slice.rule = Rule::wrap, slice.lo = -180, slice.hi = 180;
      return;
    case SliceKind::color:
      slice.rule = Rule::clamp, slice.lo = 0, slice.hi = 1;
      return;
  }
}

double wrapped(double value, double lo, double hi) {
  if (value >= lo && value < hi) return value;
  const double turned = value - (hi - lo) * std::floor((value - lo) / (hi - lo));
  return turned >= lo && turned < hi ? turned : lo;  // rounding may land on hi
}

}  // namespace

int Layout::add(std::string name, SliceKind kind, int size) {
  const int index = int(slices_.size());
  const Place place{std::hash<std::string_view>{}(name), index};
  Slice slice{.name = std::move(name), .kind = kind, .begin = int(size_), .size = size};
  set_range(slice);
  slices_.push_back(std::move(slice));
  size_ += std::size_t(size);
  if (2 * slices_.size() > table_.size()) {
    const std::vector<Place> old =
        std::exchange(table_, std::vector<Place>(std::max<std::size_t>(64, 2 * table_.size())));
    for (const Place& known : old)
      if (known.slice >= 0) enter(known);
  }
  enter(place);
  return index;
}

void Layout::enter(Place place) {
  const std::size_t mask = table_.size() - 1;
  std::size_t at = place.hash & mask;
  while (table_[at].slice >= 0) at = (at + 1) & mask;
  table_[at] = place;
}

int Layout::find(std::string_view name) const {
  if (table_.empty()) return -1;
  const std::size_t hash = std::hash<std::string_view>{}(name), mask = table_.size() - 1;
  std::size_t at = hash & mask;
  for (; table_[at].slice >= 0; at = (at + 1) & mask)
    if (table_[at].hash == hash && slices_[std::size_t(table_[at].slice)].name == name) break;
  return table_[at].slice;
}

void apply_rules(const Layout& layout, const FaceVector& rest, FaceVector& vector) {
  for (const Slice& slice : layout.slices())
    for (int i = slice.begin; i < slice.begin + slice.size; ++i) {
      double& value = vector[std::size_t(i)];
      if (std::isnan(value)) value = rest[std::size_t(i)];
      value = std::clamp(value, -layout.largest, layout.largest);
      if (slice.rule == Rule::clamp) value = std::clamp(value, slice.lo, slice.hi);
      if (slice.rule == Rule::wrap) value = wrapped(value, slice.lo, slice.hi);
    }
}

}  // namespace mien
