#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/watched_work.h"

namespace mien::command {

int check_command(const CheckArguments& arguments) {
  if (arguments.nonsense) return nonsense_command(arguments);
  if (arguments.seed) return complain("--seed: only with --nonsense", kUsedWrongly);
  if (arguments.style) return complain("--style: only with --nonsense", kUsedWrongly);
  if (arguments.output) return complain("--output: only with --nonsense", kUsedWrongly);
  if (arguments.json) return complain("--json: only with --nonsense", kUsedWrongly);
  if (arguments.faces.empty()) return complain("check: FACE is required", kUsedWrongly);
  int code = kDone;
  WatchedWork work("faces", arguments.faces.size());
  for (const std::string& path : arguments.faces) {
    if (!read_face_or_report(path))
      code = kFailed;
    else if (const int failed = print(path + ": ok\n"))
      return failed;
    work.step();
  }
  return code;
}

}  // namespace mien::command
