#pragma once
// Faults planted in a sweep.

#include "sdf/arrange/sweep.h"

namespace mien {

class SweepProbe {
 public:
  /// Of what it can only prove or see in shorter steps, it is left in doubt.
  static void never_halve(Sweep& sweep) { sweep.most_halvings_ = 0; }
};

}  // namespace mien
