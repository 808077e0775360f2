// Colours of paints at many places at once: gradients and light. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/tile/lane_paint_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/render/tile/lane_paint.h>
#include <mien/sdf/batch/fma-inl.h>
// After the headers of mien's own: Highway's mathematics is a toggled header too.
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;
using I = hn::RebindToSigned<F>;
using VI = hn::Vec<I>;

HWY_INLINE VF Const(float x) {
  return hn::Set(F(), x);
}

/// x to the power e, for x >= 0; within 2e-6 of it for the exponents and bases that occur, x >= 1e-30.
HWY_INLINE VF Power(VF x, float e) {
  const F f;
  return hn::Exp(f, hn::Mul(hn::Log(f, hn::Max(x, Const(1e-30f))), Const(e)));
}

/// Linear light to encoded values and back (IEC 61966-2-1); 1 is 1.
HWY_INLINE VF Encoded(VF v) {
  const VF curve = FusedLess(Const(1.055f), Power(v, 1.0f / 2.4f), Const(0.055f));
  const VF in = hn::IfThenElse(hn::Le(v, Const(0.0031308f)), hn::Mul(v, Const(12.92f)), curve);
  return hn::IfThenElse(hn::Ge(v, Const(1.0f)), Const(1.0f), in);
}
HWY_INLINE VF Decoded(VF v) {
  const VF x = hn::Mul(hn::Add(v, Const(0.055f)), Const(1.0f / 1.055f));
  return hn::IfThenElse(hn::Le(v, Const(0.04045f)), hn::Mul(v, Const(1.0f / 12.92f)),
                        Power(x, 2.4f));
}

/// Places of a vector: where, in which cell, and from its middle.
struct At {
  VF x, y, u, v;
  VI cell;
};

struct Local {
  VF d, gx, gy;  ///< distance and its gradient
};

HWY_INLINE Local DistanceAt(const LaneDistances& d, const At& at) {
  const F f;
  const VF mean = hn::GatherIndex(f, d.mean.data(), at.cell);
  const VF x = hn::GatherIndex(f, d.x.data(), at.cell);
  const VF y = hn::GatherIndex(f, d.y.data(), at.cell);
  const VF xy = hn::GatherIndex(f, d.xy.data(), at.cell);
  const VF cross = hn::Mul(xy, hn::Mul(at.u, at.v));
  const VF along = hn::Add(hn::Mul(x, at.u), hn::Mul(y, at.v));  // the same for mirrored places
  return {hn::Add(mean, hn::Add(along, cross)), Fused(xy, at.v, x), Fused(xy, at.u, y)};
}

/// The place t along the ramp.
HWY_INLINE VF PlaceAt(const LanePaint& p, const At& at) {
  switch (p.kind) {
    case PaintField::Kind::linear:
      return hn::Add(hn::Add(hn::Mul(Const(p.place_x), at.x), hn::Mul(Const(p.place_y), at.y)),
                     Const(p.shift));
    case PaintField::Kind::radial: {
      const VF x = hn::Sub(at.x, Const(p.cx)), y = hn::Sub(at.y, Const(p.cy));
      const VF a = hn::Add(hn::Mul(Const(p.u00), x), hn::Mul(Const(p.u10), y));
      const VF b = hn::Add(hn::Mul(Const(p.u01), x), hn::Mul(Const(p.u11), y));
      return hn::Sqrt(hn::Add(hn::Mul(a, a), hn::Mul(b, b)));
    }
    default:
      return Fused(DistanceAt(*p.place_distance, at).d, Const(p.place_x), Const(p.shift));
  }
}

/// t brought between the first and the last stop.
HWY_INLINE VF Inner(const LanePaint& p, VF t) {
  if (p.extend == Extend::pad) return t;
  const float first = p.at[0], length = p.at[std::size_t(p.stops - 1)] - first;
  const VF turns = hn::Mul(hn::Sub(t, Const(first)), Const(1.0f / length));
  const VF whole = hn::Floor(turns);
  const VF part = hn::Mul(hn::Sub(turns, whole), Const(length));
  if (p.extend == Extend::repeat) return hn::Add(Const(first), part);
  const VF half = hn::Mul(whole, Const(0.5f));
  const auto back = hn::Ne(hn::Floor(half), half);
  return hn::Add(Const(first), hn::IfThenElse(back, hn::Sub(Const(length), part), part));
}

struct Color {
  VF c[4];
};

HWY_INLINE Color RampAt(const LanePaint& p, VF t) {
  const VF s = Inner(p, t);
  Color color;
  for (std::size_t c = 0; c < 4; ++c) color.c[c] = Const(p.mix[0][c]);
  for (std::size_t i = 1; i < std::size_t(p.stops); ++i) {
    const float length = p.at[i] - p.at[i - 1];
    const auto past = hn::Ge(s, Const(length > 0.0f ? p.at[i - 1] : p.at[i]));
    VF u = Const(1.0f);
    if (length > 0.0f)
      u = hn::Min(hn::Mul(hn::Sub(s, Const(p.at[i - 1])), Const(1.0f / length)), Const(1.0f));
    for (std::size_t c = 0; c < 4; ++c) {
      const VF here = Fused(u, Const(p.mix[i][c] - p.mix[i - 1][c]), Const(p.mix[i - 1][c]));
      color.c[c] = hn::IfThenElse(past, here, color.c[c]);
    }
  }
  return color;
}

