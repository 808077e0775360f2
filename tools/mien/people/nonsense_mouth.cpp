// Checks of a mouth that is a system: lips that close, teeth that are touched, a chin that goes with the jaw.

#include <mien/pose.h>

#include "nonsense_sight_private.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>

namespace mien {
namespace {

glm::dvec2 point_at(const Face& face, int slice) {
  const double* at = &face.vector[std::size_t(face.model->layout[slice].begin)];
  return {at[0], at[1]};
}

/// What the pens of features cover, without what lies twice.
double pen_area(AreaCache& areas, const std::vector<int>& features) {
  double area = 0;
  for (const int feature : features) {
    const std::vector<PenSample>& pen = areas.of(feature).pen;
    for (std::size_t i = 1; i < pen.size(); ++i)
      area += (pen[i - 1].half_width + pen[i].half_width) * glm::distance(pen[i - 1].at, pen[i].at);
  }
  return area;
}

/// Shut lips are one curve; they are neither lines nor lumps.
void check_lips_close(NonsenseSight& sight, const Mouth& mouth) {
  constexpr double kLeastLip = 0.6, kMostLip = 1.6;  // of the area at rest
  double gap = 0;
  for (std::size_t bend = 0; bend < 3; ++bend) {
    if (mouth.upper[bend].slice < 0) continue;
    for (const int upper : {mouth.upper[bend].slice, mouth.upper[bend].twin})
      for (const int lower : {mouth.lower[bend].slice, mouth.lower[bend].twin})
        if (upper >= 0 && lower >= 0)
          gap = std::max(gap,
                         glm::distance(point_at(sight.posed, upper), point_at(sight.posed, lower)));
  }
  sight.at_most("lips_close", gap, 0);
  AreaCache rest(sight.rest.face);
  const double at_rest = pen_area(rest, sight.known.lips);
  if (at_rest == 0 || sight.pose.bites) return;
  const double now = pen_area(sight.areas, sight.known.lips) / at_rest;
  sight.at_least("lips_close", now, kLeastLip, "area of the lips");
  sight.at_most("lips_close", now, kMostLip, "area of the lips");
}

/// Along the line of the eyes, how high the upper teeth's edge and the lower lip's stand: the teeth first.
void check_teeth_touch(NonsenseSight& sight, const Mouth& mouth) {
  if (mouth.teeth_edge[0] < 0) return;
  std::array<glm::dvec2, 3> teeth;
  for (std::size_t i = 0; i < 3; ++i) teeth[i] = point_at(sight.posed, mouth.teeth_edge[i]);
  const glm::dvec2 edge = 0.25 * (teeth[0] + teeth[2]) + 0.5 * teeth[1];
  const glm::dvec2 lip = point_at(sight.posed, mouth.lower[1].slice);
  sight.at_most("teeth_touch", glm::dot(edge - lip, sight.up) / sight.unit, 0);
}

/// How far the chin is below the teeth of the skull.
double chin_below(AreaCache& areas, const Face& face, const Mouth& mouth, int head, glm::dvec2 up) {
  const Polygon* outline = areas.loop_of(head);
  if (!outline) return 0;
  double low = std::numeric_limits<double>::infinity();
  for (const glm::dvec2 p : *outline) low = std::min(low, glm::dot(p, up));
  return glm::dot(point_at(face, mouth.teeth_edge[1]), up) - low;
}

/// The same pose with the jaw shut, in emotions too.
Pose without_jaw(const FaceModel& model, Pose pose) {
  std::erase_if(pose.settings, [&](const Setting& setting) {
    if (!setting.control) return false;
    const std::string_view name = model.controls[std::size_t(setting.index)].name;
    return name == "arkit.jawOpen" || name == "arkit.mouthClose";
  });
  for (std::size_t c = 0; c < model.controls.size(); ++c)
    if (model.controls[c].name == "muscle.jaw") pose.settings.push_back({true, int(c), {0}});
  return pose;
}

void check_chin_follows(NonsenseSight& sight, const Mouth& mouth) {
  constexpr double kLeast = 0.5;  // of the jaw's drop
  if (mouth.teeth_edge[0] < 0 || sight.known.head < 0 || sight.pose.turned) return;
  const Face& rest = sight.rest.face;
  const Face shut = pose_face(rest, without_jaw(*rest.model, sight.pose.pose));
  AreaCache areas(shut);
  const double moved = chin_below(sight.areas, sight.posed, mouth, sight.known.head, sight.up) -
                       chin_below(areas, shut, mouth, sight.known.head, sight.up);
  sight.at_least("chin_follows", moved / (mouth.drop * sight.pose.jaw), kLeast);
}

}  // namespace

void check_speech(NonsenseSight& sight) {
  const auto& mouth = sight.posed.model->mouth;
  if (!mouth) return;
  if (sight.pose.lips_shut) check_lips_close(sight, *mouth);
  if (sight.pose.bites) check_teeth_touch(sight, *mouth);
  if (sight.pose.jaw > 0) check_chin_follows(sight, *mouth);
}

}  // namespace mien
