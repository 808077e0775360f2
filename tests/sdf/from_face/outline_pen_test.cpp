#include <mien/face_file.h>
#include <mien/face_model.h>

#include "sdf/from_face/outline_pen_private.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

std::vector<Shape> pen_of(const std::string& feature, double thin, double thick) {
  const Expected<Face> face = read_face_text(test::face_with(feature));
  if (!face) throw std::runtime_error(sentence(face.error()));
  return outline_pen(face->model->features[0].figure, *face, thin, thick);
}

double distance_to(const std::vector<Shape>& pieces, glm::dvec2 p) {
  double nearest = HUGE_VAL;
  for (const Shape& piece : pieces) nearest = std::min(nearest, distance(piece, p));
  return nearest;
}

const std::string kSquare =
    R"({"name": "a", "kind": "path", "points": [[0, 0], [1, 0], [1, 1], [0, 1]]})";

/// 4 s (1 − s) of the way from thin to thick, s the share of the way round.
TEST(OutlinePen, SwellsAndThinsOut) {
  const auto pieces = pen_of(kSquare, 0.02, 0.1);
  const struct {
    double s;
    glm::dvec2 at, out;
  } places[] = {{0.125, {0.5, 0}, {0, -1}}, {0.375, {1, 0.5}, {1, 0}}, {0.875, {0, 0.5}, {-1, 0}}};
  for (const auto& [s, at, out] : places) {
    // The pen's discs grow along the way, and so their rim leans by an angle whose sine is the growth.
    const double width = 0.02 + 0.08 * 4 * s * (1 - s), growth = 0.08 * (1 - 2 * s);
    EXPECT_NEAR(distance_to(pieces, at + 0.5 * out), 0.5 * std::sqrt(1 - growth * growth) - width,
                2e-4)
        << s;
    EXPECT_NEAR(distance_to(pieces, at), -width, 2e-4) << s;
  }
}

TEST(OutlinePen, GoesRoundEllipsesAndOpenings) {
  const auto round = pen_of(
      R"({"name": "a", "kind": "ellipse", "center": [0.2, 0.1], "radii": [0.5, 0.2], "tilt": 30})",
      0.01, 0.01);
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.157 * i, c = std::cos(0.5235987755982988), s = 0.5;
    const double x = 0.5 * std::cos(angle), y = 0.2 * std::sin(angle);
    const double off = distance_to(round, {0.2 + c * x - s * y, 0.1 + s * x + c * y});
    EXPECT_NEAR(off, -0.01, 1.2e-4) << i;
  }
  EXPECT_EQ(
      pen_of(
          R"({"name": "a", "kind": "opening", "inner": [0, 0], "upper": [0.5, 1], "outer": [1, 0], "lower": [0.5, -1]})",
          0.01, 0.02)
          .size(),
      2u);
  EXPECT_TRUE(
      pen_of(
          R"({"name": "a", "kind": "opening", "inner": [0, 0], "upper": [0.5, 1], "outer": [1, 0], "lower": [0.5, 1]})",
          0.01, 0.02)
          .empty())
      << "shut";
}

}  // namespace
}  // namespace mien
