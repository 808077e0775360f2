#include <mien/render/tile/local_paint.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// The lines of the square along which a bilinear function takes a value, as cuts; the bilinear
/// term left out.
void add_cuts(const Bilinear& f, std::span<const double> values, std::vector<Cut>& cuts) {
  const double length = std::sqrt(f.x * f.x + f.y * f.y);
  if (!(length > 0.0)) return;
  for (const double value : values)
    cuts.push_back({(f.mean - value) / length, glm::dvec2{f.x, f.y} / length});
}

}  // namespace

Bilinear bilinear(const std::array<double, 4>& c, double center) {
  const double left = c[0] + c[2], right = c[1] + c[3], top = c[0] + c[1], bottom = c[2] + c[3];
  const double corners = 0.25 * (left + right);
  return {.mean = (2.0 * center + corners) / 3.0,
          .x = 0.5 * (right - left),
          .y = 0.5 * (bottom - top),
          .xy = (c[0] + c[3]) - (c[1] + c[2]),
          .residual = std::abs(center - corners)};
}

glm::dvec2 LocalPaint::slope(glm::dvec2 u) const {
  const glm::dvec2 gradient{(distance.x + distance.xy * u.y) / side,
                            (distance.y + distance.xy * u.x) / side};
  return paint->relief->slope(center + side * u, distance.at(u), gradient);
}

Mix LocalPaint::color(glm::dvec2 u) const {
  const Mix base = paint->ramp ? paint->ramp->color(place.at(u)) : paint->color;
  return paint->relief ? paint->relief->lamp.lit(base, slope(u), blend) : base;
}

Bilinear PaintSampler::distance_in(int distance, glm::dvec2 center, double side) {
  const AreaDistance& area = tape_.distances[std::size_t(distance)];
  if (side != 1.0) {
    const double h = 0.5 * side;
    return bilinear({area.at(center + glm::dvec2{-h, -h}), area.at(center + glm::dvec2{h, -h}),
                     area.at(center + glm::dvec2{-h, h}), area.at(center + glm::dvec2{h, h})},
                    area.at(center));
  }
  // Blocks begin at multiples of kBlock, or half a pixel beside them: centres are at halves or at
  // whole numbers as the picture's side is even or odd.
  constexpr int kBlock = DistanceLattice::kBlock;
  const double left = center.x - 0.5, top = center.y - 0.5;
  const double x = kBlock * std::floor(left / kBlock) + (left - std::floor(left));
  const double y = kBlock * std::floor(top / kBlock) + (top - std::floor(top));
  DistanceLattice& lattice = lattices_[std::size_t(distance)];
  lattice.fill(area, {x, y});
  const int column = int(left - x), row = int(top - y);
  return bilinear(lattice.corners(column, row), lattice.center(column, row));
}

Bilinear PaintSampler::place_in(const PaintField& field, glm::dvec2 center, double side) {
  if (field.kind == PaintField::Kind::linear)
    return {.mean = field.at(center, 0.0),
            .x = field.across.x * side,
            .y = field.across.y * side,
            .xy = 0.0,
            .residual = 0.0};
  if (field.kind == PaintField::Kind::distance) {
    Bilinear d = distance_in(field.distance, center, side);
    d.mean = (d.mean - field.from) * field.scale;
    d.x *= field.scale, d.y *= field.scale, d.xy *= field.scale;
    d.residual *= std::abs(field.scale);
    return d;
  }
  const double h = 0.5 * side;
  const auto at = [&](double x, double y) { return field.at(center + glm::dvec2{x, y}, 0.0); };
  return bilinear({at(-h, -h), at(h, -h), at(-h, h), at(h, h)}, at(0.0, 0.0));
}

LocalPaint PaintSampler::local(int index, glm::dvec2 center, double side) {
  const TapePaint& paint = tape_.paints[std::size_t(index)];
  LocalPaint local{.paint = &paint,
                   .blend = tape_.blend,
                   .center = center,
                   .side = side,
                   .place = {},
                   .distance = {}};
  if (paint.ramp) local.place = place_in(paint.field, center, side);
  if (paint.relief && paint.relief->distance >= 0)
    local.distance = distance_in(paint.relief->distance, center, side);
  return local;
}

double PaintSampler::error(const LocalPaint& local, bool whole, std::vector<Cut>& cuts) {
  double error = 0.0;
  if (local.paint->ramp) {
    const Bilinear& t = local.place;
    const double reach = t.reach() + t.residual;
    const Ramp::Range range = local.paint->ramp->range(t.mean - reach, t.mean + reach, kinks_);
    if (range.many) return 1.0;
    add_cuts(t, kinks_, cuts);
    // Bilinear terms bend the lines along which t is constant: they count where colours are cut.
    const double bent = t.residual + (kinks_.empty() ? 0.0 : 0.25 * std::abs(t.xy));
    error += range.slope * (whole && kinks_.empty() ? t.residual / 6.0 : 0.5 * bent);
    if (range.jump > 0.0) {
      const double length = std::sqrt(t.x * t.x + t.y * t.y);
      error += length > 0.0 ? range.jump * std::min(1.0, bent / length) : range.jump;
    }
  }
  if (local.paint->relief && local.paint->relief->distance >= 0) {
    const Bilinear& d = local.distance;
    const double reach = d.reach() + d.residual;
    local.paint->relief->kinks(d.mean - reach, d.mean + reach, kinks_);
    add_cuts(d, kinks_, cuts);
  }
  return error;
}

