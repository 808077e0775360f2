#pragma once
// The signed distance field of FreeType's rasteriser, asked for one distance: docs/solvers.md.
//
// Source. The FreeType Project, FT_RENDER_MODE_SDF, since 2.11; called, not copied. A field is made for a glyph of some
// pixels and has a byte for each, so it answers for the middles of pixels, within a reach, in 128 steps on each side.

#include "tools/accuracy/families.h"

#include <memory>
#include <optional>

namespace mien::accuracy {

/// How large the curve is drawn and how far the field reaches, in whole pixels.
struct FieldSetting {
  int size;    ///< of the curve's control points, the longer side
  int spread;  ///< FreeType's property, 2 to 32: the reach

  double step() const { return spread / 128.0; }  ///< between two answers [px]
};

class FreetypeField {
 public:
  /// Throws std::runtime_error with a sentence where FreeType or its module "sdf" is not there.
  FreetypeField();

  /// Whether the case can be asked at all: a Bézier curve that has a size.
  static bool can_draw(const Case& k);

  /// The distance in pixels of a field with the case's point in the middle of a pixel: the middle of the step that the
  /// byte stands for. None where the byte is the last or the point is in no pixel. The curve is drawn there and back,
  /// since outlines are closed, and rounded to 64ths of pixels, since FreeType's coordinates are.
  std::optional<double> distance(const Case& k, FieldSetting setting);

  /// Pixels of the last field.
  std::size_t pixels() const { return pixels_; }

 private:
  struct Library;
  std::shared_ptr<Library> library_;  // which is not known here
  std::size_t pixels_ = 0;
};

}  // namespace mien::accuracy
