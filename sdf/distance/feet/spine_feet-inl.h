// Feet on curves and strokes, many places at a time. Included once per instruction set.
// Which stretches hold a minimum, and why no other does: docs/derivations/feet.md.
#if defined(MIEN_SDF_DISTANCE_SPINE_FEET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_DISTANCE_SPINE_FEET_INL_H_
#undef MIEN_SDF_DISTANCE_SPINE_FEET_INL_H_
#else
#define MIEN_SDF_DISTANCE_SPINE_FEET_INL_H_
#endif

#include "sdf/distance/feet/foot_pieces_private.h"
#include "sdf/distance/feet/reals-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

/// f, its slope and |q|.
struct FootSlope {
  Reals f, rise, r;
};

/// A stretch over which f rises through 0; an end, where both sides of it are the same.
struct RisingStretch {
  Reals lo, hi, f_lo, f_hi;
  Truths is_there;
};

/// Two minima, and how the distance goes beside the ends.
struct TwoMinima {
  Reals t[2];
  Truths is_there[2], at_end[2], rises, falls, doubt;
};

/// What feet are ranked by, and their figures.
struct RankedFeet {
  Reals key, place, piece, t, nx, ny, bend, joint;
};

template <bool kTapers>
HWY_INLINE FootSlope SlopeFrom(const FootPiece& c, Reals qx, Reals qy, Reals gx, Reals gy, Reals gg,
                               Reals w1) {
  const Reals along = qx * gx + qy * gy;
  const Reals rise = gg + All(2.0) * (qx * All(c.b.x) + qy * All(c.b.y));
  if (!kTapers) return {along, rise, along};
  const Reals r = Root(qx * qx + qy * qy);
  return {along - w1 * r, rise - All(2.0 * c.w2) * r - w1 * along / (r + All(1e-290)), r};
}

template <bool kTapers>
HWY_INLINE FootSlope SlopeAtKnot(const FootFrame& f, int i, Reals ox, Reals oy) {
  const FootFrame::Knot& k = f.knots[i];
  return SlopeFrom<kTapers>(f.piece, ox + All(k.x), oy + All(k.y), All(k.gx), All(k.gy), All(k.gg),
                            All(k.widening));
}

template <bool kTapers>
HWY_INLINE FootSlope SlopeAt(const FootPiece& c, Reals ox, Reals oy, Reals t) {
  const Reals bx = All(c.b.x), by = All(c.b.y), ax = All(c.a2.x), ay = All(c.a2.y), twice = t + t;
  const Reals gx = ax + twice * bx, gy = ay + twice * by;
  return SlopeFrom<kTapers>(c, ox + t * (ax + t * bx), oy + t * (ay + t * by), gx, gy,
                            gx * gx + gy * gy, All(c.w1) + twice * All(c.w2));
}

/// Whether more or fewer zeros than the ends tell may lie between two knots.
template <bool kTapers>
HWY_INLINE Truths InDoubt(const FootFrame& f, int i, const FootSlope& a, const FootSlope& b,
                          Truths alike, Truths rests) {
  const FootFrame::Knot& k = f.knots[i];
  const Reals h = All(k.h), f_a = Size(a.f), f_b = Size(b.f), zero = All(0.0);
  if (!kTapers) {
    // f is a cubic without inflection there. Alike at both ends it dips at most once, above its tangents.
    const Reals sign = Choose(rests, All(1.0), All(-1.0)), s_a = sign * a.rise, s_b = sign * b.rise;
    const Truths dips = Both(alike, Both(s_a<zero, s_b> zero));
    if (!Any(dips)) return dips;
    const Truths clears = f_a * s_b - f_b * s_a > -(s_a * s_b) * h;
    return Without(dips, clears);
  }
  const double bends = 2.0 * std::sqrt(f.piece.b.x * f.piece.b.x + f.piece.b.y * f.piece.b.y);
  const double widens = 2.0 * std::abs(f.piece.w2), fast = k.fast, widest = k.widest;
  const Reals r = a.r + b.r, way = All(fast * k.h), half = All(0.5);
  const Reals r_least = half * (r - way), r_most = half * (r + way);
  const Truths up = All(k.slow * k.slow - widest * fast) > r_most * All(bends + widens);
  const Reals of_all = All(3.0 * fast * bends + 2.0 * widens * fast + widest * bends);
  const Reals most = of_all + All(widest * fast * fast) / Most(r_least, All(1e-290));
  const Truths steady = Size(a.rise + b.rise) > most * h;
  const Truths clear = Both(alike, Least(f_a, f_b) > All(0.125) * most * h * h);
  Truths sure = Either(up, Both(r_least > zero, Either(steady, clear)));
  if (k.least > fast) sure = Either(sure, alike);  // the width outruns the spine
  return Without(AllAre(true), sure);
}