/// The profile's rise per pixel (TapeRelief::rise).
HWY_INLINE VF RiseAt(const LanePaint& p, VF inside) {
  const F f;
  const VF x = hn::Mul(hn::Max(inside, hn::Zero(f)), Const(1.0f / p.width));
  VF rise = Const(p.per_pixel);
  if (p.profile == Profile::round) {
    const VF in = hn::Max(x, Const(1e-9f));
    const VF root = hn::Sqrt(hn::Mul(in, hn::Max(hn::Sub(Const(2.0f), in), Const(1e-9f))));
    rise = hn::Div(hn::Mul(rise, hn::Sub(Const(1.0f), in)), root);
  } else if (p.profile == Profile::custom) {
    const I i;
    const VI step = hn::ConvertTo(i, hn::Mul(x, Const(float(p.steps))));
    const VI last = hn::Set(i, p.steps - 1);
    rise = hn::GatherIndex(f, p.rises.data(), hn::Max(hn::Min(step, last), hn::Zero(i)));
  }
  const auto sloping = hn::And(hn::Ge(inside, Const(-0.01f)), hn::Lt(inside, Const(p.width)));
  return hn::IfThenElseZero(sloping, rise);
}

struct Slope {
  VF x, y;  ///< rise per pixel: x right, y DOWN
};

HWY_INLINE Slope SlopeAt(const LanePaint& p, const At& at) {
  const F f;
  Slope slope{hn::Zero(f), hn::Zero(f)};
  if (p.profile != Profile::flat) {
    const Local d = DistanceAt(*p.distance, at);
    const VF falls = hn::Neg(RiseAt(p, hn::Neg(d.d)));
    slope = {hn::Mul(falls, d.gx), hn::Mul(falls, d.gy)};
  }
  for (int i = 0; i < p.dome_count; ++i) {
    const LaneDome& dome = p.domes[std::size_t(i)];
    const VF x = hn::Sub(at.x, Const(dome.x)), y = hn::Sub(at.y, Const(dome.y));
    const VF a = hn::Add(hn::Mul(Const(dome.u00), x), hn::Mul(Const(dome.u10), y));
    const VF b = hn::Add(hn::Mul(Const(dome.u01), x), hn::Mul(Const(dome.u11), y));
    const VF square = hn::Add(hn::Mul(a, a), hn::Mul(b, b));
    const VF in = hn::Max(hn::Sub(Const(1.0f), square), hn::Zero(f));
    const VF by = hn::Mul(Const(-4.0f * dome.height), in);
    const VF ax = hn::Add(hn::Mul(Const(dome.u00), a), hn::Mul(Const(dome.u01), b));
    const VF ay = hn::Add(hn::Mul(Const(dome.u10), a), hn::Mul(Const(dome.u11), b));
    slope.x = Fused(by, ax, slope.x), slope.y = Fused(by, ay, slope.y);
  }
  return slope;
}

/// max(0, n · way), n the surface's normal.
HWY_INLINE VF Facing(const std::array<float, 3>& way, VF sx, VF sy, VF inverse) {
  const VF along = Fused(sx, Const(way[0]), hn::Mul(sy, Const(way[1])));
  return hn::Max(hn::Zero(F()), hn::Mul(hn::Sub(Const(way[2]), along), inverse));
}

/// Lamp::lit.
template <bool kLinear>
HWY_INLINE void Light(const LanePaint& p, const At& at, Color& color) {
  const F f;
  const Slope slope = SlopeAt(p, at);
  const VF sx = slope.x, sy = hn::Neg(slope.y);
  const VF square = Fused(sx, sx, hn::Mul(sy, sy));
  const auto level = hn::Eq(square, hn::Zero(f));
  const VF inverse = hn::Div(Const(1.0f), hn::Sqrt(hn::Add(square, Const(1.0f))));
  const VF diffuse = Fused(Facing(p.to_lamp, sx, sy, inverse),
                           Const((1.0f - p.ambient) / p.to_lamp[2]), Const(p.ambient));
  VF shine = hn::Zero(f);
  if (p.specular > 0.0f) {
    const VF s = Power(Facing(p.halfway, sx, sy, inverse), p.shininess);
    const VF over = hn::Max(hn::Sub(s, Const(p.level_shine)), hn::Zero(f));
    shine = hn::Mul(over, Const(p.specular / (1.0f - p.level_shine)));
  }
  const VF a = color.c[3];
  const VF whole = hn::IfThenElse(hn::Gt(a, hn::Zero(f)), hn::Div(Const(1.0f), a), hn::Zero(f));
  for (std::size_t c = 0; c < 3; ++c) {
    VF light = Const(p.light[c]);
    if (p.stops > 0) {
      light = hn::Mul(color.c[c], whole);
      if (!kLinear) light = Decoded(light);
    }
    VF bright = Fused(light, diffuse, shine);
    bright = hn::Max(hn::Zero(f), hn::Min(bright, Const(1.0f)));
    if (!kLinear) bright = Encoded(bright);
    color.c[c] = hn::IfThenElse(level, color.c[c], hn::Mul(a, bright));
  }
}

