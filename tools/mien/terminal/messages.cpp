#include "tools/mien/terminal/messages.h"
#include "lib/base/one_line.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/outer_work.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace mien::command {
namespace {

constexpr std::size_t kLongest =
    1000;  // bytes of a message: paths may be long, lines need not be longer

void say(std::string_view text) {
  const OuterWork* const outer = OuterWork::present();
  const std::string where = outer && !interrupted() ? outer->where() + ": " : "";
  const std::string line = "mien: " + one_line(where + std::string(text), kLongest) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace

int complain(std::string_view sentence, ExitCode code) {
  say(sentence);
  return code;
}

int complain(const Error& error, ExitCode code) {
  return complain(sentence(error), code);
}

void warn(const std::vector<Error>& warnings) {
  for (const Error& warning : warnings) say("warning: " + sentence(warning));
}

int print(std::string_view text) {
  if (OuterWork::present()) return kDone;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return kDone;
  if (errno == EPIPE) return kFailed;  // who reads has seen enough: mien list FACE | head
  return complain(fmt::format("standard output: cannot be written: {}", std::strerror(errno)),
                  kFailed);
}

}  // namespace mien::command
