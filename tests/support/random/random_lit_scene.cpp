#include "tests/support/random/random_lit_scene.h"

#include <utility>
#include <vector>

#include "tests/support/random/scene_dice.h"

namespace mien::test {
namespace {

Relief random_relief(Dice& dice, Area own, Area other) {
  Relief relief{.area = dice.chance(0.7) ? own : other,
                .profile = Profile(dice.below(4)),
                .width = dice.between(0.03, 0.6)};
  relief.height = relief.width * dice.between(-0.7, 1.3);
  if (relief.profile == Profile::custom)
    for (int i = 2 + dice.below(5); i > 0; --i)
      relief.table.push_back(dice.chance(0.2) && !relief.table.empty() ? relief.table.back()
                                                                       : dice.unit());
  const int domes = relief.profile == Profile::flat ? 1 + dice.below(3)
                    : dice.chance(0.3)              ? 1 + dice.below(2)
                                                    : 0;
  for (int i = 0; i < domes; ++i) {
    Dome dome{.center = dice.place(),
              .radii = {dice.between(0.1, 0.8), 0},
              .axis = dice.way(),
              .height = dice.between(-0.1, 0.25)};
    dome.radii.y = dome.radii.x * dice.between(0.4, 1.6);
    relief.domes.push_back(dome);
  }
  if (relief.profile == Profile::flat && dice.chance(0.5)) relief.area = {};
  relief.specular = dice.chance(0.6) ? dice.unit() : 0;
  relief.shininess = dice.between(2, 80);
  return relief;
}

Light random_light(Dice& dice) {
  const glm::dvec2 way = dice.way();
  const double aside = dice.between(0, 1.2), front = dice.between(0.3, 1.2);
  return {.direction = {aside * way, front}, .ambient = dice.unit()};
}

}  // namespace

Scene random_lit_scene(std::uint64_t seed) {
  Dice dice(seed);
  const bool y_up = dice.chance(0.7);
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}, .y_up = y_up}, dice.color(0));
  build.light(random_light(dice));
  std::vector<Area> areas;
  for (int i = 0; i < 5; ++i) areas.push_back(build.shape(random_shape(dice)));
  const auto any = [&] { return any_of(dice, areas); };
  int open = 0;
  for (int i = 0; i < 4; ++i) {
    combine_randomly(dice, build, areas);
    if (dice.chance(0.2))
      build.open_group("group", dice.unit(), dice.chance(0.3) ? any() : Area{}), ++open;
    const Area area = any();
    Paint paint{dice.color(0.3)};
    if (dice.chance(0.3)) paint.gradient = shared(random_gradient(dice, area, any()));
    if (dice.chance(0.8)) paint.relief = shared(random_relief(dice, area, any()));
    build.layer("layer", area, paint);
    if (open > 0 && dice.chance(0.4)) build.close_group(), --open;
  }
  while (open-- > 0) build.close_group();
  return std::move(build).finish();
}

}  // namespace mien::test
