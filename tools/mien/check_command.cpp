#include <mien/tools/mien/commands.h>
#include <mien/tools/mien/messages.h>
#include <mien/tools/mien/posed_face.h>

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
