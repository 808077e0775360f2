#include "render/rows/row_fingerprints.h"
#include "lib/base/fingerprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien {

void RowFingerprints::begin(std::uint64_t seed, const Scene& scene, const PaintTable& paints,
                            int rows) {
  seed_ = seed;
  layers_.make(scene, seed);
  paints_.assign(paints.varied.size(), 0);
  for (std::size_t i = 0; i < paints.layers.size(); ++i)
    if (const int varied = paints.layers[i].varied; varied >= 0)
      paints_[std::size_t(varied)] = layers_.of_layer(i);
  rows_.assign(std::size_t(rows), kNone);
}

void RowFingerprints::add(const Looks& looks, int first_look, const Sweep& sweep, int top,
                          int bottom) {
  // Rows know looks by 16 bits (RowSums::hints).
  if (looks.count() > std::numeric_limits<std::uint16_t>::max()) return;
  look_at_looks(looks);
  Fingerprint empty(seed_);
  empty.add(looks_[std::size_t(first_look)]);
  std::fill(rows_.begin() + top, rows_.begin() + bottom, empty.value());
  for (const Fragment& f : sweep.fragments()) add(f, sweep.piece(f.piece));
  for (const Doubt& d : sweep.doubts()) doubt(d);
}

void RowFingerprints::look_at_looks(const Looks& looks) {
  looks_.clear();
  for (int i = 0; i < looks.count(); ++i) {
    Fingerprint look(seed_);
    for (const LookStep& step : looks.steps(i)) {
      look.add(int(step.kind)), look.add(step.segment), look.add(step.zone);
      look.add(int(step.mode));
      if (step.varied >= 0) look.add(paints_[std::size_t(step.varied)]);
      for (int k = 0; k < 4; ++k) look.add(step.mix[k] + 0.0);  // −0 is 0, as for Looks
    }
    looks_.push_back(look.value());
  }
}

/// To the rows that it crosses: where it begins and ends counts in the first and the last of them.
void RowFingerprints::add(const Fragment& f, const OutlinePiece& p) {
  Fingerprint whole;
  for (const double v : {p.x0, p.y0, p.ax, p.ay, p.bx, p.by, p.x1, p.y1}) whole.add(v);
  whole.add(looks_[std::size_t(f.left)]), whole.add(looks_[std::size_t(f.right)]);
  const int first = std::max(int(f.top), 0),
            last = std::min(std::max(int(std::ceil(f.bottom)) - 1, first), int(rows_.size()) - 1);
  for (int y = first; y <= last; ++y) {
    Fingerprint row(rows_[std::size_t(y)]);
    const bool begins = f.top > y, ends = f.bottom < y + 1;
    row.add(whole.value() + 2 * begins + ends);
    if (begins) row.add(f.top);
    if (ends) row.add(f.bottom);
    rows_[std::size_t(y)] = row.value();
  }
}

void RowFingerprints::doubt(const Doubt& d) {
  const int first = std::clamp(int(std::floor(d.top)), 0, int(rows_.size())),
            end = std::clamp(int(std::ceil(d.bottom)), first, int(rows_.size()));
  std::fill(rows_.begin() + first, rows_.begin() + end, kNone);
}

}  // namespace mien
