#include "render/shade/look_shader.h"
#include "render/shade/light/light_tile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace mien {
namespace {

using Kind = LookStep::Kind;

std::array<float, 4> floats(const Mix& m) {
  return {float(m.r), float(m.g), float(m.b), float(m.a)};
}

void set_color(ColorRow& to, std::size_t k, const glm::vec4& c) {
  to.r[k] = c.r, to.g[k] = c.g, to.b[k] = c.b, to.a[k] = c.a;
}

/// As many floats alike as there may be places.
struct SameFloats {
  std::array<float, PartCells::kMost + kColorSpare> all;
  explicit SameFloats(float v) { all.fill(v); }
};

/// Whole squares of that side [px]: their variances.
LanePlaces squares(int count, const float* column, const float* x, const float* y, int side) {
  static const SameFloats none(0.0f),
      variances[] = {SameFloats(1.0f / 12),       SameFloats(1.0f / 12 / 4),
                     SameFloats(1.0f / 12 / 16),  SameFloats(1.0f / 12 / 64),
                     SameFloats(1.0f / 12 / 256), SameFloats(1.0f / 12 / 1024)};
  const float* const v = variances[std::size_t(std::countr_zero(unsigned(side)))].all.data();
  const float* const zero = none.all.data();
  return {count, column, x ? x : zero, y ? y : zero, v, zero, v};
}

/// Of squares of twice the side: their areas and centroids, and the means of colours that are known.
void halve(PartCells& cells, std::span<ColorRow* const> colors) {
  const int side = cells.side, half = side / 2;
  for (int k = 0; k < half * half; ++k) {
    const auto to = std::size_t(k), first = std::size_t(2 * (k / half) * side + 2 * (k % half));
    const std::size_t four[] = {first, first + 1, first + std::size_t(side),
                                first + std::size_t(side) + 1};
    std::array<float, 4> share{0.25f, 0.25f, 0.25f, 0.25f};
    float area = 0.0f;
    for (const std::size_t n : four) area += cells.area[n];
    for (std::size_t i = 0; area > 0.0f && i < 4; ++i) share[i] = cells.area[four[i]] / area;
    const auto mean_of = [&](auto& v) {
      float sum = 0.0f;
      for (std::size_t i = 0; i < 4; ++i) sum += share[i] * v[four[i]];
      v[to] = sum;
    };
    mean_of(cells.x), mean_of(cells.y);
    for (ColorRow* c : colors) mean_of(c->r), mean_of(c->g), mean_of(c->b), mean_of(c->a);
    cells.area[to] = area;
  }
  cells.side = half;
}

glm::vec4 mean_over(const PartCells& cells, const ColorRow& c) {
  glm::vec4 sum{0.0f};
  float area = 0.0f;
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    sum += cells.area[k] * glm::vec4{c.r[k], c.g[k], c.b[k], c.a[k]};
    area += cells.area[k];
  }
  return area > 0.0f ? sum / area : glm::vec4{c.r[0], c.g[0], c.b[0], c.a[0]};
}

/// A column near `x`, where floats count from.
float origin_near(double x) {
  constexpr double kMost = 1 << 22;
  return x == x ? float(std::floor(std::clamp(x, -kMost, kMost))) : 0.0f;
}

}  // namespace

const PartForm* LookShader::Places::form() const {
  return part ? part->form : nullptr;
}

/// Counted from where the ramp begins in this row, so that no digits are lost far from there.
void LookShader::linear_step(const PaintField& field, double y, LaneStep& made) const {
  const double from = double(made.from), row = field.at({0.5, y}, 0.0) - from;
  made.kind = LaneStep::Kind::linear;
  made.origin = origin_near(-row / field.across.x);
  made.q = {float(row + double(made.origin) * field.across.x), 0.0f};
  made.by_x = {float(field.across.x), 0.0f}, made.by_y = {float(field.across.y), 0.0f};
}

void LookShader::radial_step(const LookStep& step, double y, LaneStep& made) const {
  const PaintField& field = looks_->paints().varied[std::size_t(step.varied)].paint.field;
  const glm::dmat2& u = field.unit;
  made.kind = LaneStep::Kind::radial;
  made.origin = origin_near(field.center.x);
  const glm::dvec2 q = u * (glm::dvec2{double(made.origin) + 0.5, y} - field.center);
  made.q = {float(q.x), float(q.y)};
  made.by_x = {float(u[0].x), float(u[0].y)}, made.by_y = {float(u[1].x), float(u[1].y)};
  made.uxx = float(glm::dot(u[0], u[0])), made.uxy = float(glm::dot(u[0], u[1]));
  made.uyy = float(glm::dot(u[1], u[1]));
  const double slope = looks_->slope_of(step);
  made.neglects = float(0.0075 * slope * field.per_pixel * field.per_pixel);
  made.most = float(0.25 * slope);
}

