#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/terminal/messages.h"

namespace mien::command {

int check_command(const CheckArguments& arguments) {
  int code = kDone;
  for (const std::string& path : arguments.faces) {
    if (!read_face_aloud(path))
      code = kFailed;
    else if (const int failed = print(path + ": ok\n"))
      return failed;
  }
  return code;
}

}  // namespace mien::command
