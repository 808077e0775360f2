#include "sdf/outline/curve/side_list.h"

namespace mien {

void SideList::frame(const Box2& window, double tolerance) {
  window_ = window;
  tolerance_ = tolerance;
  sides_.clear();
  ends_.clear();
}

void SideList::begin(glm::dvec2 p) {
  start_ = at_ = p;
}

void SideList::quad(glm::dvec2 control, glm::dvec2 to) {
  if (!(to == at_ && control == at_)) sides_.push_back({at_, control, to});
  at_ = to;
}

void SideList::close() {
  line(start_);
  if (sides_.size() == (ends_.empty() ? 0 : ends_.back()))
    sides_.push_back({start_, start_, start_});
  ends_.push_back(sides_.size());
}

std::span<const QuadBezier> SideList::loop(std::size_t i) const {
  const std::size_t first = i == 0 ? 0 : ends_[i - 1];
  return std::span(sides_).subspan(first, ends_[i] - first);
}

}  // namespace mien
