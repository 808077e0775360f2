#pragma once

namespace mien::command {

/// What the command tells its caller.
enum ExitCode : int { kDone = 0, kFailed = 1, kUsedWrongly = 2 };

}  // namespace mien::command