/// `y`: of the row's middle.
LaneStep LookShader::ramp_step(const LookStep& step, double y) const {
  const PaintField& field = looks_->paints().varied[std::size_t(step.varied)].paint.field;
  const RampSegment& s = looks_->segment(step);
  LaneStep made{.kind = LaneStep::Kind::linear};
  made.from = float(s.from), made.length = float(s.to - s.from);
  made.color = floats(s.at + s.from * s.slope), made.slope = floats(s.slope);
  if (field.kind == PaintField::Kind::linear)
    linear_step(field, y, made);
  else
    radial_step(step, y, made);
  return made;
}

/// Steps are made anew for every row and look; `give` fills the planes of those that lanes do not know.
template <class Give>
const ColorRow& LookShader::shade(int look, double y, const LanePlaces& at, const Give& give) {
  steps_.clear();
  if (given_.size() < looks_->steps(look).size()) given_.resize(looks_->steps(look).size());
  for (const LookStep& step : looks_->steps(look)) {
    if (step.kind != Kind::paint) {
      steps_.push_back({.kind = step.kind == Kind::open   ? LaneStep::Kind::open
                                : step.kind == Kind::over ? LaneStep::Kind::over
                                                          : LaneStep::Kind::close,
                        .mode = step.mode,
                        .color = floats(step.mix)});
      continue;
    }
    const bool ramp = step.zone < 0 && !looks_->by_integral(step);
    LaneStep made = ramp ? ramp_step(step, y) : LaneStep{.kind = LaneStep::Kind::given};
    if (!ramp) {
      ColorRow& to = given_[steps_.size()];
      to.room_for(std::size_t(at.count));
      give(step, to);
      made.given = {to.r.data(), to.g.data(), to.b.data(), to.a.data()};
    }
    steps_.push_back(made);
  }
  most_neglected_ = shade_lanes(steps_, at, stack_, colors_, neglected_);
  return colors_;
}

const ColorRow& LookShader::pixels(int look, int x, int y, int count) {
  columns_.resize(std::size_t(std::max(count, kBlock)) + kColorSpare);
  for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i] = float(x + int(i));
  const LanePlaces at = squares(count, columns_.data(), nullptr, nullptr, 1);
  return shade(look, y + 0.5, at, [&](const LookStep& step, ColorRow& to) {
    give(step, {x, y, count}, 0, to);
  });
}

const ColorRow& LookShader::parts(int look, int y, const Parts& parts) {
  const LanePlaces& at = parts.at;
  return shade(look, y + 0.5, at, [&](const LookStep& step, ColorRow& to) {
    for (int i = 0; i < at.count; ++i) {
      const LitPart part{&parts.form(i), at.x[i], at.y[i], parts.area[i]};
      give(step, {int(at.column[i]), y, 1, &part}, std::size_t(i), to);
    }
  });
}

glm::vec4 LookShader::by_cells(int look, int x, int y, const PartForm* form, int side,
                               bool coarse) {
  constexpr float kUnsure = 0.3f;  // of the tolerance
  const VariedPaint* const products = looks_->products(look);
  if (form)
    cells_of_form(*form, side, cells_, coarse);
  else if (products)
    cells_ = whole_cells(side);
  const PartCells& cells = form || products ? cells_ : whole_cells(side);
  // Under a ramp whose opacity varies, and under a group that mixes, lower layers count place by place.
  const auto steps = looks_->steps(look);
  each_ = std::any_of(steps.begin(), steps.end(), [&](const LookStep& step) {
    return step.mode != MixMode::normal || (step.kind == Kind::paint && looks_->fades(step));
  });
  LitPart part{nullptr, 0.0f, 0.0f, 1.0f};
  if (form) part = part_of(*form, cells);
  const int count = cells.count();
  columns_.assign(std::size_t(count) + kColorSpare, float(x));
  const LanePlaces at = squares(count, columns_.data(), cells.x.data(), cells.y.data(), side);
  const std::size_t doubts = this->doubts().size();
  const ColorRow& c = shade(look, y + 0.5, at, [&](const LookStep& step, ColorRow& to) {
    give(step, {x, y, count, form ? &part : nullptr, &cells}, 0, to);
  });
  this->doubts().resize(doubts);  // they were told when the mean was asked for
  const glm::vec4 mean = mean_over(cells, c);
  if (!products) return mean;
  float off = 0.0f;
  const glm::vec4 better = with_products(*products, mean, off);
  if (off > kUnsure && side < PartCells::kMostSide)
    return by_cells(look, x, y, form, 2 * side, coarse);
  if (off > kUnsure) this->doubts().push_back({x, off});
  return better;
}

