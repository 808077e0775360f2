#pragma once
// The messages of the command: on standard error one line each, on standard output its result.

#include <mien/expected.h>
#include "tools/mien/terminal/exit_code.h"

#include <string_view>
#include <vector>

namespace mien::command {

/// "mien: SENTENCE" on standard error, always one line; returns `code`.
int complain(std::string_view sentence, ExitCode code);
int complain(const Error& error, ExitCode code);

/// "mien: warning: …", a line each.
void warn(const std::vector<Error>& warnings);

/// The whole text to standard output, flushed; complains and gives kFailed if that fails. Inside another
/// command's work (outer_work.h) nothing is printed.
[[nodiscard]] int print(std::string_view text);

}  // namespace mien::command
