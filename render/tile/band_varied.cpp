// Pixels and parts of pixels that have edges of their own, and in which colours vary. (Whole leaves are
// varied_square.h's.)
//
// In a pixel a gradient is nearly linear. The mean over a piece of it is then the colour of the pixel's mean
// place, but for how far the piece's middle lies from the pixel's: at most a quarter of what the colour
// changes by from there to the pixel's border (a piece of area A of a square, cut across: A (1 − A)/2 of the change
// from side to side). Where that shows, where a gradient has a kink, and for lit surfaces, the sure way is gone.

#include <mien/render/tile/band.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace mien {
namespace {

/// What a pixel's mean may be off by for colours taken in its middle: a quarter of a level.
constexpr double kAllowed = 0.25 / 255;

/// How much a change of a blended value shows in an encoded one, from `least` on.
double encoding_slope(double least, Blend blend) {
  if (blend != Blend::linear) return 1.0;
  constexpr double kLinearTo = 0.0031308;  // IEC 61966-2-1
  return least <= kLinearTo ? 12.92 : 1.055 / 2.4 * std::pow(least, 1.0 / 2.4 - 1.0);
}

}  // namespace

/// Which layers each combination of sides shows, for the present edges; false where only the sure way knows.
bool BandPainter::see_layers(glm::dvec2 center, double side) {
  if (target_->depth != Depth::u8) return false;
  const Tape& tape = plan_->tape;
  const int count = 1 << leaf_.edge_count;
  std::uint64_t open = (std::uint64_t{1} << count) - 1;
  shown_.clear();
  for (const int layer : leaf_layers_) {
    const TapeLayer& l = tape.layers[std::size_t(layer)];
    const std::span<const Step> steps{tape.steps.data() + l.first, std::size_t(l.count)};
    const std::uint64_t in = sides_of(steps, leaf_sides_, stack_).in & open;
    if (!in) continue;
    if (l.group >= 0 || shown_.size() == 64) return false;
    Shown shown{in, l.mix, -1, {}};
    double opacity = l.mix.a;
    if (l.paint >= 0) {
      const TapePaint& paint = tape.paints[std::size_t(l.paint)];
      if (const auto constant = mix_of(layer, leaf_center_ + center, side)) {
        shown.mix = *constant;
        opacity = constant->a;
      } else {
        shown.paint = l.paint;
        opacity = paint.least_opacity();
      }
    }
    shown_.push_back(shown);
    if (opacity >= 1.0) open &= ~in;
    if (!open) break;
  }
  const auto key = [&](int s) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < shown_.size(); ++i) bits |= (shown_[i].combinations >> s & 1u) << i;
    return bits;
  };
  std::array<std::uint64_t, Leaf::kMostSides> keys;
  for (int s = 0; s < count; ++s) {
    keys[std::size_t(s)] = key(s);
    int first = 0;
    while (keys[std::size_t(first)] != keys[std::size_t(s)]) ++first;
    leaf_.same[std::size_t(s)] = std::uint8_t(first);
  }
  leaf_.blend = tape.blend;
  return true;
}

/// Asks the paints anew: for a square around `center`, from the leaf's.
void BandPainter::look_at(glm::dvec2 center, double side) {
  look_center_ = leaf_center_ + center, look_side_ = side;
  for (Shown& shown : shown_) shown.mean.reset();
}

/// M over L is M + (1 − a) L, a the opacity of M, and 1 − a of the whole is 1 − a of M times that of L: what
/// is off in a is off by L's colour, and of the opacity by what L lacks.
void BandPainter::lay_under(Look& look, const PaintSampler::Mean& below) {
  const double through = 1.0 - look.mix.a;
  const Mix shown{below.mix.r, below.mix.g, below.mix.b, -below.mix.a};
  const auto carried = [&](const Mix& of_look) { return of_look + of_look.a * shown; };
  // The mean of a product of changes, (1 − a) and L, is off by a twelfth of both.
  const Mix product = look.change.a * below.change / 12.0;
  look.error = carried(look.error) + through * below.error + product;
  look.bent = carried(look.bent) + through * below.bent + 4.0 * product;
  look.change = carried(look.change) + (through + look.change.a) * below.change;
  look.mix = over(look.mix, below.mix);
}

/// The mean colour that a combination of sides shows in that square; nothing if it jumps there.
std::optional<BandPainter::Look> BandPainter::look(int sides) {
  Look look;
  for (Shown& shown : shown_) {
    if (!(shown.combinations >> sides & 1u)) continue;
    if (shown.paint >= 0) {
      if (!shown.mean) shown.mean = paints_->mean(shown.paint, look_center_, look_side_);
      if (!shown.mean) return {};
      look.varied = true;
    }
    lay_under(look, shown.paint < 0 ? PaintSampler::Mean{shown.mix} : *shown.mean);
    if (look.mix.a >= 1.0 && look.change.a <= 0.0) return look;
  }
  lay_under(look, PaintSampler::Mean{plan_->tape.background});
  return look;
}

