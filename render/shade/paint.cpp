#include "render/shade/paint.h"

#include <glm/geometric.hpp>

namespace mien {

double PaintField::at(glm::dvec2 p, double d) const {
  switch (kind) {
    case Kind::linear:
      return glm::dot(p, across) + shift;
    case Kind::radial:
      return glm::length(unit * (p - center));
    case Kind::distance:
      return (d - from) * scale;
  }
  return 0.0;
}

}  // namespace mien
