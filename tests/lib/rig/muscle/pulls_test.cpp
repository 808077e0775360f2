#include "lib/rig/muscle/pulls.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/faces.h"

namespace mien {
namespace {

struct Pulling {
  Face face = test::face_named("male");
  std::vector<double> values = std::vector<double>(face.model->channels.size());
  std::vector<char> held = std::vector<char>(face.model->channels.size());

  void set(const std::string& control, double value, bool hold = true) {
    for (const Control& c : face.model->controls)
      if (c.name == control)
        for (const Index<Channel> channel : c.channels)
          values[std::size_t(channel.at)] = value, held[std::size_t(channel.at)] = hold;
  }
  double pull(const std::string& muscle, Side side) const {
    std::vector<double> pulls;
    muscle_pulls(*face.model, values, held, pulls);
    const auto& all = face.model->muscles.muscles;
    for (std::size_t m = 0; m < all.size(); ++m)
      if (all[m].name == muscle && all[m].side == side) return pulls[m];
    return -1;
  }
};

TEST(MusclePulls, MixEmotionsByTheLaw) {  // M6
  Pulling face;
  EXPECT_EQ(face.pull("zygomaticus", Side::left), 0);
  face.set("emotion.joy", 0.8);
  EXPECT_DOUBLE_EQ(face.pull("zygomaticus", Side::left), 0.8);
  EXPECT_DOUBLE_EQ(face.pull("levator-labii", Side::right), 0.4);
  face.set("emotion.surprise", 0.5);
  EXPECT_DOUBLE_EQ(face.pull("levator-labii", Side::left), 1 - (1 - 0.5 * 0.8) * (1 - 0.8 * 0.5));
  face.set("emotion.joy", 1), face.set("emotion.surprise", 1);
  EXPECT_EQ(face.pull("orbicularis-oris", Side::left), 1);
}

TEST(MusclePulls, DoNotDependOnTheOrderOfEmotions) {  // M6
  const Face face = test::face_named("male");
  std::vector<std::string> settings{"emotion.anger=0.7", "emotion.fear=0.31", "emotion.joy=0.11",
                                    "emotion.sadness=0.53"};
  const FaceVector first = test::posed(face, settings).vector;
  while (std::next_permutation(settings.begin(), settings.end()))
    ASSERT_EQ(test::posed(face, settings).vector, first);
}

TEST(MusclePulls, OfAMuscleThatIsSetAreThatNumber) {  // M7
  Pulling face;
  face.set("emotion.joy", 1);
  face.set("muscle.zygomaticus", 0.25);
  EXPECT_EQ(face.pull("zygomaticus", Side::left), 0.25);
  EXPECT_EQ(face.pull("levator-labii", Side::left), 0.5)
      << "a partial update changes no other muscle";
  face.set("muscle.left.zygomaticus", 0);
  EXPECT_EQ(face.pull("zygomaticus", Side::left), 0);
  EXPECT_EQ(face.pull("zygomaticus", Side::right), 0.25);
}

TEST(MusclePulls, HaveSides) {  // M10
  Pulling face;
  face.set("emotion.left.joy", 0.4);
  EXPECT_DOUBLE_EQ(face.pull("zygomaticus", Side::left), 0.4);
  EXPECT_EQ(face.pull("zygomaticus", Side::right), 0);
}

TEST(MusclePulls, ComeFromStandardNamesToo) {
  Pulling face;
  face.set("arkit.mouthSmileLeft", 0.6);
  EXPECT_DOUBLE_EQ(face.pull("zygomaticus", Side::left), 0.6);
  EXPECT_EQ(face.pull("zygomaticus", Side::right), 0);
  face.set("facs.AU12", 0.5);
  EXPECT_DOUBLE_EQ(face.pull("zygomaticus", Side::left), 1 - 0.4 * 0.5);
  EXPECT_DOUBLE_EQ(face.pull("zygomaticus", Side::right), 0.5);
  face.set("vrm.happy", 1);
  EXPECT_EQ(face.pull("zygomaticus", Side::right), 1);
}

}  // namespace
}  // namespace mien