/// Whether an error in the present square can be seen in its pixel; `least`: how dark it may be there.
bool BandPainter::shows(const Mix& off, const Mix& least) const {
  const Blend blend = plan_->tape.blend;
  const double most = std::max({off.r, off.g, off.b, off.a}) * look_side_;
  if (most * encoding_slope(0.0, blend) <= kAllowed) return false;
  for (int c = 0; c < 3; ++c)
    if (!(off[c] * look_side_ * encoding_slope(least[c], blend) <= kAllowed)) return true;
  return !(off.a * look_side_ <= kAllowed);
}

/// Whether pieces of a square of some looks may be mixed by area alone.
bool BandPainter::mixes(const Mix& change, const Mix& bent, const Mix& least) const {
  return !shows(0.25 * change + bent, least - change);
}

/// The palette of a square for the sides `base` and any of `asked`; false if colours change too much in it.
bool BandPainter::color_varied(glm::dvec2 center, double side, std::uint32_t base,
                               std::uint32_t asked) {
  look_at(center, side);
  Mix change{0.0}, bent{0.0}, least{1.0};
  leaf_.opaque = true;
  for (std::uint32_t sub = asked;; sub = (sub - 1) & asked) {
    const std::size_t s = base | sub, first = leaf_.same[s];
    // Combinations that look the same take the palette of one of them, asked for or not.
    if (s == first || ((first & ~asked) != base)) {
      const auto seen = look(int(s));
      if (!seen) return false;
      for (std::size_t c = 0; c < 4; ++c) leaf_.palette[c][s] = float(255.0 * seen->mix[int(c)]);
      change += seen->change, bent += seen->bent;
      least = glm::min(least, seen->mix);
      leaf_.opaque = leaf_.opaque && seen->mix.a >= 1.0 - 1e-9;
      varied_ = varied_ || seen->varied;
    }
    if (sub == 0) break;
  }
  for (std::uint32_t sub = asked;; sub = (sub - 1) & asked) {
    const std::size_t s = base | sub, first = leaf_.same[s];
    if (s != first && (first & ~asked) == base)
      for (auto& plane : leaf_.palette) plane[s] = plane[first];
    if (sub == 0) break;
  }
  return mixes(change, bent, least);
}

/// The mean colour of a square of a leaf, a pixel or less; nothing where only the sure way knows. `asked`: edges
/// that may cross it, `base`: inside which of the others it lies.
std::optional<Mix> BandPainter::varied_square(glm::dvec2 center, double side, std::uint32_t asked,
                                              std::uint32_t base) {
  const LeafView seen = see_square(leaf_, center, side, plan_->tolerance, asked, base);
  asked = seen.active | seen.with_end, base = seen.base & ~seen.with_end;
  if (!asked) {
    look_at(center, side);
    if (const auto mix = whole(int(base))) return mix;
  } else if (color_varied(center, side, base, asked)) {
    return square(center, side, asked, base) / 255.0;
  }
  constexpr double kLeast = 0.125;  // by then the sure way is as quick
  if (side <= kLeast) return {};
  Mix sum{0.0};
  for (const double y : {-0.25, 0.25})
    for (const double x : {-0.25, 0.25}) {
      const auto part = varied_square(center + side * glm::dvec2{x, y}, 0.5 * side, asked, base);
      if (!part) return {};
      sum += 0.25 * *part;
    }
  return sum;
}

/// What one combination of sides shows in a whole square.
std::optional<Mix> BandPainter::whole(int sides) {
  const auto seen = look(sides);
  if (!seen) return {};
  varied_ = varied_ || seen->varied;
  if (shows(seen->error, seen->mix - seen->change)) return {};
  return seen->mix;
}

/// The mean colour of a part of the leaf, a pixel or less, where its outlines are described and its colours hardly
/// vary; nothing else.
std::optional<Mix> BandPainter::described(std::span<const LeafOutline> outlines,
                                          std::span<const LeafEdge> edges, glm::dvec2 shift,
                                          double side, double most_bend) {
  if (assemble(outlines, edges, shift, side, most_bend))
    return square(shift, side, (1u << leaf_.edge_count) - 1u, 0) / 255.0;
  if (!varies_here_ || !see_layers(shift, side)) return {};
  return varied_square(shift, side, (1u << leaf_.edge_count) - 1u, 0);
}

void BandPainter::put(const Mix& mix, int x, int y) {
  if (plan_->tape.dither && varied_)
    store_dithered(mix, plan_->tape.blend, target_->depth, x, y, at(x, y));
  else
    store(mix, plan_->tape.blend, target_->depth, at(x, y));
}

}  // namespace mien
