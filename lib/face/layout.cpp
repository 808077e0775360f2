#include <mien/layout.h>

#include <algorithm>
#include <limits>

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
  Slice slice{.name = name, .kind = kind, .begin = int(size_), .size = size};
  set_range(slice);
  const int index = int(slices_.size());
  by_name_.emplace(std::move(name), index);
  slices_.push_back(std::move(slice));
  size_ += std::size_t(size);
  return index;
}

int Layout::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? -1 : found->second;
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