/// What products of ramps, or of light and an opacity, vary by within cells counts four times as much in cells of twice
/// the side: the rest of it is told by two such steps, and what the mean then may be off by as a share of the tolerance by
/// how they differ.
glm::vec4 LookShader::with_products(const VariedPaint& varied, const glm::vec4& mean, float& off) {
  given_rows_.clear();
  for (std::size_t i = 0; i < steps_.size(); ++i)
    if (steps_[i].given[0]) given_rows_.push_back(&given_[i]);
  glm::vec4 told[2], last = mean;
  float area = 0.0f;
  for (std::size_t k = 0; k < std::size_t(cells_.count()); ++k) area += cells_.area[k];
  for (glm::vec4& t : told) {
    halve(cells_, given_rows_);
    const LanePlaces at =
        squares(cells_.count(), columns_.data(), cells_.x.data(), cells_.y.data(), cells_.side);
    shade_lanes(steps_, at, stack_, colors_, neglected_);
    const glm::vec4 next = mean_over(cells_, colors_);
    t = last + (last - next) / 3.0f, last = next;
  }
  constexpr float kLeft = 0.3f;  // of the difference of both
  for (int c = 0; c < 4; ++c) {
    // Linear light v is encoded as steeply as 0.72 / √v at most.
    const float dark = std::max(told[0][c], 0.0144f),
                steep = varied.linear ? 0.72f / std::sqrt(dark) : 1.0f;
    off = std::max(off, kLeft * area * steep * std::abs(told[0][c] - told[1][c]));
  }
  off /= float(varied.tolerance);
  return told[0];
}

/// Colours of a step that lanes do not know, from the `first` place on.
void LookShader::give(const LookStep& step, const Places& at, std::size_t first, ColorRow& to) {
  if (step.zone >= 0) return give_light(step, at, first, to);
  give_means(step, at, first, to);
}

void LookShader::give_light(const LookStep& step, const Places& at, std::size_t first,
                            ColorRow& to) {
  const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
  const LitPaint& lit = *lit_of(varied);
  const LitPiece piece{step.zone,
                       varied.paint.ramp && step.segment >= 0 ? &looks_->segment(step) : nullptr};
  if (at.cells)
    lit.colors_of_cells(piece, at.x, at.y, *at.cells, at.part, each_, to.r, to.g, to.b, to.a,
                        lit_scratch_);
  else if (at.part)
    set_color(to, first, lit.part(piece, at.x, at.y, *at.part, lit_scratch_));
  else
    lit.pixels(piece, at.x, at.y, at.count, to.r.data(), to.g.data(), to.b.data(), to.a.data(),
               lit_scratch_);
}

void LookShader::give_means(const LookStep& step, const Places& at, std::size_t first,
                            ColorRow& to) {
  const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
  const PaintField& field = varied.paint.field;
  const RampIntegral& ramp = looks_->integral(step);
  if (at.cells) return give_means_of_cells(step, at, to);
  if (at.part) return set_color(to, first, glm::vec4(ramp_mean_of_part(step, at)));
  if (field.kind == PaintField::Kind::linear)
    return ramp_rows_.means(ramp, ramp.scaled(field.plane({})), at.x, at.y, at.count, to);
  if (field.kind == PaintField::Kind::radial)
    return planes_.radial_row(varied, at.x, at.y, at.count, to);
  boxes_.clear();
  for (int i = 0; i < at.count; ++i)
    boxes_.close(1.0 / planes_.add(varied, ramp, lit_of(varied), at.x + i, at.y, 1, lit_scratch_,
                                   boxes_.planes));
  ramp_means(ramp, boxes_, to, 0);
}

Mix LookShader::ramp_mean_of_part(const LookStep& step, const Places& at) {
  const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
  const RampIntegral& ramp = looks_->integral(step);
  boxes_.clear();
  const int side =
      planes_.add(varied, ramp, lit_of(varied), at.x, at.y, 1, lit_scratch_, boxes_.planes, true);
  chords_of_form(*at.form(), chords_);
  return part_mean_.of(ramp, boxes_.planes, side, chords_);
}

/// Of each of a pixel's cells, seen about their centroids; a part's are shifted to have its mean.
void LookShader::give_means_of_cells(const LookStep& step, const Places& at, ColorRow& to) {
  const VariedPaint& varied = looks_->paints().varied[std::size_t(step.varied)];
  const RampIntegral& ramp = looks_->integral(step);
  const PartCells& cells = *at.cells;
  const glm::vec4 mean{at.part ? ramp_mean_of_part(step, at) : Mix{0.0}};
  boxes_.clear(), cell_planes_.clear();
  const int side = planes_.add(varied, ramp, lit_of(varied), at.x, at.y, cells.side, lit_scratch_,
                               cell_planes_),
            finer = side / cells.side;
  const PartCells& whole = whole_cells(cells.side);
  glm::vec4 sum{0.0f};
  float area = 0.0f;
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    const int row = int(k) / cells.side * finer, column = int(k) % cells.side * finer;
    const auto dx = double(cells.x[k] - whole.x[k]), dy = double(cells.y[k] - whole.y[k]);
    for (int i = 0; i < finer * finer; ++i) {
      RampPlane p = cell_planes_[std::size_t((row + i / finer) * side + column + i % finer)];
      p.t = p.at(dx, dy);
      boxes_.planes.push_back(p);
    }
    boxes_.close(1.0 / side);
  }
  ramp_means(ramp, boxes_, to, 0);
  if (!at.part) return;
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    sum += cells.area[k] * glm::vec4{to.r[k], to.g[k], to.b[k], to.a[k]};
    area += cells.area[k];
  }
  const glm::vec4 by = area > 0.0f ? mean - sum / area : glm::vec4{0.0f};
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k)
    to.r[k] += by.r, to.g[k] += by.g, to.b[k] += by.b, to.a[k] += by.a;
}

}  // namespace mien
