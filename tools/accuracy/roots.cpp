#include "tools/accuracy/roots.h"

namespace mien::accuracy {
namespace {

Polynomial derived(const Polynomial& p) {
  Polynomial d;
  for (size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * Quad(double(i)));
  return d;
}

/// The root between lo and hi, where p has opposite signs and is monotone.
Quad root_between(const Polynomial& p, const Polynomial& slope, Quad lo, Quad hi) {
  const bool rises = value(p, lo) < 0;
  Quad x = (lo + hi) / 2;
  for (int i = 0; i < 500; ++i) {
    const Quad v = value(p, x);
    if (v == 0) return x;
    ((v < 0) == rises ? lo : hi) = x;
    const Quad s = value(slope, x);
    Quad next = s != 0 ? x - v / s : lo;
    const bool inside = next > lo && next < hi;
    if (!inside || i % 8 == 7)
      next = (lo + hi) / 2;  // every eighth step halves, whatever Newton does
    const Quad step = magnitude(next - x);
    x = next;
    if (step <= Quad(0x1p-110L) * magnitude(x) || hi - lo <= Quad(0x1p-250L)) return x;
  }
  return x;
}

}  // namespace

Quad value(const Polynomial& p, Quad x) {
  Quad v = 0;
  for (size_t i = p.size(); i-- > 0;) v = v * x + p[i];
  return v;
}

std::vector<Quad> sign_changes(const Polynomial& p, Quad lo, Quad hi) {
  if (p.size() < 2) return {};
  const Polynomial slope = derived(p);
  std::vector<Quad> borders = sign_changes(slope, lo, hi), found;
  borders.insert(borders.begin(), lo);
  borders.push_back(hi);
  for (size_t i = 0; i + 1 < borders.size(); ++i) {
    const Quad a = borders[i], b = borders[i + 1], fa = value(p, a), fb = value(p, b);
    if (fa == 0) found.push_back(a);
    if (fa != 0 && fb != 0 && (fa < 0) != (fb < 0)) found.push_back(root_between(p, slope, a, b));
  }
  if (value(p, hi) == 0) found.push_back(hi);
  return found;
}

}  // namespace mien::accuracy
