#include <mien/render/shade/lit_mean.h>
#include <mien/render/shade/lit_paint.h>

namespace mien {

LitPaint::LitPaint(const TapePaint& paint, std::span<const AreaDistance> distances, Blend blend,
                   glm::dvec2 center, double tolerance)
    : surface_(paint, distances, blend, center), tolerance_(tolerance) {}

bool LitPaint::level(int zone) const {
  return surface_.relief().domes.empty() && surface_.flat(zone);
}

void LitPaint::pixels(int zone, int x, int y, int count, float* r, float* g, float* b, float* a,
                      Scratch& scratch) const {
  scratch.error = tolerance_;
  for (int i = 0; i < count; ++i) {
    const Mix mean = square_mean(surface_, zone, {x + i, y}, 1.0, 0.3 * tolerance_ / 255.0);
    r[i] = float(mean.r), g[i] = float(mean.g), b[i] = float(mean.b), a[i] = float(mean.a);
  }
}

glm::vec4 LitPaint::part(int zone, int x, int y, double area, glm::dvec2 centroid,
                         Scratch& scratch) const {
  constexpr int kPlaces = 10;  // each way
  scratch.error = 2.0 * tolerance_;
  return glm::vec4(part_mean(surface_, zone, {x, y}, area, centroid, kPlaces));
}

}  // namespace mien