/// A search for the zero of a stretch. Each lane stops by itself, so that none depends on its neighbours.
struct ZeroSearch {
  Reals lo, hi, t;
  Truths goes_on;
};

HWY_INLINE ZeroSearch SearchOn(const RisingStretch& on) {
  const Reals share = Most(Least(on.f_lo / (on.f_lo - on.f_hi), All(0.9375)), All(0.0625));
  const Reals t = on.lo + (on.hi - on.lo) * Choose(on.is_there, share, All(0.0));
  return {on.lo, on.hi, t, on.is_there};
}

/// A step of Newton's method, or to the middle where that leaves the stretch.
template <bool kTapers>
HWY_INLINE void StepOn(const FootFrame& f, Reals ox, Reals oy, ZeroSearch& s) {
  // What a step leaves is its square times half of f'' / f', which the width adds |w'| |B'|² / |q| to.
  constexpr double kSettled = 0x1p-52;
  const FootSlope at = SlopeAt<kTapers>(f.piece, ox, oy, s.t);
  const Truths rests = at.f > All(0.0);
  s.lo = Choose(rests, s.lo, s.t), s.hi = Choose(rests, s.t, s.hi);
  const Reals next = s.t - at.f / at.rise;
  const Truths within = Both(AtMost(s.lo, next), AtMost(next, s.hi));
  const Reals now = Choose(within, next, All(0.5) * (s.lo + s.hi)), step = now - s.t;
  const Reals left = step * step * All(f.bends), may = All(kSettled) * at.rise;
  const Truths is_left_little =
      kTapers ? left * at.r + step * step * All(f.kinks) < may * at.r : left < may;
  const Truths moves = Size(step) > All(0.0);
  const Truths settles = Either(Both(within, is_left_little), Without(AllAre(true), moves));
  s.t = Choose(s.goes_on, now, s.t), s.goes_on = Without(s.goes_on, settles);
}

/// One by one where lanes are in doubt.
HWY_NOINLINE void AskScalar(const FootPiece& c, const double* x, const double* y,
                            const double* before_falls, const double* doubt, const double* rises,
                            const double* falls, double* lanes) {
  constexpr size_t kMost = hn::MaxLanes(Doubles());
  for (size_t k = 0; k < hn::Lanes(Doubles()); ++k) {
    if (!(doubt[k] > 0.5)) continue;
    const glm::dvec2 p{x[k], y[k]};
    const FootParameters at =
        foot_parameters(c, p, before_falls[k] > 0.5, {rises[k] > 0.5, falls[k] > 0.5});
    int chosen[2] = {-1, -1};
    double depth[2] = {};
    for (int i = 0; i < at.count; ++i) {
      const double t = at.t[i], key = foot_depth(c, p, t);
      if (chosen[0] < 0 || key < depth[0])
        chosen[1] = chosen[0], depth[1] = depth[0], chosen[0] = i, depth[0] = key;
      else if (chosen[1] < 0 || key < depth[1])
        chosen[1] = i, depth[1] = key;
    }
    for (int i = 0; i < 2; ++i) {
      lanes[i * kMost + k] = chosen[i] < 0 ? 0.0 : at.t[chosen[i]];
      lanes[(2 + i) * kMost + k] = chosen[i] >= 0;
      lanes[(4 + i) * kMost + k] = chosen[i] >= 0 && at.at_end[chosen[i]];
    }
  }
}

