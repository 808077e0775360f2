// Light on a relief, many places at a time: the SIMD twin of LitSurface::color for one base colour.
// Included once per instruction set. Error: 2e-5 of full white (tests/render/shade/light/lamp_lanes_test.cpp).
#if defined(MIEN_RENDER_SHADE_LAMP_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_LAMP_LANES_INL_H_
#undef MIEN_RENDER_SHADE_LAMP_LANES_INL_H_
#else
#define MIEN_RENDER_SHADE_LAMP_LANES_INL_H_
#endif

#include "render/blend/transfer-inl.h"
#include "render/shade/light/lamp_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Premultiplied, in the blending space.
struct LitColor {
  VF c[4];
  /// What the law clamps, minus the bound: colours have a kink where one of these is 0. In order: facing the lamp,
  /// the highlight (its power of 2, which varies evenly where the highlight does not), the brightest channel; the
  /// other channels follow where that one is beyond 0.
  VF bounds[3];
  /// How far inside the ramp's colours are; less than 0 beyond its segment, where they are held.
  VF inside;
  /// How far the foot of a dome is that shows [px].
  VF foot;
};

/// A base colour, straight, in linear light, and its opacity; and how far inside of what there is they are.
struct LitBase {
  VF r, g, b, a, inside;
};

/// `away`: the distance that the ramp goes by.
HWY_INLINE LitBase BaseAt(const LampLanes& lamp, VF x, VF y, VF away) {
  const LampRamp& ramp = lamp.ramp;
  if (ramp.kind == LampRamp::Kind::none)
    return {Const(lamp.light[0]), Const(lamp.light[1]), Const(lamp.light[2]), Const(lamp.alpha),
            Const(1.0f)};
  VF t = Fused(x, Const(ramp.xx), Fused(y, Const(ramp.xy), Const(ramp.x)));
  if (ramp.kind == LampRamp::Kind::distance) t = Fused(away, Const(ramp.xx), Const(ramp.x));
  if (ramp.kind == LampRamp::Kind::radial) {
    const VF px = hn::Sub(x, Const(ramp.x)), py = hn::Sub(y, Const(ramp.y));
    const VF u = Fused(px, Const(ramp.xx), hn::Mul(py, Const(ramp.xy)));
    const VF v = Fused(px, Const(ramp.yx), hn::Mul(py, Const(ramp.yy)));
    t = hn::Sqrt(Fused(u, u, hn::Mul(v, v)));
  }
  const VF zero = hn::Zero(F()), one = Const(1.0f);
  const auto channel = [&](size_t c)
                           HWY_ATTR { return Fused(t, Const(ramp.slope[c]), Const(ramp.at[c])); };
  const VF opacity = channel(3), alpha = hn::Min(hn::Max(opacity, zero), one);
  VF inside = hn::Min(opacity, hn::Sub(one, opacity));
  const VF up = hn::Div(one, hn::Max(alpha, Const(1e-5f)));  // less shows nowhere
  const auto light = [&](VF v) HWY_ATTR {
    inside = hn::Min(inside, hn::Min(v, hn::Sub(opacity, v)));
    const VF straight = hn::Min(hn::Max(hn::Mul(up, v), zero), one);
    return lamp.linear ? straight : LightOf(straight);
  };
  const VF r = light(channel(0)), g = light(channel(1)), b = light(channel(2));
  return {r, g, b, alpha, inside};
}

/// The profile's rise per pixel at a depth inside its zone, or not far beyond.
HWY_INLINE VF RiseAt(const LampLanes& lamp, VF depth) {
  if (lamp.rise_kind != LampLanes::Rise::round) return Const(lamp.rise);
  const VF x = hn::Mul(depth, Const(lamp.one_over_width));
  const VF in = hn::Min(hn::Max(x, Const(1e-9f)), Const(1.5f));
  const VF square = hn::Mul(in, hn::Sub(Const(2.0f), in));  // 1 − (1 − x)²
  return hn::Div(hn::Mul(Const(lamp.rise), hn::Sub(Const(1.0f), in)), hn::Sqrt(square));
}

/// n · way for the surface's normal n = (−slope, 1) · inverse.
HWY_INLINE VF Towards(const std::array<float, 3>& way, VF sx, VF sy, VF inverse) {
  const VF along = Fused(sx, Const(way[0]), hn::Mul(sy, Const(way[1])));
  return hn::Mul(hn::Sub(Const(way[2]), along), inverse);
}

/// (nx, ny) the outward normal, (x, y) from the tile's middle.
HWY_INLINE LitColor LitAt(const LampLanes& lamp, VF depth, VF nx, VF ny, VF x, VF y, VF away) {
  const F f;
  const VF zero = hn::Zero(f);
  VF sx = zero, sy = zero, foot = Const(1e9f);
  if (lamp.rise_kind != LampLanes::Rise::none) {
    const VF falls = hn::Neg(RiseAt(lamp, depth));
    sx = hn::Mul(falls, nx), sy = hn::Mul(falls, ny);
  }
  for (const LampDome& dome : lamp.domes) {
    const VF px = hn::Sub(x, Const(dome.x)), py = hn::Sub(y, Const(dome.y));
    const VF u = Fused(px, Const(dome.xx), hn::Mul(py, Const(dome.xy)));
    const VF v = Fused(px, Const(dome.yx), hn::Mul(py, Const(dome.yy)));
    const VF left = FusedFrom(u, u, FusedFrom(v, v, Const(1.0f))), in = hn::Max(left, zero);
    if (dome.foot > 0.0f) foot = hn::Min(foot, hn::Mul(hn::Abs(left), Const(dome.foot)));
    const VF by = hn::Mul(in, Const(dome.height));
    sx = Fused(by, Fused(u, Const(dome.xx), hn::Mul(v, Const(dome.yx))), sx);
    sy = Fused(by, Fused(u, Const(dome.xy), hn::Mul(v, Const(dome.yy))), sy);
  }
  const VF inverse = hn::Div(Const(1.0f), hn::Sqrt(Fused(sx, sx, Fused(sy, sy, Const(1.0f)))));
  const VF lit = Towards(lamp.to_lamp, sx, sy, inverse), facing = hn::Max(lit, zero);
  const VF diffuse = Fused(facing, Const(lamp.diffuse), Const(lamp.ambient));
  VF shine = zero, over = Const(-1e9f);
  if (lamp.shine > 0.0f) {
    const VF half = hn::Max(Towards(lamp.halfway, sx, sy, inverse), Const(1e-12f));
    const VF power = hn::Max(hn::Mul(Const(lamp.shininess), Log2(half)), Const(-126.0f));
    over = hn::Sub(power, Const(lamp.level_power));
    const VF more = hn::Sub(Exp2(power), Const(lamp.level_shine));
    shine = hn::Mul(hn::Max(more, zero), Const(lamp.shine));
  }
  const LitBase base = BaseAt(lamp, x, y, away);
  const auto channel = [&](VF light) HWY_ATTR {
    const VF bright = Fused(light, diffuse, shine);
    const VF held = hn::Min(hn::Max(bright, zero), Const(1.0f));
    return hn::Mul(base.a, lamp.linear ? held : EncodedLight(held));
  };
  LitColor color;
  color.bounds[0] = lit, color.bounds[1] = over;
  const VF brightest = hn::Max(base.r, hn::Max(base.g, base.b));
  color.bounds[2] = hn::Sub(Fused(brightest, diffuse, shine), Const(1.0f));
  color.c[0] = channel(base.r), color.c[1] = channel(base.g), color.c[2] = channel(base.b);
  color.c[3] = base.a, color.foot = foot, color.inside = base.inside;
  return color;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
