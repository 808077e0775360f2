#include <mien/render/view/view.h>

#include <algorithm>

namespace mien {

Map<PixelSpace, FaceSpace> pixel_from_face(const Canvas& canvas, const View& view) {
  const glm::dvec2 size = canvas.box.size(), center = canvas.box.center();
  const double sx = view.width / size.x, sy = view.height / size.y;
  const double scale = view.fit == Fit::meet ? std::min(sx, sy) : std::max(sx, sy);
  const glm::dmat2 linear{scale, 0.0, 0.0, canvas.y_up ? -scale : scale};
  return {linear, -(linear * center)};
}

PixelRect drawn_rect(const View& view) {
  return view.region.value_or(PixelRect{0, 0, view.width, view.height});
}

}  // namespace mien
