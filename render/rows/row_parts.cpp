// RowPainter's parts of pixels: what varied looks take, found cell by cell, shaded look by look, many at once.
#include "render/rows/row_painter.h"

#include <algorithm>
#include <cmath>

namespace mien {

/// Adds what varied looks take of the pixel, and of those after it.
void RowPainter::take_shares(int first) {
  for (Open& o : open_) o.go_on();
  for (int i = first; i >= 0; i = shares_[std::size_t(i)].next) {
    const LookShare& s = shares_[std::size_t(i)];
    if (s.left >= 0) take(s.left, -1.0f, i);
    if (s.right >= 0) take(s.right, 1.0f, i);
  }
  for (int i = first; i >= 0; i = shares_[std::size_t(i)].next) taken_.push_back(i);
}

void RowPainter::take(int look, float sign, int share) {
  auto o = std::find_if(open_.begin(), open_.end(), [&](const Open& x) { return x.look == look; });
  if (o == open_.end())
    o = open_.insert(o, {look, {int(taken_.size()), false}, 0.0f, 0.0f, 0.0f, {}});
  const auto k = std::size_t(share);
  Moments& m = o->here;
  m.area += sign * shares_[k].area;
  m.x += sign * moments_.x[k], m.y += sign * moments_.y[k];
  m.xx += sign * moments_.xx[k], m.xy += sign * moments_.xy[k], m.yy += sign * moments_.yy[k];
  o->height += sign * shares_[k].rest;
  o->height_y += sign * moments_.rest_y[k], o->height_yy += sign * moments_.rest_yy[k];
}

/// By look; parts of one stay in order.
void RowPainter::sort_parts() {
  by_look_.clear();
  if (index_of_look_.size() < std::size_t(looks_->count()))
    index_of_look_.resize(std::size_t(looks_->count()), -1);
  for (const Part& part : parts_) {
    int& index = index_of_look_[std::size_t(part.look)];
    if (index < 0) index = int(by_look_.size()), by_look_.push_back({0, 0});
    ++by_look_[std::size_t(index)].second;
  }
  for (std::size_t i = 1; i < by_look_.size(); ++i)
    by_look_[i].first = by_look_[i - 1].first + by_look_[i - 1].second;
  sorted_.resize(parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i)
    sorted_[std::size_t(
        by_look_[std::size_t(index_of_look_[std::size_t(parts_[i].look)])].first++)] = int(i);
  for (const Part& part : parts_) index_of_look_[std::size_t(part.look)] = -1;
}

void RowPainter::shade_parts() {
  sort_parts();
  entered_.look = -1;
  places_.room_for(parts_.size()), variances_.room_for(parts_.size());
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = parts_[std::size_t(sorted_[k])];
    const Moments& m = part.of;
    const float up = 1.0f / m.area;
    const float x = std::clamp(m.x * up, -0.4999f, 0.4999f),
                y = std::clamp(m.y * up, -0.4999f, 0.4999f);
    places_.r[k] = float(columns_[std::size_t(part.cell)]);
    places_.g[k] = x, places_.b[k] = y, places_.a[k] = std::min(std::abs(m.area), 1.0f);
    variances_.r[k] = std::clamp(m.xx * up - x * x, 0.0f, 0.25f);
    variances_.g[k] = std::clamp(m.xy * up - x * y, -0.25f, 0.25f);
    variances_.b[k] = std::clamp(m.yy * up - y * y, 0.0f, 0.25f);
  }
  for (const auto& [end, count] : by_look_)
    shade_look(std::size_t(end - count), std::size_t(count));
  lay_parts();
}

/// The mean colours over what a look takes of pixels.
void RowPainter::shade_look(std::size_t first, std::size_t count) {
  const auto part = [&](std::size_t i) -> Part& { return parts_[std::size_t(sorted_[first + i])]; };
  const ColorPlanes p = places_.planes(), v = variances_.planes();
  const LanePlaces at{int(count),  p.r + first, p.g + first, p.b + first,
                      v.r + first, v.g + first, v.b + first};
  const ColorRow& c = shader_.parts(
      part(0).look, y_,
      {at, p.a + first, [&](int i) -> const PartForm& { return form(part(std::size_t(i))); }});
  for (std::size_t i = 0; i < count; ++i)
    part(i).color = {c.r[i], c.g[i], c.b[i], c.a[i]}, part(i).neglected = shader_.neglected()[i];
}

/// Adds parts to their pixels; those of which too much is neglected are seen in cells.
void RowPainter::lay_parts() {
  for (std::size_t i = 0, end = 0; i < parts_.size(); i = end) {
    const auto k = std::size_t(parts_[i].cell);
    const Rgba sum{cells_.r[k], cells_.g[k], cells_.b[k], cells_.a[k]};
    Rgba mix = sum;
    double neglected = 0.0;
    for (end = i; end < parts_.size() && parts_[end].cell == parts_[i].cell; ++end) {
      const Part& part = parts_[end];
      mix = mix + part.of.area * part.color;
      if (notes_ && looks_->estimated(part.look)) notes_->estimate(columns_[k], y_);
      neglected +=
          double(std::abs(part.of.area)) * (looks_->neglected(part.look) + double(part.neglected));
    }
    const int side = neglected > least_ ? cells_for(neglected, mix, columns_[k]) : 0;
    if (side > 0) mix = sum + parts_in_cells(i, end, side);
    cells_.r[k] = mix.r, cells_.g[k] = mix.g, cells_.b[k] = mix.b, cells_.a[k] = mix.a;
  }
}

Rgba RowPainter::parts_in_cells(std::size_t first, std::size_t end, int side) {
  Rgba sum;
  for (std::size_t i = first; i < end; ++i) {
    const Part& part = parts_[i];
    const glm::vec4 c = shader_.by_cells(part.look, columns_[std::size_t(part.cell)], y_,
                                         &form(part), side, format_->depth() == Depth::u8);
    sum = sum + part.of.area * Rgba{c.r, c.g, c.b, c.a};
  }
  return sum;
}

/// The stretches in the pixel, and what those before it did to all pixels after them: of a look's parts, which are asked
/// for from the left, each goes on where the one before ended.
const PartForm& RowPainter::form(const Part& part) {
  const auto each_stretch = [&](int first, int end, const auto& sink) {
    for (int i = first; i < end; ++i) {
      const auto k = std::size_t(taken_[std::size_t(i)]);
      const LookShare& s = shares_[k];
      if (s.left == s.right || (s.left != part.look && s.right != part.look)) continue;
      PartStretch stretch = stretches_[k];
      stretch.sign = s.left == part.look ? -1.0f : 1.0f;
      sink(stretch);
    }
  };
  if (entered_.look != part.look || entered_.left != part.left || entered_.until > part.before) {
    entered_ = {part.look, part.left, part.left.since};
    form_.left = part.left.whole ? PartEntry::whole() : PartEntry{};
  }
  each_stretch(entered_.until, part.before, [&](const PartStretch& s) { form_.left.add(s); });
  entered_.until = std::max(entered_.until, part.before);
  in_pixel_.clear();
  each_stretch(part.before, part.until, [&](const PartStretch& s) { in_pixel_.push_back(s); });
  form_.stretches = in_pixel_;
  return form_;
}

}  // namespace mien
