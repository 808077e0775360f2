// From mixed colours to the bytes of pixels. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/rows/pixel_format_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/blend/transfer-inl.h"
#include "render/rows/pixel_format.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using U = hn::RebindToUnsigned<F>;
using VU = hn::Vec<U>;

HWY_INLINE VF Held(VF v) {
  return hn::Min(hn::Max(v, hn::Zero(F())), Const(1.0f));
}

/// Straight colours, opaque where only a sum's roundings say otherwise.
struct Straight {
  VF r, g, b, a;
};
HWY_INLINE Straight StraightOf(const ColorPlanes& from, size_t i) {
  const F f;
  const VF a = hn::LoadU(f, from.a + i), one = Const(1.0f);
  const auto opaque = hn::Ge(a, Const(1.0f - 0x1p-20f)), seen = hn::Gt(a, Const(0x1p-20f));
  const VF up = hn::IfThenElse(opaque, one,
                               hn::IfThenElseZero(seen, hn::Div(one, hn::Max(a, Const(0x1p-20f)))));
  const auto channel = [&](const float* c)
                           HWY_ATTR { return Held(hn::Mul(up, hn::LoadU(f, c + i))); };
  return {channel(from.r), channel(from.g), channel(from.b), hn::IfThenElse(opaque, one, Held(a))};
}

HWY_INLINE VU LevelOf(VF v, float top, VF carry) {
  const hn::RebindToSigned<F> i;
  return hn::BitCast(U(), hn::ConvertTo(i, hn::Add(hn::Mul(v, Const(top)), carry)));
}

/// The pixels from the i-th on, as many as there are lanes.
HWY_INLINE void PutLanes(const PixelWork& work, size_t i, std::uint32_t* to) {
  const F f;
  const U u;
  Straight c = StraightOf(work.from, i);
  const bool linear = work.blend == Blend::linear;
  if (work.depth == Depth::f32) {
    if (!linear) c.r = LightOf(c.r), c.g = LightOf(c.g), c.b = LightOf(c.b);
    float* const light = reinterpret_cast<float*>(to);
    hn::StoreInterleaved4(hn::Mul(c.a, c.r), hn::Mul(c.a, c.g), hn::Mul(c.a, c.b), c.a, f, light);
    return;
  }
  if (linear) c.r = EncodedLight(c.r), c.g = EncodedLight(c.g), c.b = EncodedLight(c.b);
  const VF carry = hn::LoadU(f, work.carry + i);
  const float top = work.depth == Depth::u8 ? 255.0f : 65535.0f;
  const VU r = LevelOf(Held(c.r), top, carry), g = LevelOf(Held(c.g), top, carry),
           b = LevelOf(Held(c.b), top, carry), a = LevelOf(c.a, top, carry);
  if (work.depth == Depth::u8) {
    hn::StoreU(
        hn::Or(hn::Or(r, hn::ShiftLeft<8>(g)), hn::Or(hn::ShiftLeft<16>(b), hn::ShiftLeft<24>(a))),
        u, to);
  } else {
    hn::StoreInterleaved2(hn::Or(r, hn::ShiftLeft<16>(g)), hn::Or(b, hn::ShiftLeft<16>(a)), u, to);
  }
}

void PutPixels(const PixelWork& work) {
  const size_t lanes = hn::Lanes(F()), all = size_t(work.count);
  const size_t bytes = 4 * bytes_per_channel(work.depth);
  HWY_ALIGN std::uint32_t made[4 * hn::MaxLanes(F())];
  for (size_t i = 0; i < all; i += lanes) {
    PutLanes(work, i, made);
    const size_t count = HWY_MIN(lanes, all - i);
    std::memcpy(work.to + bytes * i, made, bytes * count);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(PutPixels);
}  // namespace batch

void put_pixels(const PixelWork& work) {
  MIEN_DISPATCH(PutPixels)(work);
}

}  // namespace mien
#endif
