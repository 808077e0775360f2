#include <mien/layout.h>

#include <algorithm>

namespace mien {
namespace {

double wrapped(double value, double lo, double hi) {
  if (value >= lo && value < hi) return value;
  const double turned = value - (hi - lo) * std::floor((value - lo) / (hi - lo));
  return turned >= lo && turned < hi ? turned : lo;  // rounding may land on hi
}

}  // namespace

int Layout::add(std::initializer_list<std::string_view> name, SliceKind kind, int size) {
  const int index = int(slices_.size());
  slices_.push_back({.name = names_.keep(name), .kind = kind, .begin = int(size_), .size = size});
  size_ += std::size_t(size);
  table_.enter(slices_.back().name, index);
  return index;
}

int Layout::find(std::string_view name) const {
  return table_.find(name, [&](int slice) { return slices_[std::size_t(slice)].name; });
}

void apply_rules(const Layout& layout, const FaceVector& rest, FaceVector& vector) {
  for (const Slice& slice : layout.slices()) {
    const SliceRange range = slice.range();
    for (int i = slice.begin; i < slice.begin + slice.size; ++i) {
      double& value = vector[std::size_t(i)];
      if (std::isnan(value)) value = rest[std::size_t(i)];
      value = std::clamp(value, -layout.largest, layout.largest);
      if (range.rule == Rule::clamp) value = std::clamp(value, range.lo, range.hi);
      if (range.rule == Rule::wrap) value = wrapped(value, range.lo, range.hi);
    }
  }
}

}  // namespace mien
