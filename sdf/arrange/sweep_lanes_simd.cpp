// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/arrange/sweep_lanes_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "sdf/arrange/piece_place.h"
#include "sdf/arrange/sweep_lanes.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Products and sums by themselves: the same bits with and without fused ones, and as in piece_place.h.
void Place(SweepLanes& s, double from, double to) {
  const hn::CappedTag<double, 8> d;
  const auto y = hn::Set(d, to), zero = hn::Zero(d), one = hn::Set(d, 1.0),
             half = hn::Set(d, 0.5 / (to - from));
  for (size_t i = 0; i < s.count; i += hn::Lanes(d)) {
    const auto at = [&](const std::vector<double>& of) HWY_ATTR { return hn::LoadU(d, &of[i]); };
    const auto down = hn::Sub(y, at(s.y0)), ay = at(s.ay), ax = at(s.ax), x = at(s.x);
    const auto root = hn::Sqrt(hn::Max(zero, hn::Add(hn::Mul(ay, ay), hn::Mul(at(s.by), down))));
    const auto divisor = hn::Add(ay, root);
    const auto share = hn::IfThenElseZero(hn::Gt(divisor, zero), hn::Div(down, divisor));
    const auto t = hn::Min(hn::Max(zero, share), one);
    const auto next = hn::Add(at(s.x0), hn::Mul(t, hn::Add(hn::Add(ax, ax), hn::Mul(t, at(s.bx)))));
    const auto h = hn::Sub(t, at(s.t));
    const auto sag = hn::Mul(hn::Mul(at(s.turning), half), hn::Mul(h, hn::Mul(h, h)));
    hn::StoreU(next, d, &s.next_x[i]);
    hn::StoreU(t, d, &s.next_t[i]);
    hn::StoreU(hn::Min(x, next), d, &s.low[i]);
    hn::StoreU(hn::Max(x, next), d, &s.high[i]);
    hn::StoreU(hn::Max(sag, zero), d, &s.sag_right[i]);
    hn::StoreU(hn::Max(hn::Neg(sag), zero), d, &s.sag_left[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(Place);
}  // namespace batch

void SweepLanes::room_for(std::size_t lanes) {
  if (lanes + kSpare <= x.size()) return;
  for (std::vector<double>* v : {&x0, &y0, &ax, &ay, &bx, &by, &bottom, &turning, &x, &t, &next_x,
                                 &next_t, &low, &high, &sag_left, &sag_right})
    v->resize(2 * lanes + 64, 0.0);
}

void SweepLanes::load(std::size_t i, const OutlinePiece& p) {
  x0[i] = p.x0, y0[i] = p.y0, ax[i] = p.ax, ay[i] = p.ay, bx[i] = p.bx, by[i] = p.by;
  bottom[i] = p.y1, turning[i] = mien::turning(p);
}

void place(SweepLanes& lanes, double from, double to) {
  MIEN_DISPATCH(Place)(lanes, from, to);
}

}  // namespace mien
#endif
