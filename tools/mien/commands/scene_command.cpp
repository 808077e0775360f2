#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"

namespace mien::command {

int scene_command(const SceneArguments& arguments) {
  const auto read = read_scene(arguments.posed, arguments.debug);
  return read.scene ? print(read.scene->text()) : read.code;
}

}  // namespace mien::command
