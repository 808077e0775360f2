// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/cover/row_roots_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <mien/render/cover/row_roots.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Trapezoid and lens, as in cells.h.
HWY_INLINE void Areas(const OutlinePiece& p, const RowRange& range, RowRoots& to) {
  const hn::CappedTag<double, RowRoots::kSpare> d;
  const hn::Rebind<float, decltype(d)> f;
  const auto lens = hn::Set(d, (p.ax * p.by - p.ay * p.bx) / 3.0), zero = hn::Zero(d),
             half = hn::Set(d, 0.5), one = hn::Set(d, 1.0), least = hn::Set(d, range.top),
             most = hn::Set(d, range.bottom);
  for (int k = 0; k < range.rows; k += int(hn::Lanes(d))) {
    const size_t at = size_t(k);
    const auto border = hn::Iota(d, double(range.first_row + k));
    const auto dy = hn::Sub(hn::Min(hn::Add(border, one), most), hn::Max(border, least));
    const auto x = hn::LoadU(d, &to.x[at]), next_x = hn::LoadU(d, &to.x[at + 1]);
    const auto h = hn::Sub(hn::LoadU(d, &to.t[at + 1]), hn::LoadU(d, &to.t[at]));
    const auto column = hn::Floor(x);
    const auto right = hn::Sub(hn::Add(column, one), hn::Mul(half, hn::Add(x, next_x)));
    const auto bow = hn::Mul(hn::Mul(hn::Mul(lens, h), h), h);
    const auto area = hn::IfThenElse(hn::Lt(column, zero), dy, hn::Sub(hn::Mul(right, dy), bow));
    const auto area_f = hn::DemoteTo(f, area);
    hn::StoreU(area_f, f, &to.area[at]);
    hn::StoreU(hn::Sub(hn::DemoteTo(f, dy), area_f), f, &to.rest[at]);
  }
}

/// Products and sums by themselves: the same bits with and without fused ones.
void Roots(const OutlinePiece& p, const RowRange& range, RowRoots& to) {
  const hn::CappedTag<double, RowRoots::kSpare> d;
  const hn::Rebind<int, decltype(d)> i;
  const auto zero = hn::Zero(d), ay = hn::Set(d, p.ay), ay2 = hn::Set(d, p.ay * p.ay),
             by = hn::Set(d, p.by), y0 = hn::Set(d, p.y0), x0 = hn::Set(d, p.x0),
             ax2 = hn::Set(d, 2.0 * p.ax), bx = hn::Set(d, p.bx), least = hn::Set(d, range.top),
             most = hn::Set(d, range.bottom), width = hn::Set(d, double(range.width));
  for (int k = 0; k <= range.rows; k += int(hn::Lanes(d))) {
    const auto border = hn::Iota(d, double(range.first_row + k));
    const auto down = hn::Sub(hn::Min(hn::Max(border, least), most), y0);
    const auto root = hn::Sqrt(hn::Max(hn::Add(ay2, hn::Mul(by, down)), zero));
    const auto divisor = hn::Add(ay, root);
    const auto some = hn::Gt(divisor, zero);
    const auto t = hn::IfThenElseZero(some, hn::Div(down, hn::IfThenElse(some, divisor, ay2)));
    hn::StoreU(t, d, &to.t[size_t(k)]);
    const auto x = hn::Add(x0, hn::Mul(t, hn::Add(ax2, hn::Mul(t, bx))));
    hn::StoreU(x, d, &to.x[size_t(k)]);
    const auto column = hn::Floor(hn::Min(hn::Max(x, hn::Set(d, -1.0)), width));
    hn::StoreU(hn::DemoteTo(i, column), i, &to.column[size_t(k)]);
  }
  Areas(p, range, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(Roots);
}  // namespace batch

void row_roots(const OutlinePiece& piece, const RowRange& range, RowRoots& to) {
  HWY_DYNAMIC_DISPATCH(batch::Roots)(piece, range, to);
}

}  // namespace mien
#endif