template <bool kLinear>
HWY_INLINE Color PaintAt(const LanePaint& p, const At& at) {
  Color color;
  if (p.stops > 0)
    color = RampAt(p, PlaceAt(p, at));
  else
    for (std::size_t c = 0; c < 4; ++c) color.c[c] = Const(p.color[c]);
  if (p.lit) Light<kLinear>(p, at, color);
  return color;
}

template <bool kLinear>
HWY_INLINE void Colors(std::span<const LaneLayer> layers, std::span<const LanePaint> paints,
                       const LanePlaces& places, size_t first, size_t count,
                       std::array<float*, 4> out) {
  const F f;
  const I i;
  HWY_ALIGN float x[hn::MaxLanes(F())] = {}, y[hn::MaxLanes(F())] = {};
  HWY_ALIGN std::int32_t cell[hn::MaxLanes(F())] = {};
  for (size_t k = 0; k < count; ++k)
    x[k] = places.x[first + k], y[k] = places.y[first + k], cell[k] = places.cell[first + k];
  At at{hn::Load(f, x), hn::Load(f, y), {}, {}, hn::Load(i, cell)};
  at.u = hn::Sub(at.x, hn::GatherIndex(f, places.cell_x, at.cell));
  at.v = hn::Sub(at.y, hn::GatherIndex(f, places.cell_y, at.cell));
  Color sum;
  for (VF& c : sum.c) c = hn::Zero(f);
  for (const LaneLayer& layer : layers) {
    const VF through = hn::Sub(Const(1.0f), sum.c[3]);
    Color color;
    if (layer.paint >= 0)
      color = PaintAt<kLinear>(paints[std::size_t(layer.paint)], at);
    else
      for (std::size_t c = 0; c < 4; ++c) color.c[c] = Const(layer.color[c]);
    for (std::size_t c = 0; c < 4; ++c) sum.c[c] = Fused(through, color.c[c], sum.c[c]);
  }
  HWY_ALIGN float lanes[hn::MaxLanes(F())];
  for (std::size_t c = 0; c < 4; ++c) {
    hn::Store(sum.c[c], f, lanes);
    for (size_t k = 0; k < count; ++k) out[c][first + k] = lanes[k];
  }
}

void LaneColors(std::span<const LaneLayer> layers, std::span<const LanePaint> paints, Blend blend,
                const LanePlaces& places, std::array<float*, 4> out) {
  const size_t all = places.x.size(), step = hn::Lanes(F());
  for (size_t first = 0; first < all; first += step) {
    const size_t count = HWY_MIN(step, all - first);
    if (blend == Blend::linear)
      Colors<true>(layers, paints, places, first, count, out);
    else
      Colors<false>(layers, paints, places, first, count, out);
  }
}

void LanePixels(std::array<const float*, 4> mix, Blend blend, const float* carry, size_t count,
                std::uint32_t* pixels) {
  const F f;
  const I i;
  const size_t step = hn::Lanes(f);
  for (size_t first = 0; first < count; first += step) {  // a multiple of 16
    const VF a = hn::LoadU(f, mix[3] + first), add = hn::LoadU(f, carry + first);
    const auto seen = hn::Gt(a, hn::Zero(f));
    const VF whole = hn::IfThenElse(seen, hn::Div(Const(1.0f), a), hn::Zero(f));
    const auto level = [&](VF v) HWY_ATTR {
      const VF held = hn::Max(hn::Zero(f), hn::Min(v, Const(1.0f)));
      return hn::ConvertTo(i, Fused(held, Const(255.0f), add));
    };
    VI pixel = hn::ShiftLeft<24>(level(a));
    for (size_t c = 3; c-- > 0;) {
      VF v = hn::Max(hn::Mul(hn::LoadU(f, mix[c] + first), whole), hn::Zero(f));
      if (blend == Blend::linear) v = Encoded(v);
      const VI l = level(v);
      pixel = hn::Or(pixel, c == 0 ? l : c == 1 ? hn::ShiftLeft<8>(l) : hn::ShiftLeft<16>(l));
    }
    hn::StoreU(hn::BitCast(hn::RebindToUnsigned<F>(), pixel), hn::RebindToUnsigned<F>(),
               pixels + first);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(LaneColors);
HWY_EXPORT(LanePixels);
}  // namespace batch

void lane_colors(std::span<const LaneLayer> layers, std::span<const LanePaint> paints, Blend blend,
                 const LanePlaces& places, std::array<float*, 4> out) {
  HWY_DYNAMIC_DISPATCH(batch::LaneColors)(layers, paints, blend, places, out);
}
void lane_pixels(std::array<const float*, 4> mix, Blend blend, const float* carry,
                 std::size_t count, std::uint32_t* pixels) {
  HWY_DYNAMIC_DISPATCH(batch::LanePixels)(mix, blend, carry, count, pixels);
}

}  // namespace mien
#endif
