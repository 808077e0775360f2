// Where FreeType is not there: everything links, and whoever asks for a field is told.

#include "tools/accuracy/methods/freetype_field.h"

#include <stdexcept>

namespace mien::accuracy {

FreetypeField::FreetypeField() {
  throw std::runtime_error(
      "this mien-accuracy was built without FreeType, whose fields it cannot judge");
}

bool FreetypeField::can_draw(const Case&) {
  return false;
}
std::optional<double> FreetypeField::distance(const Case&, FieldSetting) {
  return {};
}

}  // namespace mien::accuracy
