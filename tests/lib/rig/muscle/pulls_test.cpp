#include "lib/rig/muscle/pulls.h"

#include <mien/face_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include "tests/support/faces/faces.h"

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

/// A face with two controls and these expressions of VRM.
Face vrm_face(const std::string& expressions) {
  return read_face_text(
             R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
"palette": {"skin": "#f7db9c"}, "background": "skin", "features": [],
"controls": [{"name": "a", "range": [0, 9], "rest": 0}, {"name": "b", "range": [0, 9], "rest": 0}],
"expressions": {"vrm": {)" +
             expressions + "}}}")
      .value();
}

/// What expressions make of the controls a and b.
std::array<double, 2> moved(const Face& face,
                            const std::vector<std::pair<std::string, double>>& strengths) {
  std::vector<double> values(face.model->channels.size());
  const auto channel = [&](const std::string& name) -> double& {
    for (const Control& c : face.model->controls)
      if (c.name == name) return values[std::size_t(c.channels[0].at)];
    throw std::runtime_error(name);
  };
  for (const auto& [name, value] : strengths) channel("vrm." + name) = value;
  settle_expressions(*face.model, values);
  move_channels(*face.model, values);
  return {channel("a"), channel("b")};
}

using Pair = std::array<double, 2>;

TEST(MoveChannels, IsBinaryWhereAFileSaysSo) {
  const Face face = vrm_face(R"("happy": {"a": 2, "isBinary": true}, "sad": {"b": 1})");
  EXPECT_EQ(moved(face, {{"happy", 0.5}, {"sad", 0.5}}), (Pair{0, 0.5}));
  EXPECT_EQ(moved(face, {{"happy", 0.51}}), (Pair{2, 0}));
}

TEST(MoveChannels, OverridesByTheLawsOfVrm) {
  const Face face = vrm_face(
      R"("happy": {"overrideMouth": "blend"}, "sad": {"overrideBlink": "block"}, "angry": {"overrideMouth": "none"},
         "aa": {"a": 1, "overrideMouth": "block"}, "blink": {"b": 1})");
  EXPECT_EQ(moved(face, {{"aa", 1}, {"blink", 1}, {"angry", 1}}), (Pair{1, 1}));
  EXPECT_EQ(moved(face, {{"aa", 1}, {"blink", 1}, {"happy", 0.25}}), (Pair{0.75, 1}));
  EXPECT_EQ(moved(face, {{"aa", 1}, {"blink", 1}, {"sad", 0.1}}), (Pair{1, 0}));
}

TEST(MoveChannels, DividesByAnotherExpression) {
  const Face face = vrm_face(R"("happy": {"a": {"amount": 1, "per": "sad"}}, "sad": {"b": 1})");
  EXPECT_EQ(moved(face, {{"happy", 0.25}, {"sad", 0.5}}), (Pair{0.5, 0.5}));
  EXPECT_EQ(moved(face, {{"happy", 0.75}, {"sad", 0.5}}), (Pair{1, 0.5}));
  EXPECT_DOUBLE_EQ(moved(face, {{"happy", 0.001}})[0], 0.01);
}

TEST(MoveChannels, JoinsWhatAMouthDoes) {
  Face face = vrm_face(R"("happy": {"a": 0.5}, "sad": {"a": 0.5})");
  EXPECT_EQ(moved(face, {{"happy", 1}, {"sad", 1}})[0], 1);
  auto model = std::make_shared<FaceModel>(*face.model);
  model->channels[0].joins = true;
  EXPECT_EQ(moved({model, face.vector}, {{"happy", 1}, {"sad", 1}})[0], 0.75);
}

}  // namespace
}  // namespace mien