/// Of a ramp without jumps, with its kinks in kinks_.
PaintSampler::Mean PaintSampler::ramp_mean(const Ramp& ramp, const Bilinear& t,
                                           const Ramp::Range& range) const {
  Mean mean{ramp.color(t.mean)};
  if (range.constant) return mean;
  if (!kinks_.empty()) {
    // Quarter by quarter: see the error below.
    mean.mix = Mix{0.0};
    for (const glm::dvec2 u :
         {glm::dvec2{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}})
      mean.mix += 0.25 * ramp.color(t.at(u));
  }
  // Between kinks colours are linear, so those and the ends are the extremes.
  const double reach = t.reach() + t.residual;
  double before = t.mean - reach;
  Mix color = ramp.color(before), slope{0.0};
  mean.change = glm::abs(color - mean.mix);
  const auto go_to = [&](double place) {
    const Mix next = ramp.color(place);
    mean.change = glm::max(mean.change, glm::abs(next - mean.mix));
    slope = glm::max(slope, glm::abs(next - color) / std::max(place - before, 1e-12));
    before = place, color = next;
  };
  for (const double kink : kinks_) go_to(kink);
  go_to(t.mean + reach);
  mean.error = slope * (t.residual / 6.0);
  mean.bent = slope * t.residual;  // a piece's mean knows nothing of the residual's own
  // A kink turns a quarter's ramp by twice its slope at most, which moves its mean by a quarter of what the quarter
  // changes, half of what the square does; a line passes through three quarters.
  if (!kinks_.empty()) {
    mean.error += 0.75 * 0.25 * mean.change;
    mean.bent +=
        0.75 * 0.25 * mean.change + 0.25 * mean.change;  // half the change instead of a quarter
  }
  return mean;
}

std::optional<PaintSampler::Mean> PaintSampler::mean(int index, glm::dvec2 center, double side) {
  const TapePaint& paint = tape_.paints[std::size_t(index)];
  if (paint.relief && paint.relief->distance >= 0) return {};
  Mean mean{paint.color};
  LocalPaint local{.paint = &paint,
                   .blend = tape_.blend,
                   .center = center,
                   .side = side,
                   .place = {},
                   .distance = {}};
  if (paint.ramp) {
    const Bilinear& t = local.place = place_in(paint.field, center, side);
    const double reach = t.reach() + t.residual;
    const Ramp::Range range = paint.ramp->range(t.mean - reach, t.mean + reach, kinks_);
    if (range.many || range.jump > 0.0) return {};
    mean = ramp_mean(*paint.ramp, t, range);
  }
  return paint.relief ? lit(local, mean) : mean;
}

/// Gauss's four points, exact for cubics; five others tell how far it may be off, and the corners how much the
/// light changes: by a quarter more, for what is not linear.
PaintSampler::Mean PaintSampler::lit(const LocalPaint& local, const Mean& unlit) const {
  constexpr double kGauss = 0.28867513459481288;  // 1/(2 sqrt 3)
  Mix gauss{0.0}, corners{0.0};
  Mean mean{Mix{0.0}, Mix{0.0}, unlit.error, unlit.bent};
  for (const double y : {-1.0, 1.0})
    for (const double x : {-1.0, 1.0}) {
      gauss += 0.25 * local.color(kGauss * glm::dvec2{x, y});
      corners += 0.25 * local.color(0.5 * glm::dvec2{x, y});
    }
  mean.mix = gauss;
  const Mix center = local.color({0.0, 0.0});
  for (const double y : {-0.5, 0.5})
    for (const double x : {-0.5, 0.5})
      mean.change = glm::max(mean.change, 1.25 * glm::abs(local.color({x, y}) - gauss));
  const Mix off = glm::abs((2.0 * center + corners) / 3.0 - gauss);
  mean.error += off, mean.bent += 6.0 * off;
  return mean;
}

bool PaintSampler::creased(const LocalPaint& local) const {
  constexpr double kShows = 0.02;  // a change of slope of four times that
  const Bilinear& d = local.distance;
  if (!local.paint->relief || !(d.residual > kShows * local.side)) return false;
  // Where the profile is level, or nearly, as on the ridge of a round one, a crease bends next to nothing.
  const double reach = d.reach() + d.residual;
  double steepest = 0.0;
  for (const double at : {d.mean - reach, d.mean, d.mean + reach})
    steepest = std::max(steepest, std::abs(local.paint->relief->rise(-at)));
  return d.residual * std::min(1.0, steepest) > kShows * local.side;
}

std::optional<Mix> PaintSampler::constant(int index, glm::dvec2 center, double radius) {
  const TapePaint& paint = tape_.paints[std::size_t(index)];
  if (paint.relief) {
    const int distance = paint.relief->distance;
    const double d = distance < 0 ? 0.0 : tape_.distances[std::size_t(distance)].at(center);
    if (!paint.relief->level(center, radius, d)) return {};
  }
  if (!paint.ramp) return paint.color;
  const PaintField& field = paint.field;
  const double d =
      field.distance < 0 ? 0.0 : tape_.distances[std::size_t(field.distance)].at(center);
  const double t = field.at(center, d), reach = radius * field.per_pixel;
  if (!paint.ramp->range(t - reach, t + reach, kinks_).constant) return {};
  return paint.ramp->color(t);
}

}  // namespace mien
