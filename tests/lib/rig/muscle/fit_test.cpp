#include "lib/rig/muscle/fit.h"

#include <mien/poser.h>

#include <gtest/gtest.h>

#include "tests/support/faces/faces.h"

namespace mien {
namespace {

std::vector<PointTarget> targets_of(const Face& posed) {
  std::vector<PointTarget> targets;
  for (const MusclePoint& point : posed.model->muscles.points) {
    const auto begin = std::size_t(posed.model->layout[point.slice].begin);
    targets.push_back({point.slice, {posed.vector[begin], posed.vector[begin + 1]}});
  }
  return targets;
}

/// What muscles made, muscles can make again.
TEST(MuscleFit, FindsThePullsOfAPose) {  // M8
  const Face face = test::face_named("male");
  for (const std::vector<std::string>& pose :
       {std::vector<std::string>{"muscle.left.zygomaticus=0.6"},
        {"emotion.joy=0.7"},
        {"emotion.surprise=0.4", "emotion.left.anger=0.3"}}) {
    const MuscleFit fit = fit_muscles(face, targets_of(test::posed(face, pose)));
    EXPECT_LT(fit.rms, 1e-3) << pose[0];
    for (const double pull : fit.pulls) {
      EXPECT_GE(pull, 0);
      EXPECT_LE(pull, 1);
    }
  }
  const MuscleFit one =
      fit_muscles(face, targets_of(test::posed(face, {"muscle.left.zygomaticus=0.6"})));
  const auto& muscles = face.model->muscles.muscles;
  for (std::size_t m = 0; m < muscles.size(); ++m)
    EXPECT_NEAR(one.pulls[m],
                muscles[m].name == "zygomaticus" && muscles[m].side == Side::left ? 0.6 : 0, 1e-2)
        << muscles[m].name;
}

/// The pulls themselves come back, where points can tell them apart: one muscle alone, both sides of one,
/// and random mixes of muscles that hold points of their own.
TEST(MuscleFit, FindsThePullsThemselves) {
  for (const char* name : {"male", "bruno"}) {
    const Face face = test::face_named(name);
    const auto& muscles = face.model->muscles.muscles;
    for (const std::vector<std::string>& pose :
         {std::vector<std::string>{"muscle.left.zygomaticus=0.6"},
          {"muscle.jaw=0.35", "muscle.left.corrugator=0.8"},
          {"muscle.left.procerus=0.25", "muscle.right.zygomaticus=0.9", "muscle.jaw=0.5"}}) {
      Poser poser(face);
      Pose wanted;
      for (const std::string& text : pose) wanted.settings.push_back(*read_setting(face, text));
      const std::vector<PointTarget> targets = targets_of(poser.pose(wanted));
      const MuscleFit fit = fit_muscles(face, targets);
      EXPECT_LT(fit.rms, 1e-8 * face.model->canvas.box.size().x) << name << " " << pose[0];
      for (std::size_t m = 0; m < muscles.size(); ++m)
        EXPECT_NEAR(fit.pulls[m], poser.pulls()[m], 1e-6)
            << name << " " << pose[0] << ": " << control_of_side(muscles[m].name, muscles[m].side);
    }
  }
}

TEST(MuscleFit, SaysWhatIsLeft) {
  const Face face = test::face_named("male");
  std::vector<PointTarget> targets = targets_of(face);
  EXPECT_LT(fit_muscles(face, targets).rms, 1e-9);
  targets = {{face.model->layout.find("nose.left/points/0"), {0, 120}}};  // no muscle holds it
  const MuscleFit fit = fit_muscles(face, targets);
  EXPECT_DOUBLE_EQ(fit.largest, 5);
  EXPECT_DOUBLE_EQ(fit.rms, 5);
  EXPECT_EQ(fit.farthest, targets[0].slice);
}

}  // namespace
}  // namespace mien
