#include "render/shade/look_shader.h"
#include "render/shade/light/light_tile.h"
#include "render/shade/radial_means.h"
#include "render/shade/ramp_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {
namespace {

using Kind = LookStep::Kind;

void fill(ColorRow& to, const Mix& mix, int count) {
  to.room_for(std::size_t(count));
  std::fill_n(to.r.begin(), count, float(mix.r));
  std::fill_n(to.g.begin(), count, float(mix.g));
  std::fill_n(to.b.begin(), count, float(mix.b));
  std::fill_n(to.a.begin(), count, float(mix.a));
}

void lay_over(ColorRow& to, const Mix& mix, int count) {
  const float r = float(mix.r), g = float(mix.g), b = float(mix.b), a = float(mix.a),
              keep = float(1.0 - mix.a);
  for (int i = 0; i < count; ++i) to.r[i] = to.r[i] * keep + r;
  for (int i = 0; i < count; ++i) to.g[i] = to.g[i] * keep + g;
  for (int i = 0; i < count; ++i) to.b[i] = to.b[i] * keep + b;
  for (int i = 0; i < count; ++i) to.a[i] = to.a[i] * keep + a;
}

void multiply_group(ColorRow& to, const ColorRow& group, float opacity, int count) {
  for (int i = 0; i < count; ++i) {
    const float r = opacity * group.r[i], g = opacity * group.g[i], b = opacity * group.b[i],
                a = opacity * group.a[i], clear = 1.0f - to.a[i], keep = 1.0f - a;
    to.r[i] = to.r[i] * (keep + r) + clear * r;
    to.g[i] = to.g[i] * (keep + g) + clear * g;
    to.b[i] = to.b[i] * (keep + b) + clear * b;
    to.a[i] = to.a[i] * (keep + a) + clear * a;
  }
}

void screen_group(ColorRow& to, const ColorRow& group, float opacity, int count) {
  for (int i = 0; i < count; ++i) {
    to.r[i] = to.r[i] * (1.0f - opacity * group.r[i]) + opacity * group.r[i];
    to.g[i] = to.g[i] * (1.0f - opacity * group.g[i]) + opacity * group.g[i];
    to.b[i] = to.b[i] * (1.0f - opacity * group.b[i]) + opacity * group.b[i];
    to.a[i] = to.a[i] * (1.0f - opacity * group.a[i]) + opacity * group.a[i];
  }
}

void lay_group(ColorRow& to, const ColorRow& group, MixMode mode, float opacity, int count) {
  if (mode == MixMode::multiply) return multiply_group(to, group, opacity, count);
  if (mode == MixMode::screen) return screen_group(to, group, opacity, count);
  for (int i = 0; i < count; ++i) {
    const float keep = 1.0f - opacity * group.a[i];
    to.r[i] = to.r[i] * keep + opacity * group.r[i];
    to.g[i] = to.g[i] * keep + opacity * group.g[i];
    to.b[i] = to.b[i] * keep + opacity * group.b[i];
    to.a[i] = to.a[i] * keep + opacity * group.a[i];
  }
}

RampLanes ramp_lanes(const RampSegment& s) {
  const auto& p = s.at;
  const auto& q = s.slope;
  return {{float(p.r), float(p.g), float(p.b), float(p.a)},
          {float(q.r), float(q.g), float(q.b), float(q.a)},
          float(s.from),
          float(s.to)};
}

/// Mean t around (x + from + i, y).
void along(const PaintField& field, double x, double y, int from, int count, double variance,
           float* t) {
  if (field.kind == PaintField::Kind::linear) {
    const float first = float(field.at({x, y}, 0.0)), step = float(field.across.x);
    for (int i = 0; i < count; ++i) t[i] = first + step * float(from + i);
    return;
  }
  const glm::dmat2& u = field.unit;
  const glm::dvec2 q = u * (glm::dvec2{x, y} - field.center);
  const double trace = glm::dot(u[0], u[0]) + glm::dot(u[1], u[1]);
  radial_places({.qx = float(q.x),
                 .qy = float(q.y),
                 .sx = float(u[0].x),
                 .sy = float(u[0].y),
                 .ax = float(u[0].x),
                 .ay = float(u[0].y),
                 .bx = float(u[1].x),
                 .by = float(u[1].y),
                 .trace = float(trace),
                 .variance = float(variance),
                 .from = from},
                count, t);
}

}  // namespace