/// The minima along one piece.
template <bool kTapers>
HWY_INLINE TwoMinima MinimaOf(const FootFrame& f, Reals x, Reals y, Truths before_falls) {
  const FootPiece& c = f.piece;
  const Reals ox = All(c.p0.x) - x, oy = All(c.p0.y) - y, zero = All(0.0), unit = All(1.0);
  const Truths none = AllAre(false);
  RisingStretch first{zero, zero, zero, zero, none}, second = first;
  Truths doubt = none;
  const auto put = [&](Truths is_there, Reals lo, Reals hi, Reals f_lo, Reals f_hi) HWY_ATTR {
    doubt = Either(doubt, Both(is_there, second.is_there));
    const Truths to_second = Both(is_there, first.is_there);
    const auto set = [&](RisingStretch& s, Truths m) HWY_ATTR {
      s = {Choose(m, lo, s.lo), Choose(m, hi, s.hi), Choose(m, f_lo, s.f_lo),
           Choose(m, f_hi, s.f_hi), Either(s.is_there, m)};
    };
    set(second, to_second), set(first, Without(is_there, first.is_there));
  };
  FootSlope last = SlopeAtKnot<kTapers>(f, 0, ox, oy);
  Truths rests_last = last.f > zero;
  TwoMinima found;
  found.rises = rests_last;
  put(Both(before_falls, rests_last), zero, zero, -unit, unit);
  for (int i = 0; i < f.cells; ++i) {
    const FootSlope now = SlopeAtKnot<kTapers>(f, i + 1, ox, oy);
    const Truths rests = now.f > zero, rises = Without(rests, rests_last);
    const Truths alike = Without(AllAre(true), Either(rises, Without(rests_last, rests)));
    doubt = Either(doubt, InDoubt<kTapers>(f, i, last, now, alike, rests));
    if (Any(rises)) put(rises, All(f.knots[i].t), All(f.knots[i + 1].t), last.f, now.f);
    last = now, rests_last = rests;
  }
  const Truths falls = Without(AllAre(true), rests_last);
  if (c.ends) put(falls, unit, unit, -unit, unit);
  found.at_end[0] = Without(AllAre(true), first.lo < first.hi);
  found.at_end[1] = Without(AllAre(true), second.lo < second.hi);
  constexpr int kSteps = 8;
  ZeroSearch one = SearchOn(first), two = SearchOn(second);
  for (int i = 0; i < kSteps && Any(Either(one.goes_on, two.goes_on)); ++i)
    StepOn<kTapers>(f, ox, oy, one), StepOn<kTapers>(f, ox, oy, two);
  doubt = Either(doubt, Either(one.goes_on, two.goes_on));
  found.t[0] = one.t, found.t[1] = two.t;
  found.is_there[0] = first.is_there, found.is_there[1] = second.is_there;
  found.falls = falls, found.doubt = doubt;
  return found;
}

HWY_INLINE TwoMinima Checked(const FootPiece& c, Reals x, Reals y, Truths before_falls,
                             TwoMinima found) {
  if (HWY_LIKELY(!Any(found.doubt))) return found;
  constexpr size_t kMost = hn::MaxLanes(Doubles());
  HWY_ALIGN double in[6][kMost], lanes[6][kMost];
  StoreReals(x, in[0]), StoreReals(y, in[1]);
  StoreTruths(before_falls, in[2]), StoreTruths(found.doubt, in[3]);
  for (int i = 0; i < 2; ++i) {
    StoreReals(found.t[i], lanes[i]), StoreTruths(found.is_there[i], lanes[2 + i]);
    StoreTruths(found.at_end[i], lanes[4 + i]);
  }
  StoreTruths(found.rises, in[4]), StoreTruths(found.falls, in[5]);
  AskScalar(c, in[0], in[1], in[2], in[3], in[4], in[5], lanes[0]);
  for (int i = 0; i < 2; ++i) {
    found.t[i] = LoadReals(lanes[i]), found.is_there[i] = LoadTruths(lanes[2 + i]);
    found.at_end[i] = LoadTruths(lanes[4 + i]);
  }
  return found;
}

/// foot_figures, in lanes.
struct FiguresOfFeet {
  Reals r, hand, nx, ny, bend;
};
HWY_INLINE FiguresOfFeet FiguresAt(Reals qx, Reals qy, Reals gx, Reals gy, Reals bx, Reals by,
                                   Reals w1, Reals w2) {
  const Reals r = Root(qx * qx + qy * qy), speed = Root(gx * gx + gy * gy);
  const Reals zero = All(0.0), one = All(1.0), tiny = All(1e-300);
  const Reals over = one / Most(speed, tiny), ax = gx * over, ay = gy * over;
  const Reals lean = -w1 * over, rest = Root(Most(zero, (one - lean) * (one + lean)));
  const Reals hand = Choose(qx * ay - qy * ax > zero, -one, one), side = hand * rest;
  const Reals over_r = -(one / Most(r, tiny));
  const Truths far = r > speed * rest;
  Reals nx = Choose(far, qx * over_r, lean * ax + side * ay);
  Reals ny = Choose(far, qy * over_r, lean * ay - side * ax);
  const Truths still = Without(AllAre(true), Either(speed > zero, far));
  nx = Choose(still, one, nx), ny = Choose(still, zero, ny);
  const Reals m = All(2.0) * (nx * bx + ny * by + w2);
  const Reals steep = Most((speed - w1) * (speed + w1) - r * m, tiny);
  const Reals bend = Choose(Either(m<zero, m> zero), -m / steep, zero);
  return {r, hand, nx, ny, bend};
}

