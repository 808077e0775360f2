#include "tests/support/random/random_scene.h"

#include <utility>
#include <vector>

#include "tests/support/random/scene_dice.h"

namespace mien::test {

Scene random_painted_scene(std::uint64_t seed) {
  Dice dice(seed);
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {dice.unit(), dice.unit(), dice.unit(), 1});
  std::vector<Area> areas;
  for (int i = 0; i < 6; ++i) areas.push_back(build.shape(random_shape(dice)));
  const auto any = [&] { return any_of(dice, areas); };
  int open = 0;
  for (int i = 0; i < 5; ++i) {
    combine_randomly(dice, build, areas);
    if (dice.chance(0.25))
      build.open_group("group", dice.unit(), dice.chance(0.3) ? any() : Area{}), ++open;
    const Area area = any();
    Paint paint{dice.color(0.3)};
    if (dice.chance(0.5)) {
      paint.gradient = shared(random_gradient(dice, area, any()));
      paint.color.a = dice.chance(0.5) ? 1 : dice.unit();
    }
    build.layer("layer", area, paint);
    if (open > 0 && dice.chance(0.4)) build.close_group(), --open;
  }
  while (open-- > 0) build.close_group();
  return std::move(build).finish();
}

}  // namespace mien::test
