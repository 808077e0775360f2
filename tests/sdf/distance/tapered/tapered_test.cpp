// Distances of strokes of varying width, in lanes, where they are hard.

#include <mien/distance.h>

#include <gtest/gtest.h>

#include "sdf/distance/instruction_sets.h"
#include "tools/accuracy/reference.h"
#include "tools/accuracy/tally.h"

namespace mien {
namespace {

/// Near the spine the depth has a kink that Newton's method took for settled: off by 2e-6 of the size
/// (the first) or 3e-4 (an end as deep as the kink). Far away no float can choose between discs: the last
/// was off by 2.4 ulps.
TEST(TaperedDistances, OfStrokesThatEarlierKernelsMissed) {
  const accuracy::Case cases[] = {
      {TaperedStroke{{{0.4796333909034729, 0.7863923907279968},
                      {0.7155038714408875, 0.5413349866867065},
                      {0.8059813976287842, 0.3919055461883545}},
                     {0.020679647102952003, 0.08501595258712769, 0.27752190828323364}},
       {0.7771180868148804, 0.4364013671875}},
      {TaperedStroke{{{0.1783943474292755, 0.8837308287620544},
                      {0.5868105888366699, 0.9351155161857605},
                      {0.7533949017524719, 0.8918353915214539}},
                     {0.07534898817539215, 0.009670564904808998, 0.19080644845962524}},
       {0.7344473004341125, 0.8958982229232788}},
      {TaperedStroke{{{0.02970052883028984, 0.5451488494873047},
                      {0.17288687825202942, 0.7583955526351929},
                      {0.7382633686065674, 0.0989353135228157}},
                     {0.19441424310207367, 0.13307268917560577, 0.01312915701419115}},
       {-88962.9765625, -226423.9375}},
  };
  for (const accuracy::Solver& s : accuracy::own_solvers()) {
    if (s.name != "tapered") continue;
    s.prepare();
    for (const accuracy::Case& k : cases) {
      const double error =
          accuracy::error_units(s.judge, true, k, accuracy::true_distance(k), s.solve(k));
      EXPECT_LE(error, 1) << s.instruction_set;
    }
  }
  batch::use_instruction_set(0);
}

}  // namespace
}  // namespace mien
