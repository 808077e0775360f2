#include <mien/side.h>
#include "tools/mien/people/nonsense.h"

#include "nonsense_sight_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <variant>

namespace mien {
namespace {

constexpr double kHeadWidth = 1.05;  // of the faces that thresholds were found on, in their units
constexpr double kHides = 0.5;       // least opacity of what hides what lies below it

// Heights on a head, 0 at the chin and 1 at the crown.
constexpr double kTempleFrom =
    0.645;  // over the brows: what is below may be an ear's or a sideburn's
constexpr double kCrownFrom = 0.778;  // from here up all hair covers the head
constexpr double kChinUpTo = 0.03;
constexpr double kChinHalfWidth = 0.05;  // of the head: the narrowest beards cover as much

/// A colour's name in the palette: what is painted as skin hides no skin.
bool is_skin(const FaceModel& model, int color) {
  return model.layout[color].name.starts_with("palette/skin");
}

bool is_shorn(std::string_view color) {
  return color == "palette/hair_thin" || color == "palette/beard_thin";
}

/// How much of a feature hides what lies below it: all, what of a gradient is not clear, nothing.
enum class Hiding { all, part, none };

/// `skin_too`: of a brow, which skin hides as well; of the scalp it is the same as what it hides.
Hiding hiding_of(const Face& face, const Feature& feature, bool skin_too) {
  const FaceModel& model = *face.model;
  const auto hides_by = [&](int color) {
    // Shorn hair is there, though ink lets the skin through.
    if (!skin_too && is_shorn(model.layout[color].name)) return true;
    return (skin_too || !is_skin(model, color)) &&
           face.vector[std::size_t(model.layout[color].begin + 3)] >= kHides;
  };
  if (feature.paint >= 0) return hides_by(feature.paint) ? Hiding::all : Hiding::none;
  if (!feature.gradient) return Hiding::none;
  const std::vector<int>& colors = feature.gradient.in(model.gradients).colors;
  if (std::all_of(colors.begin(), colors.end(), hides_by)) return Hiding::all;
  return std::any_of(colors.begin(), colors.end(), hides_by) ? Hiding::part : Hiding::none;
}

bool begins_with_any(std::string_view name, std::initializer_list<std::string_view> begins) {
  return std::any_of(begins.begin(), begins.end(),
                     [&](std::string_view begin) { return name.starts_with(begin); });
}

bool is_glasses(std::string_view name) {
  return begins_with_any(name, {"lens", "rim", "bridge", "arm", "glass"});
}

std::string_view unsided(std::string_view name) {
  return name.substr(0, name.find('.'));
}

KnownFeatures::Sides both(const FaceModel& model, std::string_view name) {
  KnownFeatures::Sides sides{-1, -1};
  for (std::size_t i = 0; i < model.features.size(); ++i)
    for (std::size_t s = 0; s < 2; ++s)
      if (model.features[i].name == feature_of_side(name, s == 0 ? Side::left : Side::right))
        sides[s] = int(i);
  return sides;
}

/// What a part leaves out is there for the rig, but without a paint, or without opacity.
bool is_seen(const Face& face, const Feature& feature) {
  return feature.painted() &&
         (feature.opacity < 0 ||
          face.vector[std::size_t(face.model->layout[feature.opacity].begin)] != 0);
}

/// A style may draw two features as one area.
bool is_drawn(const Face& face, int feature) {
  const std::vector<Feature>& features = face.model->features;
  return is_seen(face, features[std::size_t(feature)]) ||
         std::any_of(features.begin() + feature, features.end(), [&](const Feature& later) {
           const auto* area = std::get_if<AreaFigure>(&later.figure);
           return area && is_seen(face, later) &&
                  std::any_of(area->any.begin(), area->any.end(),
                              [&](Index<Feature> of) { return of.at == feature; });
         });
}

/// The features of which an area is made; a feature of another figure is all there is of itself.
void add_members(const FaceModel& model, int feature, std::vector<int>& members) {
  const auto* area = std::get_if<AreaFigure>(&model.features[std::size_t(feature)].figure);
  if (!area) return members.push_back(feature);
  for (const Index<Feature> member : area->any) add_members(model, member.at, members);
}

/// Where a feature is drawn: itself, or the area that a style draws in its place, where it is known before.
int drawn_at(const FaceModel& model, int feature) {
  const std::vector<Feature>& features = model.features;
  if (features[std::size_t(feature)].painted()) return feature;
  for (std::size_t i = std::size_t(feature); i < features.size(); ++i) {
    const auto* area = std::get_if<AreaFigure>(&features[i].figure);
    if (features[i].painted() && area && area->any.size() == 1 && area->any[0].at == feature)
      return int(i);
  }
  return feature;
}

double up_sign(const Face& face) {
  return face.model->canvas.y_up ? 1.0 : -1.0;
}

}  // namespace

KnownFeatures::KnownFeatures(const Face& face) {
  const FaceModel& model = *face.model;
  opening = both(model, "opening"), pupil = both(model, "pupil"), brow = both(model, "brow");
  upper_lid = both(model, "upper_lid"), lens = both(model, "lens"), rim = both(model, "rim");
  arm = both(model, "arm"), ear = both(model, "ear");
  for (int& of_side : brow)
    if (of_side >= 0 && !is_drawn(face, of_side)) of_side = -1;
  int drawn_head = -1;
  for (int i = 0; i < int(model.features.size()); ++i) {
    const Feature& feature = model.features[std::size_t(i)];
    const std::string_view name = unsided(feature.name);
    for (const auto& [known, at] : {std::pair{"head", &head},
                                    {"nose", &nose},
                                    {"mouth", &mouth},
                                    {"beard", &beard},
                                    {"hijab", &hijab}})
      if (name == known && *at < 0) *at = i;
    if (head == i) drawn_head = drawn_at(model, head);
    const bool lip = (name == "lip_upper" || name == "lip_lower") && is_drawn(face, i);
    if (lip && name == "lip_upper") lip_upper.push_back(i);
    if (lip) lips.push_back(i);
    if (!feature.painted()) continue;
    if (!is_glasses(name)) {
      const Hiding hiding = hiding_of(face, feature, false);
      if (head >= 0 && i > drawn_head && !begins_with_any(name, {"beard", "moustache"})) {
        if (hiding == Hiding::all) add_members(model, i, over_head);
        if (hiding != Hiding::none) add_members(model, i, over_temples);
        one_mass = one_mass || name == "hair_mass";
      }
      const bool over_brows =
          hiding_of(face, feature, true) == Hiding::all && !name.starts_with("brow");
      for (std::size_t s = 0; s < 2; ++s)
        if (over_brows && brow[s] >= 0 && i > brow[s]) add_members(model, i, over_brow[s]);
    }
    // What is clipped to a feature stays in it; an area without a paint only makes room.
    const bool clipped =
        std::any_of(feature.clips.begin(), feature.clips.end(), [&](const FeatureClip& clip) {
          return !clip.outside && clip.feature.in(model.features).painted();
        });
    if (clipped) continue;
    if ((head >= 0 && i >= head) || begins_with_any(name, {"ear", "hearing"})) framed.push_back(i);
    if (std::holds_alternative<PathFigure>(feature.figure) && name != "mouth") looped.push_back(i);
  }
}

RestSight::RestSight(const Face& face_at_rest) : face(without_mood(face_at_rest)), known(face) {
  AreaCache areas(face);
  for (std::size_t s = 0; s < 2; ++s)
    if (const Polygon* opening = areas.loop_of(known.opening[s]))
      opening_area[s] = signed_area(*opening);
  for (const int feature : known.looped)
    for (const Polygon& loop : areas.of(feature).loops) loop_areas.push_back(signed_area(loop));
  if (areas.loop_of(known.head)) {
    unit = areas.of(known.head).box.size().x / kHeadWidth;
    find_hair(areas);
    find_beard(areas);
  }
  find_frame(areas);
}

void RestSight::find_hair(AreaCache& areas) {
  constexpr double kInside = 0.995;  // of the way from the middle to the outline
  const Polygon& head = *areas.loop_of(known.head);
  const Box2 box = areas.of(known.head).box;
  const double low = up_sign(face) > 0 ? box.lo.y : box.hi.y;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    const double height = (head[i].y - low) * up_sign(face) / box.size().y;
    if (height > kCrownFrom) {
      crown.push_back(i);
      covered +=
          areas.any_covers(known.over_head, box.center() + kInside * (head[i] - box.center()));
    } else if (height > kTempleFrom) {
      temples.push_back(i);
    }
  }
  // Bald, or nearly: a kippah is no hair.
  if (4 * covered <= 3 * crown.size()) crown.clear(), temples.clear();
  // Hair that fades into skin has an edge where it is drawn as one mass, within the head: on purpose.
  if (known.one_mass) temples.clear();
}

