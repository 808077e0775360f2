#include "tests/support/scenes/stroke_scene.h"

#include <algorithm>
#include <vector>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

using Row = std::vector<TaperedStroke>;

Row random_row(Random& r) {
  Row row;
  const double size = r.size(-2, 0), wide = size * r.size(-3, -0.5);
  glm::dvec2 at = r.point(-0.9, 0.9);
  glm::dvec2 ahead = 0.3 * size * r.point(-1, 1);
  double width = r.chance(0.3) ? 0.0 : wide * r.unit(), grows = 0.3 * wide * (r.unit() - 0.5);
  for (int k = 1 + r.below(9); k > 0; --k) {
    if (r.chance(0.15)) ahead = 0.3 * size * r.point(-1, 1);
    if (r.chance(0.15)) grows = wide * (r.unit() - 0.5);
    const double tight = 0.4 * size * r.unit();
    const glm::dvec2 bend = at + ahead, turn = ahead + tight * r.point(-1, 1);
    const double middle = std::max(width + grows, 0.0), rate = 0.3 * wide * (r.unit() - 0.5),
                 last = std::max(middle + rate, 0.0);
    row.push_back({{at, bend, bend + turn}, {width, middle, last}});
    at = bend + turn, ahead = turn, width = last, grows = rate;
  }
  return row;
}

Row mirrored(Row row) {
  for (TaperedStroke& s : row)
    for (glm::dvec2* p : {&s.spine.p0, &s.spine.p1, &s.spine.p2}) p->x = -p->x;
  return row;
}

Row moved(Row row, glm::dvec2 by) {
  for (TaperedStroke& s : row)
    for (glm::dvec2* p : {&s.spine.p0, &s.spine.p1, &s.spine.p2}) *p += by;
  return row;
}

Area area_of(const Row& row, SceneBuilder& build) {
  Area all = build.shape(row[0]);
  for (std::size_t k = 1; k < row.size(); ++k) all = build.unite(all, build.shape(row[k]));
  return all;
}

}  // namespace

Scene stroke_scene(std::uint64_t seed) {
  Random r(seed);
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {r.unit(), r.unit(), r.unit(), 1});
  const auto layer = [&](Area area) {
    const double alpha = r.chance(0.3) ? r.unit() : 1;
    build.layer("row", area, {{r.unit(), r.unit(), r.unit(), alpha}});
  };
  for (int k = 0; k < 3; ++k) {
    const Row row = random_row(r);
    const Area area = area_of(row, build);
    layer(area);
    if (r.chance(0.3)) layer(area_of(mirrored(row), build));
    const double far = r.size(-9, -2);
    if (r.chance(0.3)) layer(area_of(moved(row, far * r.point(-1, 1)), build));
    if (r.chance(0.3)) layer(build.offset(area, r.between(-0.01, 0.03)));
    if (r.chance(0.2)) layer(build.shell(area, 0.02 * r.unit()));
  }
  return std::move(build).finish();
}

}  // namespace mien::test
