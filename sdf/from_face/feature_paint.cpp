#include <mien/face_model.h>
#include "feature_paint_private.h"
#include "sdf/from_face/figure/face_numbers_private.h"

#include <algorithm>

namespace mien {
namespace {

constexpr double kLeast = 1e-9;  ///< the least length to divide by, whatever the pose

struct Along {
  const FaceNumbers& n;
  Area own;

  using Any = decltype(Gradient::along);
  Any operator()(const LinearPaint& p) const {
    return LinearGradient{n.point(p.from), n.point(p.to)};
  }
  Any operator()(const RadialPaint& p) const {
    return RadialGradient{n.point(p.center), n.point(p.radii), n.way(p.tilt)};
  }
  Any operator()(const DistancePaint& p) const {
    return DistanceGradient{own, -n(p.inside), n(p.outside)};
  }
};

Gradient gradient_of(const GradientPaint& paint, const Face& face, Area own) {
  const FaceNumbers n(face);
  Gradient gradient{.along = std::visit(Along{n, own}, paint.along),
                    .stops = {},
                    .extend = Extend(int(paint.extend))};
  for (std::size_t i = 0; i < paint.colors.size(); ++i)
    gradient.stops.push_back({n(paint.places, int(i)), color_of(face, paint.colors[i])});
  return gradient;
}

Relief relief_of(const FaceRelief& given, const Face& face, Area own) {
  const FaceNumbers n(face);
  const Relief without;
  const double sign = given.sunk ? -1 : 1;
  Relief relief{.area = own,
                .profile = Profile(int(given.profile)),
                .width = std::max(n.value_or(given.width, 1), kLeast),
                .height = sign * n.value_or(given.height, 0),
                .table = {},
                .domes = {},
                .specular = std::min(n.value_or(given.specular, without.specular), 1.0),
                .shininess = std::max(n.value_or(given.shininess, without.shininess), kLeast)};
  for (int i = 0; given.table >= 0 && i < n.size(given.table); ++i)
    relief.table.push_back(n(given.table, i));
  for (const FaceDome& dome : given.domes)
    if (n(dome.height) != 0)  // no bulge: as if there were no dome
      relief.domes.push_back({.center = n.point(dome.center),
                              .radii = glm::max(n.point(dome.radii), glm::dvec2{kLeast}),
                              .axis = n.way(dome.tilt),
                              .height = sign * n(dome.height)});
  return relief;
}

}  // namespace

Color color_of(const Face& face, int slice) {
  const FaceNumbers n(face);
  return {n(slice, 0), n(slice, 1), n(slice, 2), n(slice, 3)};
}

double opacity_of(const Face& face, int slice) {
  return std::min(FaceNumbers(face).value_or(slice, 1), 1.0);
}

Paint paint_of(const Feature& feature, const Face& face, Area own) {
  const FaceModel& model = *face.model;
  const double opacity = opacity_of(face, feature.opacity);
  Paint paint;
  if (feature.gradient) {
    paint.gradient = shared(gradient_of(feature.gradient.in(model.gradients), face, own));
    paint.color.a = opacity;
  } else {
    Color color = color_of(face, feature.paint);
    color.a *= opacity;
    const double feather = FaceNumbers(face).value_or(feature.feather, 0);
    paint = feather > 0 ? falling(own, color, -feather, 0) : Paint{.color = color};
  }
  if (feature.relief) {
    Relief relief = relief_of(feature.relief.in(model.reliefs), face, own);
    const bool rises = relief.profile != Profile::flat && relief.height != 0;
    if (rises || !relief.domes.empty()) paint.relief = shared(std::move(relief));
  }
  return paint;
}

Surroundings surroundings_of(const Feature& feature, const Face& face) {
  Surroundings made;
  if (!feature.surroundings) return made;
  const FaceSurroundings& given = feature.surroundings.in(face.model->surroundings);
  const FaceNumbers n(face);
  if (given.shadow) {
    made.shadow_on = given.shadow->on;
    made.shadow = SoftShadow{
        .color = color_of(face, given.shadow->color),
        .blur = std::max(n(given.shadow->blur), kLeast),
        .shift = given.shadow->shift < 0 ? glm::dvec2{0.0} : n.point(given.shadow->shift)};
  }
  if (given.glow)
    made.glow = Glow{.color = color_of(face, given.glow->color),
                     .reach = std::max(n(given.glow->reach), kLeast)};
  if (given.contour) {
    const FaceContour& line = *given.contour;
    const bool even = line.by == FaceContour::By::none;
    const double first = n(line.half_width), second = even ? first : n(line.half_width, 1);
    // By the angle the first is the thin one, whatever a pose made of them.
    const double thin = line.by == FaceContour::By::angle ? std::min(first, second) : first;
    const double thick = line.by == FaceContour::By::angle ? std::max(first, second) : second;
    if (std::max(thin, thick) > 0)
      made.contour = {color_of(face, line.color), line.by, thin, thick};
  }
  return made;
}

}  // namespace mien
