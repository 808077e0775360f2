#include "sdf/outline/outlines.h"

#include <algorithm>

namespace mien {

void Outlines::add(const Outlines& other, int first, int end) {
  if (first >= end) return;
  const Start from = other.starts[std::size_t(first)], until = other.end_of(end - 1);
  const int outline = int(rules.size()) - first, chain = int(chains.size()) - from.chain,
            turn = int(turns.size()) - from.turn;
  if (from.chain < until.chain) {
    const int begin = other.chains[std::size_t(from.chain)].first,
              last = other.chains[std::size_t(until.chain) - 1].last,
              piece = int(pieces.size()) - begin;
    pieces.insert(pieces.end(), other.pieces.begin() + begin, other.pieces.begin() + last + 1);
    for (int i = from.chain; i < until.chain; ++i) {
      const OutlineChain& c = other.chains[std::size_t(i)];
      chains.push_back({c.first + piece, c.last + piece, c.outline + outline, c.turn});
    }
  }
  for (int i = from.turn; i < until.turn; ++i) {
    const OutlineEnd& e = other.turns[std::size_t(i)];
    turns.push_back({e.y, e.x, e.chain + chain, e.other < 0 ? -1 : e.other + chain, e.begins});
  }
  for (int i = first; i < end; ++i) {
    rules.push_back(other.rules[std::size_t(i)]);
    starts.push_back(
        {other.starts[std::size_t(i)].chain + chain, other.starts[std::size_t(i)].turn + turn});
  }
}

void Outlines::finish() {
  ends = turns;
  std::sort(ends.begin(), ends.end(), [](const OutlineEnd& a, const OutlineEnd& b) {
    return a.y != b.y ? a.y < b.y : a.x != b.x ? a.x < b.x : a.chain < b.chain;
  });
}

std::pair<double, double> Outlines::heights(int outline) const {
  double top = HUGE_VAL, bottom = -HUGE_VAL;
  for (int i = starts[std::size_t(outline)].chain; i < end_of(outline).chain; ++i) {
    const OutlineChain& c = chains[std::size_t(i)];
    top = std::min(top, pieces[std::size_t(c.first)].y0);
    bottom = std::max(bottom, pieces[std::size_t(c.last)].y1);
  }
  return {top, bottom};
}

}  // namespace mien
