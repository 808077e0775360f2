#include "lib/rig/mouth/mouth_numbers.h"

#include <gtest/gtest.h>

#include <vector>

namespace mien {
namespace {

/// A mouth whose acts are channels in their order, each half one.
struct PlainMouth {
  Mouth mouth;
  std::vector<double> values = std::vector<double>(2 * kMouthActs);

  PlainMouth() {
    for (std::size_t act = 0; act < kMouthActs; ++act)
      mouth.channels[act] = {Index<Channel>{int(2 * act)}, Index<Channel>{int(2 * act + 1)}};
  }
  void set(MouthAct act, double left, double right) {
    values[2 * std::size_t(act)] = left, values[2 * std::size_t(act) + 1] = right;
  }
  MouthNumbers numbers(double pulled = 0) const { return mouth_numbers(mouth, values, pulled); }
};

TEST(MouthNumbers, OfAMouthAtRestAreNone) {
  EXPECT_EQ(PlainMouth().numbers(), MouthNumbers{});
}

TEST(MouthNumbers, OpenTheJawAsPullsDo) {
  PlainMouth plain;
  plain.set(MouthAct::jaw_open, 0.5, 0);
  EXPECT_EQ(plain.numbers().jaw, 0.5);
  EXPECT_DOUBLE_EQ(plain.numbers(0.5).jaw, 0.75);
  EXPECT_EQ(plain.numbers(1.2).jaw, 1);
}

TEST(MouthNumbers, LeaveTheJawToSpeech) {
  PlainMouth plain;
  plain.values.insert(plain.values.end(), {0.3, 0.2, 0.9});
  const int first = 2 * int(kMouthActs);
  plain.mouth.speech = {{first}, {first + 1}};
  plain.set(MouthAct::jaw_open, 0.5, 0);
  EXPECT_DOUBLE_EQ(plain.numbers(0.5).jaw, 1 - 0.5 * (1 - 0.5 * (1 - 0.8 * 0.5)));
  plain.mouth.speech.push_back({first + 2});
  EXPECT_DOUBLE_EQ(plain.numbers(0.5).jaw, 1 - 0.5 * (1 - 0.5 * 0.2)) << "no more than whole";
}

TEST(MouthNumbers, LetTheTongueWin) {
  PlainMouth plain;
  plain.set(MouthAct::close, 1, 0), plain.set(MouthAct::tongue_out, 0.75, 0);
  EXPECT_EQ(plain.numbers().close, 0.25);
  EXPECT_DOUBLE_EQ(plain.numbers().jaw, 0.35 * 0.75);
}

TEST(MouthNumbers, HaveHalves) {
  PlainMouth plain;
  plain.set(MouthAct::press, 0.2, 0.7);
  EXPECT_EQ(plain.numbers().press, (std::array{0.2, 0.7}));
}

}  // namespace
}  // namespace mien
