// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cover/row_roots_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/cover/row_roots.h"
#include "sdf/distance/lanes/dispatch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

HWY_INLINE V ColumnAt(V x, double width) {
  return hn::Floor(hn::Min(hn::Max(x, hn::Set(D(), -1.0)), hn::Set(D(), width)));
}

/// Where a piece is at some heights.
struct Places {
  V y, t, x, column;
};

struct Piece {
  explicit Piece(const OutlinePiece& p)
      : x0(hn::Set(D(), p.x0)),
        y0(hn::Set(D(), p.y0)),
        ax(hn::Set(D(), p.ax)),
        ay(hn::Set(D(), p.ay)),
        bx(hn::Set(D(), p.bx)),
        by(hn::Set(D(), p.by)),
        lens(hn::Set(D(), (p.ax * p.by - p.ay * p.bx) / 3.0)) {}

  HWY_INLINE Places At(V y, double width) const {
    const D d;
    const V down = hn::Sub(y, y0);
    const V root = hn::Sqrt(hn::Max(hn::Add(hn::Mul(ay, ay), hn::Mul(by, down)), hn::Zero(d)));
    const V divisor = hn::Add(ay, root);
    const auto some = hn::Gt(divisor, hn::Zero(d));
    const V t = hn::IfThenElseZero(some, hn::Div(down, hn::IfThenElse(some, divisor, ay)));
    const V x = hn::Add(x0, hn::Mul(t, hn::Add(hn::Add(ax, ax), hn::Mul(t, bx))));
    return {y, t, x, ColumnAt(x, width)};
  }

  /// Between two heights: where the piece meets the one border of columns that lies there, or its end.
  HWY_INLINE Places Between(const Places& a, const Places& b) const {
    const D d;
    const V border = hn::Max(a.column, b.column), way = hn::Sub(border, x0);
    const V root = hn::Sqrt(hn::Max(hn::Add(hn::Mul(ax, ax), hn::Mul(bx, way)), hn::Zero(d)));
    const V divisor = hn::Add(ax, hn::IfThenElse(hn::Gt(b.column, a.column), root, hn::Neg(root)));
    const auto none = hn::Eq(divisor, hn::Zero(d)), stays = hn::Eq(a.column, b.column);
    const V there = hn::IfThenElse(none, a.t, hn::Div(way, hn::IfThenElse(none, root, divisor)));
    const V t = hn::IfThenElse(stays, b.t, hn::Min(hn::Max(there, a.t), b.t));
    const V y = hn::Add(y0, hn::Mul(t, hn::Add(hn::Add(ay, ay), hn::Mul(t, by))));
    return {hn::IfThenElse(stays, b.y, hn::Min(hn::Max(y, a.y), b.y)), t,
            hn::IfThenElse(stays, b.x, border), border};
  }

  /// Trapezoid and lens, as in cells.h; from the row `i` on, whose top is `row`.
  HWY_INLINE void PutCell(V column, V row, const Places& p, const Places& q, size_t i,
                          bool stretches, RowRoots::Cells& to) const {
    const D d;
    const hn::Rebind<float, D> f;
    const V one = hn::Set(d, 1.0), half = hn::Set(d, 0.5), h = hn::Sub(q.t, p.t),
            dy = hn::Sub(q.y, p.y);
    const V right = hn::Sub(hn::Add(column, one), hn::Mul(half, hn::Add(p.x, q.x)));
    const V bow = hn::Mul(hn::Mul(hn::Mul(lens, h), h), h);
    const auto before = hn::Lt(column, hn::Zero(d));  // left of the picture
    const V all = hn::IfThenElse(before, dy, hn::Sub(hn::Mul(right, dy), bow));
    hn::StoreU(hn::DemoteTo(f, all), f, &to.area[i]);
    hn::StoreU(hn::DemoteTo(f, dy), f, &to.height[i]);
    if (!stretches) return;
    const auto put = [&](V v, float* into) HWY_ATTR {
      const auto held = hn::Min(hn::Max(hn::DemoteTo(f, v), hn::Zero(f)), hn::Set(f, 1.0f));
      hn::StoreU(held, f, into);
    };
    const V bulge = hn::Mul(hn::Mul(hn::Set(d, 0.25), h), h);
    const auto put_places = [&](V x, V y, float* xs, float* ys) HWY_ATTR {
      put(hn::IfThenZeroElse(before, hn::Sub(x, column)), xs), put(hn::Sub(y, row), ys);
    };
    put_places(p.x, p.y, &to.xp[i], &to.yp[i]), put_places(q.x, q.y, &to.xq[i], &to.yq[i]);
    put_places(hn::Sub(hn::Mul(half, hn::Add(p.x, q.x)), hn::Mul(bulge, bx)),
               hn::Sub(hn::Mul(half, hn::Add(p.y, q.y)), hn::Mul(bulge, by)), &to.xm[i], &to.ym[i]);
  }

  V x0, y0, ax, ay, bx, by, lens;
};

/// Products and sums by themselves: the same bits with and without fused ones.
void Roots(const OutlinePiece& p, const RowRange& range, RowRoots& to, bool stretches) {
  const D d;
  const hn::Rebind<int, D> n;
  const Piece piece(p);
  const V least = hn::Set(d, range.top), most = hn::Set(d, range.bottom);
  const int lanes = int(hn::Lanes(d));
  for (int k = 0; k <= range.rows; k += lanes) {
    const size_t i = size_t(k);
    const V border = hn::Iota(d, double(range.first_row + k));
    const Places at = piece.At(hn::Min(hn::Max(border, least), most), range.width);
    hn::StoreU(at.t, d, &to.t[i]);
    hn::StoreU(at.x, d, &to.x[i]);
    hn::StoreU(hn::DemoteTo(n, at.column), n, &to.column[i]);
  }
  for (int k = 0; k < range.rows; k += lanes) {
    const size_t i = size_t(k);
    const V border = hn::Iota(d, double(range.first_row + k));
    const V x = hn::LoadU(d, &to.x[i]), next_x = hn::LoadU(d, &to.x[i + 1]);
    const Places a{hn::Max(border, least), hn::LoadU(d, &to.t[i]), x, ColumnAt(x, range.width)};
    const Places b{hn::Min(hn::Add(border, hn::Set(d, 1.0)), most), hn::LoadU(d, &to.t[i + 1]),
                   next_x, ColumnAt(next_x, range.width)};
    const bool stays = hn::AllTrue(d, hn::Eq(a.column, b.column));
    const Places m = stays ? b : piece.Between(a, b);
    piece.PutCell(a.column, border, a, m, i, stretches, to.first);
    if (!stays) piece.PutCell(b.column, border, m, b, i, stretches, to.second);
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

void row_roots(const OutlinePiece& piece, const RowRange& range, RowRoots& to, bool stretches) {
  MIEN_DISPATCH(Roots)(piece, range, to, stretches);
}

}  // namespace mien
#endif