void RestSight::find_beard(AreaCache& areas) {
  if (known.beard < 0) return;
  const Polygon& head = *areas.loop_of(known.head);
  const Box2 box = areas.of(known.head).box, beard = areas.of(known.beard).box;
  const double sign = up_sign(face), low = sign > 0 ? box.lo.y : box.hi.y;
  const double reach = (sign > 0 ? beard.lo.y : beard.hi.y) - low;
  if (reach * sign > kChinUpTo * box.size().y) return;  // it ends above the chin
  for (std::size_t i = 0; i < head.size(); ++i)
    if ((head[i].y - low) * sign < kChinUpTo * box.size().y &&
        std::abs(head[i].x - box.center().x) < kChinHalfWidth * box.size().x)
      chin.push_back(i);
}

void RestSight::find_frame(AreaCache& areas) {
  constexpr double kHangs = 0.2;  // over the lower edge: what is so near hangs, and may leave
  const Box2 canvas = face.model->canvas.box;
  for (const int feature : known.framed) {
    const Box2 box = areas.of(feature).box;
    const double low = up_sign(face) > 0 ? box.lo.y - canvas.lo.y : canvas.hi.y - box.hi.y;
    leaves_below.push_back(low < kHangs * unit);
  }
}

NonsenseSight::NonsenseSight(const RestSight& at_rest, const Face& posed_face,
                             const NonsensePose& its_pose, std::vector<NonsenseFault>& list)
    : rest(at_rest),
      known(at_rest.known),
      posed(posed_face),
      pose(its_pose),
      areas(posed_face),
      unit(at_rest.unit),
      faults_(list) {
  up = {0, up_sign(posed)};
  const auto eye = [&](std::size_t s) -> const OpeningFigure* {
    return known.opening[s] < 0 ? nullptr
                                : std::get_if<OpeningFigure>(
                                      &posed.model->features[std::size_t(known.opening[s])].figure);
  };
  const OpeningFigure *left = eye(0), *other = eye(1);
  if (!left || !other) return;
  const auto at = [&](int slice) {
    const auto begin = std::size_t(posed.model->layout[slice].begin);
    return glm::dvec2{posed.vector[begin], posed.vector[begin + 1]};
  };
  const glm::dvec2 across = at(left->inner) + at(left->outer) - at(other->inner) - at(other->outer);
  if (!(glm::length(across) > 0)) return;
  right = glm::normalize(across);
  up = up_sign(posed) * glm::dvec2{-right.y, right.x};
}

void NonsenseSight::at_least(std::string_view check, double measured, double allowed,
                             std::string_view what) {
  if (!(measured >= allowed))
    faults_.push_back({check, pose.name, std::string(what), measured, allowed});
}

void NonsenseSight::at_most(std::string_view check, double measured, double allowed,
                            std::string_view what) {
  if (!(measured <= allowed))
    faults_.push_back({check, pose.name, std::string(what), measured, allowed});
}

}  // namespace mien
