#pragma once
// Light on a relief: how a slope changes the colour of a surface. The law is Light's, in sdf/scene/paint.h.

#include <mien/paint.h>
#include "render/blend/blender.h"

#include <glm/vec2.hpp>

namespace mien {

/// A lamp prepared for one material: unit directions, and the highlight on a level surface.
class Lamp {
 public:
  /// A direction of no length, or not from the front, shines straight on.
  Lamp(const Light& light, double specular, double shininess);

  /// The colour of a surface that rises by `slope` per length: x right, y UP in the picture.
  Mix lit(const Mix& color, glm::dvec2 slope, Blend blend) const;

  /// For the form in lanes: unit directions, and the law's numbers.
  const glm::dvec3& to_lamp() const { return to_lamp_; }
  const glm::dvec3& halfway() const { return halfway_; }
  double ambient() const { return ambient_; }
  double specular() const { return level_shine_ < 1.0 ? specular_ : 0.0; }
  double shininess() const { return shininess_; }
  double level_shine() const { return level_shine_; }

 private:
  glm::dvec3 to_lamp_, halfway_;
  double ambient_, specular_, shininess_, level_shine_;
};

}  // namespace mien
