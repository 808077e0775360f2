// What means by centroids neglect of a look, and where its parts need their form.
#include "render/shade/looks.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

using Kind = LookStep::Kind;

}  // namespace

/// What a ramp changes by per pixel.
double Looks::slope_of(const LookStep& step) const {
  const Mix& along = segment(step).slope;
  return paints_->varied[std::size_t(step.varied)].paint.field.per_pixel *
         std::max({std::abs(along.r), std::abs(along.g), std::abs(along.b), std::abs(along.a)});
}

/// Two paints over each other: the mean of the upper one's opacity times the lower one's colour differs from the
/// product of their means, by a twelfth of the product of both slopes. A mode other than normal has three products.
double Looks::neglected_by(std::span<const LookStep> steps, bool& tip) {
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
      const double range = varied.integral->range();
      sum += 0.15 * (paint.ramp->most_opacity() - paint.ramp->least_opacity()) * below;
      below += std::min(1.8 * range, varied.integral->steepest() * paint.field.per_pixel);
    } else if (paint.ramp) {
      const RampSegment& along = segment(step);
      sum += paint.field.per_pixel * std::abs(along.slope.a) * below / 12;
      below += slope_of(step);
      tip = tip || (!lit && paint.field.kind == PaintField::Kind::radial &&
                    along.from < kTipReach * paint.field.per_pixel);
    }
    if (lit) below += kLit;
  }
  return sum;
}

bool Looks::formed_by(std::span<const LookStep> steps) const {
  return std::any_of(steps.begin(), steps.end(), [&](const LookStep& step) {
    return step.kind == Kind::paint &&
           (step.zone >= 0 || step.segment < 0 ||
            paints_->varied[std::size_t(step.varied)].paint.field.kind != PaintField::Kind::linear);
  });
}

/// Stops that cross are right in cells but where they cross; stops that run along each other are not.
bool Looks::open_by(std::span<const LookStep> steps) const {
  constexpr double kCrossing = 0.2;  // the sine of the angle
  const auto paint_of = [&](const LookStep& step) -> const GridPaint& {
    return paints_->varied[std::size_t(step.varied)].paint;
  };
  const auto integrated = [](const LookStep& s) { return s.kind == Kind::paint && s.segment < 0; };
  const auto crosses = [&](const PaintField& f, const PaintField& g) {
    return f.kind == PaintField::Kind::linear && g.kind == PaintField::Kind::linear &&
           std::abs(f.across.x * g.across.y - f.across.y * g.across.x) >
               kCrossing * f.per_pixel * g.per_pixel;
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!integrated(steps[i])) continue;
    const GridPaint& upper = paint_of(steps[i]);
    if (steps[i].zone >= 0) return true;
    if (upper.ramp->least_opacity() == upper.ramp->most_opacity()) continue;
    for (const LookStep& below : steps.first(i))
      if (integrated(below) && !crosses(upper.field, paint_of(below).field)) return true;
  }
  return false;
}

bool Looks::plain_by(std::span<const LookStep> steps) const {
  const auto is_ramp = [&](const LookStep& step) {
    const VariedPaint& varied = paints_->varied[std::size_t(step.varied)];
    return step.zone < 0 && step.segment >= 0 && varied.paint.ramp &&
           varied.paint.field.kind != PaintField::Kind::distance;
  };
  const auto opens = [](const LookStep& step) { return step.kind == Kind::open; };
  return std::count_if(steps.begin(), steps.end(), opens) == 1 &&
         std::all_of(steps.begin(), steps.end(), [&](const LookStep& step) {
           return step.mode == MixMode::normal && (step.kind != Kind::paint || is_ramp(step));
         });
}

/// Notes the radial ramps that are not lit; returns their number.
int Looks::note_bows(std::span<const LookStep> steps) {
  const std::size_t before = bows_.size();
  for (const LookStep& step : steps) {
    if (step.kind != Kind::paint || step.zone >= 0 || step.segment < 0) continue;
    const PaintField& field = paints_->varied[std::size_t(step.varied)].paint.field;
    if (field.kind != PaintField::Kind::radial) continue;
    bows_.push_back({&field, slope_of(step)});
  }
  return int(bows_.size() - before);
}

double Looks::neglected_near(int look, glm::dvec2 p, bool part, double least) const {
  const Look& of = looks_[std::size_t(look)];
  double sum = 0.0;
  for (int i = of.first_bow; i < of.first_bow + of.bows; ++i) {
    const auto& [field, slope] = bows_[std::size_t(i)];
    const double bend = part ? 0.03 * slope : 0.0;
    // r is at least the distance times the smaller radius over the larger one.
    const glm::dvec2 way = p - field->center;
    const double near2 = glm::dot(way, way) * field->narrow * field->narrow;
    if (0.02 * slope + bend * std::sqrt(near2) < least * near2) continue;
    const double r = std::max(field->at(p, 0.0) / field->per_pixel, 0.5);
    sum += 0.02 * slope / (r * r) + bend / r;
  }
  return sum;
}

bool Looks::neglects_near(int look, double from, double to, double y, double least) const {
  const Look& of = looks_[std::size_t(look)];
  const auto first = bows_.begin() + of.first_bow;
  return std::any_of(first, first + of.bows, [&](const Bow& bow) {
    const glm::dvec2 center = bow.field->center,
                     way = glm::dvec2{std::clamp(center.x, from, to), y} - center;
    const double narrow = bow.field->narrow;
    return !(0.02 * bow.slope < least * (glm::dot(way, way) * narrow * narrow));
  });
}

}  // namespace mien
