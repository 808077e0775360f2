// What means by centroids neglect of a look.
#include "render/cover/part_form.h"
#include "render/shade/looks.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

using Kind = LookStep::Kind;

}  // namespace

double Looks::slope_of(const LookStep& step) const {
  const Mix& along = segment(step).slope;
  return paints_->varied[std::size_t(step.varied)].paint.field.per_pixel *
         std::max({std::abs(along.r), std::abs(along.g), std::abs(along.b), std::abs(along.a)});
}

bool Looks::estimated(int look) const {
  const std::span<const LookStep> all = steps(look);
  return std::any_of(all.begin(), all.end(), [&](const LookStep& step) {
    return step.kind == Kind::paint && paints_->varied[std::size_t(step.varied)].lit >= 0;
  });
}

/// Two paints over each other: the mean of the upper one's opacity times the lower one's colour differs from the
/// product of their means, by a twelfth of the product of both slopes. A mode other than normal has three products.
double Looks::neglected_by(std::span<const LookStep> steps) {
  constexpr double kLit = 0.3;  // [1/px] what light may change by
  double sum = 0.0, below = 0.0;
  grounds_.clear();
  for (const LookStep& step : steps) {
    if (step.kind == Kind::open) grounds_.push_back(below);
    if (step.kind == Kind::close) {
      const double ground = grounds_.back();
      grounds_.pop_back();
      if (step.mode != MixMode::normal) sum += 3.0 * (below - ground) * ground / 12;
    }
    if (step.kind != Kind::paint) continue;
    const VariedPaint& varied = paints_->varied[std::size_t(step.varied)];
    const GridPaint& paint = varied.paint;
    const bool lit = step.zone >= 0;
    if (step.segment < 0) {
      if (lit) sum += kLit;  // not by integrals
      // Two spreads: the upper opacity's is at most half its range, and a slope's √(1/12).
      const double slope = varied.integral.steepest() * paint.field.per_pixel;
      const double opacity = paint.ramp->most_opacity() - paint.ramp->least_opacity();
      sum += std::min(0.15 * opacity, opacity > 0.0 ? slope / 12 : 0.0) * below;
      below += std::min(1.8 * varied.integral.range(), slope);
    } else if (paint.ramp) {
      const RampSegment& along = segment(step);
      sum += paint.field.per_pixel * std::abs(along.slope.a) * below / 12;
      below += slope_of(step);
    }
    if (lit) below += kLit;
  }
  return sum;
}

/// Stops that cross are right in cells but where they cross, and so are ramps that change little within the smallest
/// cells; stops that run along each other are not. Where ramps along distances change little enough is seen pixel by
/// pixel (LookShader::with_products).
bool Looks::open_by(std::span<const LookStep> steps) const {
  constexpr double kCrossing = 0.2;                 // the sine of the angle
  constexpr double kSoft = 0.03, kSoftAlong = 1.0;  // what a ramp may change by within a cell
  const auto paint_of = [&](const LookStep& step) -> const GridPaint& {
    return paints_->varied[std::size_t(step.varied)].paint;
  };
  const auto integrated = [](const LookStep& s) { return s.kind == Kind::paint && s.segment < 0; };
  const auto crosses = [&](const PaintField& f, const PaintField& g) {
    return f.kind == PaintField::Kind::linear && g.kind == PaintField::Kind::linear &&
           std::abs(f.across.x * g.across.y - f.across.y * g.across.x) >
               kCrossing * f.per_pixel * g.per_pixel;
  };
  const auto soft = [&](const LookStep& s) {
    const VariedPaint& varied = paints_->varied[std::size_t(s.varied)];
    const PaintField& field = varied.paint.field;
    return varied.integral.steepest() * field.per_pixel <
           (field.kind == PaintField::Kind::distance ? kSoftAlong : kSoft) * PartCells::kMostSide;
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!integrated(steps[i])) continue;
    const GridPaint& upper = paint_of(steps[i]);
    if (steps[i].zone >= 0) return true;
    if (upper.ramp->least_opacity() == upper.ramp->most_opacity()) continue;
    for (const LookStep& below : steps.first(i))
      if (integrated(below) && !(soft(steps[i]) && soft(below)) &&
          !crosses(upper.field, paint_of(below).field))
        return true;
  }
  return false;
}

/// Light below what fades or mixes counts as one, too: how it changes within a pixel has no bound but what is seen.
int Looks::products_of(std::span<const LookStep> steps) const {
  int along = -1, count = 0, light = -1;
  for (const LookStep& step : steps) {
    if (step.mode != MixMode::normal && light >= 0) return light;
    if (step.kind != Kind::paint) continue;
    const VariedPaint& varied = paints_->varied[std::size_t(step.varied)];
    if (light >= 0 && fades(step)) return light;
    if (step.zone >= 0) light = step.varied;
    if (step.zone >= 0 || step.segment >= 0) continue;
    if (varied.paint.field.kind == PaintField::Kind::distance) along = step.varied;
    ++count;
  }
  return count > 1 ? along : -1;
}

bool Looks::fades(const LookStep& step) const {
  const VariedPaint& varied = paints_->varied[std::size_t(step.varied)];
  if (!varied.paint.ramp) return false;
  if (step.segment < 0)
    return varied.paint.ramp->least_opacity() < varied.paint.ramp->most_opacity();
  return segment(step).slope.a != 0.0;
}

}  // namespace mien