LitPart LookShader::Places::part(int x, int y) const {
  return {form, float(first.x - x - 0.5), float(first.y - y - 0.5), float(area)};
}

void LookShader::lay(const LookStep& step, const Places& at, ColorRow& to) {
  if (step.zone >= 0) return lay_lit(step, at, to);
  if (step.segment < 0) return lay_integral(step, at, to);
  const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
  const RampSegment& segment = looks_->segment(step);
  const std::size_t count = std::size_t(at.count);
  if (t_.size() < count + kColorSpare) t_.resize(count + kColorSpare);
  if (at.cells)
    along_cells(varied, at, t_.data());
  else if (varied.paint.field.kind == PaintField::Kind::distance)
    along_distance(varied, at, t_.data());
  else
    along(varied.paint.field, at.first.x, at.first.y, at.from, at.count, at.area / 12, t_.data());
  lay_ramp(ramp_lanes(segment), t_.data(), at.count, to.r.data(), to.g.data(), to.b.data(),
           to.a.data());
}

/// Mean t along a distance.
void LookShader::along_distance(const VariedPaint& varied, const Places& at, float* t) {
  const LitPaint& lit = looks_->paints().lit[std::size_t(varied.lit)];
  const int x = int(std::floor(at.first.x)), y = int(std::floor(at.first.y));
  if (at.form)
    t[0] = lit.distance_of_part(x, y, at.part(x, y), lit_scratch_);
  else
    lit.distances(x + at.from, y, at.count, t, lit_scratch_);
  const float from = float(varied.paint.field.from), scale = float(varied.paint.field.scale);
  for (int i = 0; i < at.count; ++i) t[i] = (t[i] - from) * scale;
}

/// t at the cells' centroids, and of a radial gradient how it bends within a cell.
void LookShader::along_cells(const VariedPaint& varied, const Places& at, float* t) {
  const PaintField& field = varied.paint.field;
  const int x = int(std::floor(at.first.x)), y = int(std::floor(at.first.y));
  if (field.kind == PaintField::Kind::distance) {
    const LitPaint& lit = looks_->paints().lit[std::size_t(varied.lit)];
    lit.distances_of_cells(x, y, *at.cells, t, lit_scratch_);
    // A ridge that runs through cells lowers their mean; the part's own mean is more exact.
    float mean = 0.0f, sum = 0.0f, area = 0.0f;
    if (at.form)
      mean = lit.distance_of_part(x, y, at.part(x, y), lit_scratch_);
    else
      lit.distances(x, y, 1, &mean, lit_scratch_);
    for (std::size_t k = 0; k < std::size_t(at.count); ++k)
      sum += at.cells->area[k] * t[k], area += at.cells->area[k];
    if (area > 0.0f)
      for (int i = 0; i < at.count; ++i) t[i] += mean - sum / area;
    for (int i = 0; i < at.count; ++i) t[i] = float(field.at({}, double(t[i])));
    return;
  }
  const glm::dvec2 middle{x + 0.5, y + 0.5};
  const float *const dx = at.cells->x.data(), *const dy = at.cells->y.data();
  if (field.kind == PaintField::Kind::radial) {
    const double variance = double(at.cells->cell() * at.cells->cell()) / 12;
    return radial_means(field, middle, variance, dx, dy, at.count, t);
  }
  for (int i = 0; i < at.count; ++i) t[i] = float(field.at(middle + glm::dvec2{dx[i], dy[i]}, 0.0));
}

