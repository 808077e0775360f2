#include <mien/render/tile/tape.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

using Kind = Step::Kind;

std::string program(const Tape& tape, int layer) {
  std::string text;
  const TapeLayer& l = tape.layers[std::size_t(layer)];
  for (int i = l.first; i < l.first + l.count; ++i) {
    const Step& s = tape.steps[std::size_t(i)];
    switch (s.kind) {
      case Kind::outline:
        text += char('a' + s.outline);
        break;
      case Kind::nothing:
        text += '0';
        break;
      case Kind::not_:
        text += '!';
        break;
      case Kind::and_:
        text += '&';
        break;
      case Kind::or_:
        text += '|';
        break;
    }
  }
  return text;
}

const View kView{.width = 100, .height = 100};

TEST(Tape, TakesCornersApartIntoSmoothOutlines) {
  SceneBuilder build({}, {});
  build.layer("triangle", build.shape(Triangle{{0, 0}, {0.2, 0}, {0, 0.3}}), {});
  build.layer("flat", build.shape(Triangle{{0, 0}, {0.2, 0}, {0.1, 0}}), {});
  build.layer("cut disc", build.shape(CutDisc{{0, 0}, 0.3, 0.5, 0.6, {0, 1}}), {});
  const Tape tape = tape_from_scene(std::move(build).finish(), kView);
  EXPECT_EQ(program(tape, 0), "ab&c&");  // top to bottom: the last layer first
  EXPECT_EQ(program(tape, 1), "0");
  EXPECT_EQ(program(tape, 2), "de&f&");
}

TEST(Tape, SharesOneOutlineBetweenLayers) {
  SceneBuilder build({}, {});
  const Area opening = build.shape(Disc{{0, 0}, 0.3});
  build.layer("white", opening, {});
  build.layer("iris", build.both(build.shape(Disc{{0.1, 0}, 0.1}), opening), {});
  const Tape tape = tape_from_scene(std::move(build).finish(), kView);
  EXPECT_EQ(tape.outlines.size(), 2u);
  EXPECT_EQ(program(tape, 0), "ab&");
  EXPECT_EQ(program(tape, 1), "b");
}

TEST(Tape, PushesOffsetsAndShellsDownToTheShapes) {
  SceneBuilder build({}, {});
  const Area a = build.shape(Disc{{0, 0}, 0.3}), b = build.shape(Disc{{0.1, 0}, 0.1});
  build.layer("x", build.shell(build.offset(build.without(a, b), 0.02), 0.01), {});
  const Tape tape = tape_from_scene(std::move(build).finish(), kView);
  EXPECT_EQ(program(tape, 0), "ab!&cd!&!&");
  EXPECT_DOUBLE_EQ(tape.outlines[0].offset, 3);   // a <= 0.03, in pixels
  EXPECT_DOUBLE_EQ(tape.outlines[1].offset, -3);  // not b <= −0.03
  EXPECT_DOUBLE_EQ(tape.outlines[2].offset, 1);   // not (a <= 0.01 …)
  EXPECT_DOUBLE_EQ(tape.outlines[3].offset, -1);
}

TEST(Tape, OfAShellOfNegativeWidthIsNothing) {
  SceneBuilder build({}, {});
  build.layer("x", build.shell(build.shape(Disc{{0, 0}, 0.3}), -0.01), {});
  EXPECT_EQ(program(tape_from_scene(std::move(build).finish(), kView), 0), "0");
}

}  // namespace
}  // namespace mien
