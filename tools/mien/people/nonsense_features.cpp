// Checks of what every face has: eyes, mouth, brows.

#include "nonsense_sight_private.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <variant>

namespace mien {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// How much of an area lies in another one, by a grid of points on its box.
double share_inside(const FlatArea& area, const Polygon& in) {
  constexpr int kGrid = 7;
  int all = 0, inside = 0;
  for (int i = 0; i < kGrid; ++i)
    for (int j = 0; j < kGrid; ++j) {
      const glm::dvec2 p =
          area.box.lo + area.box.size() * glm::dvec2{(i + 0.5) / kGrid, (j + 0.5) / kGrid};
      if (!area.covers(p)) continue;
      ++all;
      inside += turns_around(in, p) != 0;
    }
  return all > 0 ? double(inside) / all : 0.0;
}

void check_eye(NonsenseSight& sight, std::size_t side) {
  constexpr double kShutArea = 1e-12;  // [face units squared]
  constexpr double kNearlyShut = 0.4;  // of the area at rest: a pupil may hide
  constexpr double kLeastPupil = 0.25, kInHead = 0.02;
  const Polygon* opening = sight.areas.loop_of(sight.known.opening[side]);
  const double area = opening ? signed_area(*opening) : 0.0, rest = sight.rest.opening_area[side];
  if (sight.pose.blink == 1)
    sight.at_most("lids_meet", std::abs(area), kShutArea, kSideNames[side]);
  if (sight.pose.blink == 1 || !opening || rest == 0) return;
  sight.at_least("no_loops", area / rest, 0, "opening");
  if (const int pupil = sight.known.pupil[side]; pupil >= 0 && area / rest >= kNearlyShut)
    sight.at_least("pupil_in_opening", share_inside(sight.areas.of(pupil), *opening), kLeastPupil,
                   kSideNames[side]);
  const Polygon* head = sight.areas.loop_of(sight.known.head);
  if (!head) return;
  double depth = kNever;
  for (const glm::dvec2 p : *opening) depth = std::min(depth, depth_inside(*head, p));
  sight.at_least("eye_in_head", depth / sight.unit, sight.pose.turned ? 0.0 : kInHead,
                 kSideNames[side]);
}

/// Half the way between the inner corners, along the line of the eyes.
void check_eyes_apart(NonsenseSight& sight) {
  constexpr double kLeast = 0.03;
  std::array<double, 2> inner{};
  for (std::size_t s = 0; s < 2; ++s) {
    const Polygon* opening = sight.areas.loop_of(sight.known.opening[s]);
    if (!opening) return;
    inner[s] = kNever;
    for (const glm::dvec2 p : *opening)
      inner[s] = std::min(inner[s], (s == 0 ? 1.0 : -1.0) * glm::dot(p, sight.right));
  }
  sight.at_least("eyes_apart", 0.5 * (inner[0] + inner[1]) / sight.unit, kLeast);
}

/// The pen of a line; of an area its outline, as a pen without width.
std::vector<PenSample> pen_of(const FlatArea& area) {
  if (!area.pen.empty()) return area.pen;
  std::vector<PenSample> pen;
  for (const Polygon& loop : area.loops)
    for (const glm::dvec2 p : loop) pen.push_back({p, 0});
  return pen;
}

void check_lips_in_head(NonsenseSight& sight) {
  constexpr double kLeast = 0.012;
  const Polygon* head = sight.areas.loop_of(sight.known.head);
  if (!head) return;
  std::vector<int> lips = sight.known.lips;
  if (lips.empty() && sight.known.mouth >= 0) lips.push_back(sight.known.mouth);
  double depth = kNever;
  for (const int lip : lips)
    for (const PenSample& sample : pen_of(sight.areas.of(lip)))
      depth = std::min(depth, depth_inside(*head, sample.at) - sample.half_width);
  sight.at_least("mouth_in_head", depth / sight.unit, kLeast);
}

void check_lip_below_nose(NonsenseSight& sight) {
  constexpr double kLeast = 0.004, kBeside = 0.05;
  // Turned, a nose that stands out 0.055 farther than lips lies over them by parallax: sin 25° of it,
  // and as the line of the eyes is not level then, a little more.
  constexpr double kLeastTurned = -0.03;
  const Polygon* nose = sight.areas.loop_of(sight.known.nose);
  if (!nose) return;
  double low = kNever, top = -kNever;
  glm::dvec2 middle{0};
  for (const glm::dvec2 p : *nose) low = std::min(low, glm::dot(p, sight.up)), middle += p;
  middle /= double(nose->size());
  std::vector<int> lips = sight.known.lip_upper;
  if (lips.empty()) lips.push_back(sight.known.mouth);
  for (const int lip : lips)
    for (const PenSample& sample : pen_of(sight.areas.of(lip)))
      if (std::abs(glm::dot(sample.at - middle, sight.right)) < kBeside * sight.unit)
        top = std::max(top, glm::dot(sample.at, sight.up) + sample.half_width);
  sight.at_least("lip_below_nose", (low - top) / sight.unit,
                 sight.pose.turned ? kLeastTurned : kLeast);
}

double widest_pen(const FlatArea& area) {
  double widest = 0;
  for (const PenSample& sample : area.pen) widest = std::max(widest, sample.half_width);
  return widest;
}

void check_brow_above_lid(NonsenseSight& sight, std::size_t side) {
  constexpr double kLeast = -0.012;
  const Polygon* opening = sight.areas.loop_of(sight.known.opening[side]);
  if (!opening || sight.pose.lowers_brow) return;
  const int lid = sight.known.upper_lid[side];
  const double line = lid >= 0 ? widest_pen(sight.areas.of(lid)) : 0.0;
  glm::dvec2 middle{0};
  for (const glm::dvec2 p : *opening) middle += p / double(opening->size());
  double gap = kNever;
  for (const PenSample& sample : pen_of(sight.areas.of(sight.known.brow[side]))) {
    const double below = glm::dot(sample.at - middle, sight.up);
    gap = std::min({gap, below < 0 ? below : kNever,
                    -depth_inside(*opening, sample.at) - sample.half_width - line});
  }
  sight.at_least("brow_above_lid", gap / sight.unit, kLeast, kSideNames[side]);
}

void check_brow_seen(NonsenseSight& sight, std::size_t side) {
  constexpr double kLeast = 0.66,
                   kLeastTurned = 0.4;  // who looks far up is seen from below a fringe
  const std::vector<PenSample> pen = pen_of(sight.areas.of(sight.known.brow[side]));
  std::size_t seen = 0;
  for (const PenSample& sample : pen)
    seen += !sight.areas.any_covers(sight.known.over_brow[side], sample.at);
  sight.at_least("brow_seen", double(seen) / double(pen.size()),
                 sight.pose.turned ? kLeastTurned : kLeast, kSideNames[side]);
}

}  // namespace

void check_eyes(NonsenseSight& sight) {
  for (const std::size_t side : {0u, 1u}) check_eye(sight, side);
  if (sight.pose.blink != 1) check_eyes_apart(sight);
}

void check_mouth(NonsenseSight& sight) {
  if (sight.known.lips.empty() && sight.known.mouth < 0) return;
  check_lips_in_head(sight);
  check_lip_below_nose(sight);
}

void check_brows(NonsenseSight& sight) {
  for (const std::size_t side : {0u, 1u}) {
    if (sight.known.brow[side] < 0) continue;
    check_brow_above_lid(sight, side);
    check_brow_seen(sight, side);
  }
}

}  // namespace mien