glm::vec4 LookShader::by_cells(int look, int x, int y, const PartForm* form, int side,
                               bool coarse) {
  if (form) cells_of_form(*form, side, cells_, coarse);
  const PartCells& cells = form ? cells_ : whole_cells(side);
  // Under a ramp whose opacity varies, and under a group that mixes, lower layers count place by place.
  each_ = std::any_of(
      looks_->steps(look).begin(), looks_->steps(look).end(), [&](const LookStep& step) {
        const auto fades = [&] {
          const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
          if (varied.integral)
            return varied.paint.ramp->least_opacity() < varied.paint.ramp->most_opacity();
          return varied.paint.ramp && looks_->segment(step).slope.a != 0.0;
        };
        return step.mode != MixMode::normal || (step.kind == Kind::paint && fades());
      });
  LitPart part{nullptr, 0.0f, 0.0f, 1.0f};
  if (form) part = part_of(*form, cells);
  const glm::dvec2 middle{x + 0.5 + double(part.x), y + 0.5 + double(part.y)};
  const ColorRow& c = places(look, {middle, 0, cells.count(), double(part.area), form, &cells});
  glm::vec4 sum{0.0f};
  float area = 0.0f;
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    sum += cells.area[k] * glm::vec4{c.r[k], c.g[k], c.b[k], c.a[k]};
    area += cells.area[k];
  }
  return area > 0.0f ? sum / area : glm::vec4{c.r[0], c.g[0], c.b[0], c.a[0]};
}

void LookShader::lay_lit(const LookStep& step, const Places& at, ColorRow& to) {
  const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
  const LitPaint& lit = looks_->paints().lit[std::size_t(varied.lit)];
  const bool segmented = varied.paint.ramp && !varied.integral;
  const LitPiece piece{step.zone, segmented ? &looks_->segment(step) : nullptr};
  lit_.room_for(std::size_t(at.count));
  const int x = int(std::floor(at.first.x)), y = int(std::floor(at.first.y));
  if (at.cells) {
    const LitPart part = at.part(x, y);
    lit.colors_of_cells(piece, x, y, *at.cells, at.form ? &part : nullptr, each_, lit_.r, lit_.g,
                        lit_.b, lit_.a, lit_scratch_);
  } else if (at.form) {
    const glm::vec4 c = lit.part(piece, x, y, at.part(x, y), lit_scratch_);
    lit_.r[0] = c.r, lit_.g[0] = c.g, lit_.b[0] = c.b, lit_.a[0] = c.a;
  } else {
    lit.pixels(piece, x + at.from, y, at.count, lit_.r.data(), lit_.g.data(), lit_.b.data(),
               lit_.a.data(), lit_scratch_);
  }
  lay_group(to, lit_, MixMode::normal, 1.0f, at.count);
}

Mix LookShader::ramp_mean_of(const VariedPaint& varied, int x, int y, const PartForm* form) {
  const PaintField& field = varied.paint.field;
  constexpr double kReach = 0.70711,
                   kGentle = 0.1;  // [px, 1/px] far enough from a centre for a mean to second order
  if (!form && field.kind != PaintField::Kind::distance &&
      field.bend({x + 0.5, y + 0.5}) < kGentle) {
    const RampPlane plane =
        varied.integral->scaled({field.mean({x + 0.5, y + 0.5}, 1.0 / 12), field.per_pixel, 0.0});
    Mix color;
    if (varied.integral->straight(plane.t, kReach * plane.gx, color)) return color;
  }
  const RampCells& cells = planes_.of(varied, lit_of(varied), x, y, 1, lit_scratch_);
  if (!form) return ramp_mean(*varied.integral, cells);
  chords_of_form(*form, chords_);
  return ramp_mean(*varied.integral, cells, chords_);
}

