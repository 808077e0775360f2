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
