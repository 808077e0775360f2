#include "tests/support/faces/sample_poses.h"

#include "lib/rig/pose/expression_setting.h"

#include <utility>

namespace mien::test {

std::vector<NamedPose> sample_poses(const Face& face) {
  std::vector<NamedPose> poses{{"rest", {}}};
  for (const char* emotion : {"joy", "anger", "surprise"})
    if (const auto setting = read_expression(face, "emotion", emotion))
      poses.push_back({emotion, {.settings = {*setting}}});
  for (const auto& [name, text] : {std::pair{"blink_half", "blink=0.5"},
                                   {"blink", "blink=1"},
                                   {"turn_left", "yaw=-20"},
                                   {"turn_right", "yaw=20"}})
    if (const auto setting = read_setting(face, text))
      poses.push_back({name, {.settings = {*setting}}});
  poses.push_back({"unwrap_half", {.unwrap = 0.5}});
  return poses;
}

}  // namespace mien::test
