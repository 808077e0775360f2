#pragma once
// Parabolas within a pixel as chords.

#include "render/cover/part_form.h"

#include <algorithm>
#include <cmath>

namespace mien {

/// As fine as leaves less than 2e-4 px² between a stretch and its chords, and less than 1e-3 px².
inline constexpr float kFineChords = 3300.0f, kCoarseChords = 700.0f;

/// As many chords as it takes: with a bulge b in the middle, k chords leave 2/3 b / k².
template <class Add>
void for_each_chord(const PartStretch& s, float fine, const Add& add) {
  constexpr int kMostChords = 24;  // leave 2e-4 px² for bulges up to 0.17 px
  const float bulge = std::abs(s.xm - 0.5f * (s.xp + s.xq)) + std::abs(s.ym - 0.5f * (s.yp + s.yq));
  const int chords = std::clamp(int(std::ceil(std::sqrt(fine * bulge))), 1, kMostChords);
  float x = s.xp, y = s.yp;
  for (int i = 1; i < chords; ++i) {
    const float t = float(i) / float(chords), p = (1.0f - t) * (1.0f - 2.0f * t),
                m = 4.0f * t * (1.0f - t), q = t * (2.0f * t - 1.0f);
    const float to_x = std::clamp(p * s.xp + m * s.xm + q * s.xq, 0.0f, 1.0f);
    const float to_y = std::clamp(p * s.yp + m * s.ym + q * s.yq, y, s.yq);
    add(PartChord{x, y, to_x, to_y, s.sign});
    x = to_x, y = to_y;
  }
  add(PartChord{x, y, s.xq, s.yq, s.sign});
}

}  // namespace mien
