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

  /// Trapezoid and lens, as in cells.h.
  HWY_INLINE void PutCell(V column, const Places& p, const Places& q, float* area,
                          float* rest) const {
    const D d;
    const hn::Rebind<float, D> f;
    const V one = hn::Set(d, 1.0), half = hn::Set(d, 0.5), h = hn::Sub(q.t, p.t),
            dy = hn::Sub(q.y, p.y);
    const V right = hn::Sub(hn::Add(column, one), hn::Mul(half, hn::Add(p.x, q.x)));
    const V bow = hn::Mul(hn::Mul(hn::Mul(lens, h), h), h);
    const V all = hn::IfThenElse(hn::Lt(column, hn::Zero(d)), dy, hn::Sub(hn::Mul(right, dy), bow));
    const auto part = hn::DemoteTo(f, all);
    hn::StoreU(part, f, area);
    hn::StoreU(hn::Sub(hn::DemoteTo(f, dy), part), f, rest);
  }

  V x0, y0, ax, ay, bx, by, lens;
};

/// Products and sums by themselves: the same bits with and without fused ones.
void Roots(const OutlinePiece& p, const RowRange& range, RowRoots& to) {
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
    piece.PutCell(a.column, a, m, &to.area[i], &to.rest[i]);
    if (!stays) piece.PutCell(b.column, m, b, &to.next_area[i], &to.next_rest[i]);
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
  MIEN_DISPATCH(Roots)(piece, range, to);
}

}  // namespace mien
#endif
