#include <mien/sdf/from_face/scene_from_face.h>
#include <mien/tools/mien/commands.h>
#include <mien/tools/mien/posed_face.h>

namespace mien::command {

int scene_command(const SceneArguments& arguments) {
  const auto posed = read_posed_face(arguments.posed);
  return posed.face ? print(scene_from_face(*posed.face).text()) : posed.code;
}

}  // namespace mien::command
