// Checks of what is on and around a face: hair, ears, what it wears, how it is drawn, its colours.

#include <mien/color.h>
#include "lib/picture/oklch.h"

#include "nonsense_sight_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

/// The outline's normal at a point, away from the inside.
glm::dvec2 outward(const Polygon& outline, std::size_t i, double turn) {
  const std::size_t n = outline.size();
  const glm::dvec2 along = outline[(i + 1) % n] - outline[(i + n - 1) % n];
  const double length = glm::length(along);
  return length > 0 ? turn / length * glm::dvec2{along.y, -along.x} : glm::dvec2{0};
}

void check_scalp(NonsenseSight& sight, const Polygon& head, double turn) {
  constexpr double kInside = 0.004;
  std::size_t bare = 0;
  for (const std::size_t i : sight.rest.crown)
    bare += !sight.areas.any_covers(sight.known.over_head,
                                    head[i] - kInside * sight.unit * outward(head, i, turn));
  sight.at_least("scalp_covered", 1.0 - double(bare) / double(sight.rest.crown.size()), 1);
}

/// How far hair reaches over the outline where it is near on one side of it.
void check_hairline(NonsenseSight& sight, const Polygon& head, double turn) {
  constexpr double kNearInside = 0.05, kNearOutside = 0.03, kLeast = 0.01;
  const auto hair = [&](std::size_t i, double out) {
    return sight.areas.any_covers(sight.known.over_temples,
                                  head[i] + out * sight.unit * outward(head, i, turn));
  };
  double least = kLeast;
  for (const std::size_t i : sight.rest.temples) {
    if (hair(i, 0) && hair(i, kLeast)) continue;
    if (!hair(i, -kNearInside) && !hair(i, kNearOutside)) continue;
    double reach = hair(i, 0) ? 0.0 : -kNearInside;
    for (const double out : {0.0025, 0.005, 0.0075})
      if (hair(i, 0) && hair(i, out)) reach = out;
    least = std::min(least, reach);
  }
  sight.at_least("hairline_overlaps", least, kLeast);
}

void check_ear(NonsenseSight& sight, std::size_t side) {
  constexpr double kLeastRoot = 0.03;
  const Polygon *ear = sight.areas.loop_of(sight.known.ear[side]),
                *head = sight.areas.loop_of(sight.known.head);
  if (!ear || !head) return;
  double root = -std::numeric_limits<double>::infinity();
  for (const glm::dvec2 p : *ear) root = std::max(root, depth_inside(*head, p));
  sight.at_least("ear_rooted", root / sight.unit, kLeastRoot, kSideNames[side]);
  if (sight.known.hijab < 0) return;
  std::size_t hidden = 0;
  for (const glm::dvec2 p : *ear)
    hidden += sight.areas.of(sight.known.hijab).covers(p) || turns_around(*head, p) != 0;
  sight.at_least("ear_hidden", double(hidden) / double(ear->size()), 1, kSideNames[side]);
}

void check_lens(NonsenseSight& sight, std::size_t side) {
  constexpr double kMostGap = 0.004;
  const Polygon* lens = sight.areas.loop_of(sight.known.lens[side]);
  if (!lens) return;
  if (const int pupil = sight.known.pupil[side]; pupil >= 0)
    sight.at_least("pupil_in_lens",
                   depth_inside(*lens, sight.areas.of(pupil).box.center()) / sight.unit, 0,
                   kSideNames[side]);
  const int arm = sight.known.arm[side];
  if (arm < 0) return;
  const Polygon* rim = sight.areas.loop_of(sight.known.rim[side]);
  double gap = std::numeric_limits<double>::infinity();
  for (const PenSample& sample : sight.areas.of(arm).pen) {
    gap = std::min(gap, -depth_inside(rim ? *rim : *lens, sample.at) - sample.half_width);
  }
  if (!sight.areas.of(arm).pen.empty())
    sight.at_most("arm_joined", std::max(gap, 0.0) / sight.unit, kMostGap, kSideNames[side]);
}

Oklch color_at(const Face& face, int slice) {
  const double* rgb = &face.vector[std::size_t(face.model->layout[slice].begin)];
  return Oklch::from_linear({rgb[0], rgb[1], rgb[2]});
}

bool has_contour(const FaceModel& model, int feature) {
  const Index<FaceSurroundings> around = model.features[std::size_t(feature)].surroundings;
  return around && around.in(model.surroundings).contour;
}

