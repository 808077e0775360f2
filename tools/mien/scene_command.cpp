#include <mien/tools/mien/commands.h>
#include <mien/tools/mien/posed_face.h>

namespace mien::command {

int scene_command(const SceneArguments& arguments) {
  const auto read = read_scene(arguments.posed, arguments.debug);
  return read.scene ? print(read.scene->text()) : read.code;
}

}  // namespace mien::command