/// Of each of a pixel's cells; their mean is that of the part.
void LookShader::ramp_means_of_cells(const VariedPaint& varied, const Places& at) {
  const int x = int(std::floor(at.first.x)), y = int(std::floor(at.first.y));
  const PartCells& cells = *at.cells;
  const Mix mean = ramp_mean_of(varied, x, y, at.form);
  const RampCells& planes = planes_.of(varied, lit_of(varied), x, y, cells.side, lit_scratch_);
  const PartCells& whole = whole_cells(planes.side);
  const int finer = planes.side / cells.side;
  Mix sum{0.0};
  double area = 0.0;
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    const int column = int(k) % cells.side * finer + finer / 2,
              row = int(k) / cells.side * finer + finer / 2;
    RampPlane plane = planes.planes[std::size_t(row * planes.side + column)];
    plane.t = plane.at(double(cells.x[k] - whole.x[std::size_t(column)]),
                       double(cells.y[k] - whole.y[std::size_t(row * planes.side)]));
    const Mix c = varied.integral->box_mean(plane, double(cells.cell()));
    lit_.r[k] = float(c.r), lit_.g[k] = float(c.g), lit_.b[k] = float(c.b), lit_.a[k] = float(c.a);
    sum += double(cells.area[k]) * c, area += double(cells.area[k]);
  }
  const glm::vec4 by{area > 0.0 ? mean - sum / area : Mix{0.0}};
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k)
    lit_.r[k] += by.r, lit_.g[k] += by.g, lit_.b[k] += by.b, lit_.a[k] += by.a;
}

void LookShader::lay_integral(const LookStep& step, const Places& at, ColorRow& to) {
  const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
  const int x = int(std::floor(at.first.x)), y = int(std::floor(at.first.y));
  if (varied.rows && !at.form && !at.cells) return varied.rows->lay(x, y, at.from, at.count, to);
  lit_.room_for(std::size_t(at.count));
  if (at.cells)
    ramp_means_of_cells(varied, at);
  else
    for (int i = 0; i < at.count; ++i) {
      const Mix c = ramp_mean_of(varied, x + at.from + i, y, at.form);
      const auto k = std::size_t(i);
      lit_.r[k] = float(c.r), lit_.g[k] = float(c.g);
      lit_.b[k] = float(c.b), lit_.a[k] = float(c.a);
    }
  lay_group(to, lit_, MixMode::normal, 1.0f, at.count);
}

/// What places() makes of one place, bit by bit, without its planes.
glm::vec4 LookShader::plain_part(int look, double x, double y, double area) const {
  constexpr std::size_t kLanes = 1 + kColorSpare;
  std::array<float, kLanes> t{}, r{}, g{}, b{}, a{};
  for (const LookStep& step : looks_->steps(look)) {
    const Mix& mix = step.mix;
    if (step.kind == Kind::open) {
      r[0] = float(mix.r), g[0] = float(mix.g), b[0] = float(mix.b), a[0] = float(mix.a);
    } else if (step.kind == Kind::over) {
      const float keep = float(1.0 - mix.a);
      r[0] = r[0] * keep + float(mix.r), g[0] = g[0] * keep + float(mix.g);
      b[0] = b[0] * keep + float(mix.b), a[0] = a[0] * keep + float(mix.a);
    } else {
      const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
      along(varied.paint.field, x, y, 0, 1, area / 12, t.data());
      lay_ramp(ramp_lanes(looks_->segment(step)), t.data(), 1, r.data(), g.data(), b.data(),
               a.data());
    }
  }
  return {r[0], g[0], b[0], a[0]};
}

const ColorRow& LookShader::places(int look, const Places& at) {
  std::size_t open = 0;
  for (const LookStep& step : looks_->steps(look)) {
    switch (step.kind) {
      case Kind::open:
        if (levels_.size() == open) levels_.emplace_back();
        fill(levels_[open++], step.mix, at.count);
        break;
      case Kind::over:
        if (step.mode == MixMode::normal) {
          lay_over(levels_[open - 1], step.mix, at.count);
          break;
        }
        if (levels_.size() == open) levels_.emplace_back();
        fill(levels_[open], step.mix, at.count);
        lay_group(levels_[open - 1], levels_[open], step.mode, 1.0f, at.count);
        break;
      case Kind::paint:
        lay(step, at, levels_[open - 1]);
        break;
      case Kind::close:
        --open;
        lay_group(levels_[open - 1], levels_[open], step.mode, float(step.mix.a), at.count);
        break;
    }
  }
  return levels_[0];
}

}  // namespace mien