/// The least step in lightness that a line keeps in grey.
void check_line_on_skin(NonsenseSight& sight, int line, int skin, std::string_view what) {
  constexpr double kLeastStep = 0.18, kLeastGrey = 0.1;
  const Oklch a = color_at(sight.posed, line), b = color_at(sight.posed, skin);
  sight.at_least("colours", apart(a, b), kLeastStep, what);
  sight.at_least("colours", std::abs(a.lightness - b.lightness), kLeastGrey,
                 std::string(what) + ", grey");
}

}  // namespace

void check_hair(NonsenseSight& sight) {
  const Polygon* head = sight.areas.loop_of(sight.known.head);
  if (!head || sight.rest.crown.empty()) return;
  const double turn = signed_area(*head) > 0 ? 1.0 : -1.0;
  check_scalp(sight, *head, turn);
  check_hairline(sight, *head, turn);
}

void check_ears(NonsenseSight& sight) {
  for (const std::size_t side : {0u, 1u}) check_ear(sight, side);
}

void check_glasses(NonsenseSight& sight) {
  for (const std::size_t side : {0u, 1u}) check_lens(sight, side);
}

void check_beard(NonsenseSight& sight) {
  constexpr double kMostGap = 0.002;  // more than straight sides take away from curves
  const Polygon* head = sight.areas.loop_of(sight.known.head);
  if (!head || sight.rest.chin.empty()) return;
  const FlatArea& beard = sight.areas.of(sight.known.beard);
  double gap = 0;
  for (const std::size_t i : sight.rest.chin) {
    if (beard.covers((*head)[i])) continue;
    double way = std::numeric_limits<double>::infinity();
    for (const Polygon& loop : beard.loops) way = std::min(way, way_to_outline(loop, (*head)[i]));
    gap = std::max(gap, way);
  }
  sight.at_most("beard_on_chin", gap / sight.unit, kMostGap);
}

void check_drawing(NonsenseSight& sight) {
  constexpr double kLeastArea = 1e-3, kLeastEdge = 0.01;
  std::size_t at = 0;
  for (const int feature : sight.known.looped)
    for (const Polygon& loop : sight.areas.of(feature).loops)
      if (const double rest = sight.rest.loop_areas[at++]; std::abs(rest) >= kLeastArea)
        sight.at_least("no_loops", signed_area(loop) / rest, 0,
                       sight.posed.model->features[std::size_t(feature)].name);
  const Box2 canvas = sight.posed.model->canvas.box;
  const bool y_up = sight.posed.model->canvas.y_up;
  for (std::size_t i = 0; i < sight.known.framed.size(); ++i) {
    const int feature = sight.known.framed[i];
    const Box2 box = sight.areas.of(feature).box;
    if (box.empty()) continue;
    double room = std::min(box.lo.x - canvas.lo.x, canvas.hi.x - box.hi.x);
    const double high = canvas.hi.y - box.hi.y, low = box.lo.y - canvas.lo.y;
    room = std::min(room, y_up ? high : low);
    if (!sight.rest.leaves_below[i]) room = std::min(room, y_up ? low : high);
    sight.at_least("in_canvas", room / sight.unit, kLeastEdge,
                   sight.posed.model->features[std::size_t(feature)].name);
  }
}

void check_colors(NonsenseSight& sight) {
  struct Pair {
    std::string_view a, b, what;
    double least;
  };
  // The library asks for 0.01 more of cloth, which the bytes of a file may take away. Of backdrops it asks for twice as much, and takes the farthest where there is none.
  constexpr Pair kPairs[] = {{"palette/cloth", "palette/skin", "cloth beside skin", 0.15},
                             {"palette/cloth", "palette/hair", "cloth beside hair", 0.11},
                             {"palette/backdrop", "palette/skin", "backdrop beside skin", 0.07},
                             {"palette/backdrop", "palette/hair", "backdrop beside hair", 0.1},
                             {"palette/backdrop", "palette/cloth", "backdrop beside cloth", 0.1}};
  const FaceModel& model = *sight.posed.model;
  const Layout& layout = model.layout;
  const bool outlined = sight.known.head >= 0 && has_contour(model, sight.known.head);
  for (const Pair& pair : kPairs) {
    if (outlined) break;  // lines part what has one colour, as on paper
    const int a = layout.find(pair.a), b = layout.find(pair.b);
    if (a >= 0 && b >= 0)
      sight.at_least("colours", apart(color_at(sight.posed, a), color_at(sight.posed, b)),
                     pair.least, pair.what);
  }
  const int line = layout.find("palette/line"), skin = layout.find("palette/skin");
  if (line >= 0 && skin >= 0) check_line_on_skin(sight, line, skin, "line on skin");
}

}  // namespace mien
