#include <mien/view.h>

#include <algorithm>

namespace mien {

Map<PixelSpace, FaceSpace> pixel_from_face(const Canvas& canvas, const View& view) {
  return pixel_from_face(canvas, {view.width, view.height}, view.fit);
}

Map<PixelSpace, FaceSpace> pixel_from_face(const Canvas& canvas, glm::dvec2 picture, Fit fit) {
  const glm::dvec2 size = canvas.box.size(), center = canvas.box.center();
  const double sx = picture.x / size.x, sy = picture.y / size.y;
  const double scale = fit == Fit::meet ? std::min(sx, sy) : std::max(sx, sy);
  const glm::dmat2 linear{scale, 0.0, 0.0, canvas.y_up ? -scale : scale};
  return {linear, -(linear * center)};
}

PixelRect drawn_rect(const View& view) {
  if (!view.region) return {0, 0, view.width, view.height};
  const PixelRect& r = *view.region;
  const int x = std::clamp(r.x, 0, view.width), y = std::clamp(r.y, 0, view.height);
  const auto end = [](int from, int length, int side) {
    return int(std::clamp<long long>((long long)from + length, 0, side));
  };
  return {x, y, std::max(0, end(r.x, r.width, view.width) - x),
          std::max(0, end(r.y, r.height, view.height) - y)};
}

}  // namespace mien