HWY_INLINE RankedFeet FeetAt(const FootFrame& f, int index, Reals x, Reals y, Reals t,
                             Truths at_end) {
  const FootPiece& c = f.piece;
  const Reals bx = All(c.b.x), by = All(c.b.y), ax = All(c.a2.x), ay = All(c.a2.y), one = All(1.0);
  const Truths last = Without(AllAre(true), t < one), late = t > All(0.5);
  const Reals qx = Choose(last, All(c.p2.x) - x, (All(c.p0.x) - x) + t * (ax + t * bx));
  const Reals qy = Choose(last, All(c.p2.y) - y, (All(c.p0.y) - y) + t * (ay + t * by));
  const Reals twice = t + t, w1 = All(c.w1) + twice * All(c.w2);
  const FiguresOfFeet in =
      FiguresAt(qx, qy, ax + twice * bx, ay + twice * by, bx, by, w1, All(c.w2));
  const Reals width = Choose(last, All(c.w_end), All(c.w0) + t * (All(c.w1) + t * All(c.w2)));
  const Reals key = in.r - width;
  const Reals place = All(c.start) + t - Choose(late, All(c.wrap), All(0.0));
  RankedFeet found{key, place, All(double(index)), t, in.nx, in.ny, in.bend, All(0.0)};
  if (c.is_joined()) {
    const Reals ex = Choose(late, All(c.p2.x), All(c.p0.x)) - x;
    const Reals ey = Choose(late, All(c.p2.y), All(c.p0.y)) - y, away = Root(ex * ex + ey * ey);
    const Reals end_width = Choose(late, All(c.w_end), All(c.w0));
    found.joint = away - end_width - All(kNoBarrier) * (away + All(f.size));
  }
  if (!Any(at_end)) return found;
  const Reals over = one / in.r;  // infinite at the end itself
  const Truths away = in.r > All(0.0);
  const Reals ex = Choose(away, -qx * over, Choose(late, All(f.out[1].x), All(f.out[0].x)));
  const Reals ey = Choose(away, -qy * over, Choose(late, All(f.out[1].y), All(f.out[0].y)));
  found.nx = Choose(at_end, ex, in.nx), found.ny = Choose(at_end, ey, in.ny);
  found.bend = Choose(at_end, over, in.bend);
  return found;
}

HWY_INLINE RankedFeet ChooseFeet(Truths m, const RankedFeet& yes, const RankedFeet& no) {
  return {Choose(m, yes.key, no.key),     Choose(m, yes.place, no.place),
          Choose(m, yes.piece, no.piece), Choose(m, yes.t, no.t),
          Choose(m, yes.nx, no.nx),       Choose(m, yes.ny, no.ny),
          Choose(m, yes.bend, no.bend),   Choose(m, yes.joint, no.joint)};
}

HWY_INLINE void RankFeet(const RankedFeet& now, Truths is_there, RankedFeet& best,
                         RankedFeet& next) {
  const Truths at_joint = Size(now.t - best.t) > All(0.5);
  const Truths bars = Both(at_joint, Most(now.key, best.key) < now.joint);
  const Truths close = Both(is_there, Size(now.place - best.place) < All(kOneFoot));
  const Truths same = Without(close, bars);
  const Truths lower = Both(is_there, now.key < best.key), pushes = Without(lower, same);
  const Truths second = Without(Both(is_there, now.key < next.key), Either(lower, same));
  next = ChooseFeet(pushes, best, ChooseFeet(second, now, next));
  best = ChooseFeet(lower, now, best);
}

/// Whether the whole piece is farther than `key`.
HWY_INLINE Truths IsFarther(const FootFrame& f, Reals x, Reals y, Reals key) {
  const Reals zero = All(0.0);
  const Reals dx = Most(zero, Most(All(f.box.lo.x) - x, x - All(f.box.hi.x)));
  const Reals dy = Most(zero, Most(All(f.box.lo.y) - y, y - All(f.box.hi.y)));
  return Root(dx * dx + dy * dy) * All(1.0 - 0x1p-40) - All(f.reach) > key;
}

HWY_INLINE Truths FallsAtEnd(const FootFrame& f, Reals x, Reals y) {
  const Reals ox = All(f.piece.p0.x) - x, oy = All(f.piece.p0.y) - y;
  const FootSlope at = f.piece.tapers() ? SlopeAtKnot<true>(f, f.cells, ox, oy)
                                        : SlopeAtKnot<false>(f, f.cells, ox, oy);
  return Without(AllAre(true), at.f > All(0.0));
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
