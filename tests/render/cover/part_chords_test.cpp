#include "render/cover/part_chords.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

/// What lies between a parabola and its chords, to their right.
TEST(PartChords, LeaveWhatTheySay) {
  for (const float fine : {kFineChords, kCoarseChords})
    for (const float bulge : {0.0f, 0.002f, 0.02f, 0.1f, 0.17f}) {
      const PartStretch s{0.3f, 0.0f, 0.3f + bulge, 0.5f, 0.3f, 1.0f, 1.0f};
      double left = 0.0, y = 0.0;
      for_each_chord(s, fine, [&](const PartChord& c) {
        EXPECT_FLOAT_EQ(c.yp, float(y));
        left += 0.5 * double(c.xp + c.xq) * double(c.yq - c.yp), y = double(c.yq);
      });
      EXPECT_FLOAT_EQ(float(y), 1.0f);
      EXPECT_NEAR(left, 0.3 + 2.0 / 3.0 * double(bulge), fine == kFineChords ? 2.1e-4 : 1e-3)
          << bulge;
    }
}

}  // namespace
}  // namespace mien
