#include "render/svg/svg_gradient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace mien {
namespace {

/// What SVG shows at t: straight colours mixed between stops.
Mix shown(const SvgRamp& ramp, double t) {
  const double length = ramp.to - ramp.from;
  double s = t - ramp.from;
  if (ramp.extend == Extend::repeat) s -= length * std::floor(s / length);
  if (ramp.extend == Extend::reflect) {
    s = std::fmod(std::abs(s), 2 * length);
    s = s > length ? 2 * length - s : s;
  }
  s += ramp.from;
  std::size_t i = 0;
  while (i < ramp.stops.size() && ramp.stops[i].at <= s) ++i;
  Mix mix = i == 0 ? ramp.stops.front().straight : ramp.stops[i - 1].straight;
  if (i > 0 && i < ramp.stops.size()) {
    const SvgStop &a = ramp.stops[i - 1], &b = ramp.stops[i];
    mix += (s - a.at) / (b.at - a.at) * (b.straight - a.straight);
  }
  return {mix.a * mix.r, mix.a * mix.g, mix.a * mix.b, mix.a};
}

Gradient some_gradient(std::mt19937& random, Extend extend) {
  std::uniform_real_distribution<double> unit(0, 1);
  Gradient gradient{LinearGradient{{0, 0}, {1, 0}}, {}, extend};
  double at = 2 * unit(random) - 1.2;
  for (int i = 0; i < 4; ++i) {
    const double a = unit(random) < 0.3 ? 0 : unit(random) < 0.5 ? 1 : unit(random);
    gradient.stops.push_back({at, {unit(random), unit(random), unit(random), a}});
    at += unit(random) < 0.25 ? 0 : unit(random);
  }
  return gradient;
}

TEST(SvgGradient, MixesAsTheRampDoes) {
  std::mt19937 random(7);
  int far = 0;
  for (int i = 0; i < 600; ++i) {
    const Extend extend = Extend(i % 3);
    const Ramp ramp(some_gradient(random, extend), 0.9, Blend::srgb);
    const SvgRamp line = ramp_along_line(ramp), center = ramp_from_center(ramp);
    ASSERT_LT(line.from, line.to);
    ASSERT_EQ(center.from, 0);
    ASSERT_LT(0, center.to);
    for (double t = -3.001; t < 3; t += 0.0437) {
      // Within one place's rounding of a jump either side will do.
      const auto near = [&](const Mix& there) {
        return std::min({largest(there - ramp.color(t)), largest(there - ramp.color(t - 1e-9)),
                         largest(there - ramp.color(t + 1e-9))}) <= 2 * kStraightError;
      };
      far += !near(shown(line, t));
      if (t >= 0) far += !near(shown(center, t));
    }
  }
  EXPECT_EQ(far, 0);
}

TEST(SvgGradient, ATransparentStopHasTheColourBesideIt) {
  const Gradient fade{LinearGradient{{0, 0}, {1, 0}}, {{0, {1, 0, 0, 1}}, {1, {0, 0, 1, 0}}}};
  const SvgRamp ramp = ramp_along_line(Ramp(fade, 1, Blend::srgb));
  ASSERT_EQ(ramp.stops.size(), 2u) << "no more are needed";
  EXPECT_EQ(ramp.stops[1].straight, (Mix{1, 0, 0, 0}));
}

TEST(SvgGradient, OneWithoutExtentIsAColour) {
  const Gradient two{LinearGradient{{1, 1}, {1, 1}}, {{0, {1, 0, 0, 1}}, {1, {0, 0, 1, 0.5}}}};
  const Ramp ramp(two, 1, Blend::srgb);
  const std::string blue = " fill=\"#0000ff\" fill-opacity=\".5\"";
  EXPECT_EQ(svg_paint(LinearGradient{{1, 1}, {1, 1}}, ramp, {}, "a").fill, blue);
  EXPECT_EQ(svg_paint(RadialGradient{{1, 1}, {1, 0}}, ramp, {}, "a").fill, blue);
  EXPECT_EQ(svg_paint(RadialGradient{{std::nan(""), 1}, {1, 2}}, ramp, {}, "a").definition, "");
}

TEST(SvgGradient, OneThatViewersTakeForNoneLooksAsInPictures) {
  const std::vector<Stop> stops{{0, {0, 0, 0, 1}}, {1, {1, 1, 1, 1}}};
  const LinearGradient line{{1, 1}, {1 + 1e-12, 1}};
  const RadialGradient dot{{1, 1}, {1e-12, 1e-13}};
  for (const Extend extend : {Extend::repeat, Extend::reflect}) {
    const Ramp ramp({line, stops, extend}, 1, Blend::srgb);
    EXPECT_EQ(svg_paint(line, ramp, {}, "a").fill, " fill=\"#808080\"");
    EXPECT_EQ(svg_paint(dot, ramp, {}, "a").fill, " fill=\"#808080\"");
  }
  const std::string step = svg_paint(line, Ramp({line, stops}, 1, Blend::srgb), {}, "a").definition;
  EXPECT_NE(step.find("x1=\"1\""), step.npos) << step;
  EXPECT_NE(step.find("x2=\"1.001\""), step.npos) << step;
}

TEST(SvgGradient, IsPlacedInPixels) {
  const Ramp ramp(Gradient{LinearGradient{}, {{0, {1, 1, 1}}, {2, {0, 0, 0}}}}, 1, Blend::srgb);
  const Map<GridSpace, FaceSpace> map{glm::dmat2{10, 0, 0, -10}, {50, 50}};
  EXPECT_EQ(
      svg_paint(LinearGradient{{0, 0}, {1, 2}}, ramp, map, "a").definition,
      "<linearGradient id=\"a\" gradientUnits=\"userSpaceOnUse\" x1=\"50\" y1=\"50\" x2=\"70\" "
      "y2=\"10\"><stop offset=\"0\" stop-color=\"#ffffff\"/><stop offset=\"1\" "
      "stop-color=\"#000000\"/></linearGradient>\n");
  EXPECT_EQ(svg_paint(RadialGradient{{1, 0}, {2, 2}}, ramp, map, "b").definition.substr(0, 82),
            "<radialGradient id=\"b\" gradientUnits=\"userSpaceOnUse\" cx=\"60\" cy=\"50\" "
            "r=\"40\"><stop");
  EXPECT_EQ(
      svg_paint(RadialGradient{{1, 0}, {2, 1}, {0, 1}}, ramp, map, "c").definition.substr(54, 77),
      "cx=\"0\" cy=\"0\" r=\"2\" gradientTransform=\"matrix(0 -20 10 0 60 50)\"><stop offset");
}

}  // namespace
}  // namespace mien
