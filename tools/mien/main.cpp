#include "lib/base/memory_ran_out.h"
#include "lib/base/watch.h"
#include "tools/mien/cli/command_line.h"
#include "tools/mien/commands/run_command.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/messages.h"

#include <cxxabi.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <typeinfo>

namespace mien::command {
namespace {

/// Where memory runs out and nobody can catch that: before main(), where the parser of arguments makes its constants, and
/// in its functions that let no exception out.
[[noreturn]] void end_without_memory() {
  const std::type_info* const thrown = abi::__cxa_current_exception_type();
  if (!thrown || *thrown != typeid(std::bad_alloc)) std::abort();
  constexpr std::string_view kSentence = "mien: memory ran out\n";
  if (::write(STDERR_FILENO, kSentence.data(), kSentence.size()) < 0) errno = 0;
  std::_Exit(kFailed);
}

/// Runs before the program's constants are made.
[[gnu::constructor(101)]] void watch_constants() {
  std::set_terminate(end_without_memory);
}

/// A standard stream that the caller closed stays closed: the next file to be opened would take its place, and what is
/// said would be written into it.
void keep_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF) ::open("/dev/null", O_RDONLY);
}

}  // namespace
}  // namespace mien::command

int main(int count, char** words) {
  using namespace mien::command;
  keep_closed_streams();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error like others
  std::signal(SIGXFSZ, SIG_IGN);  // and so is a file at its limit
  mien::Watch watch([] { return !interrupted(); }, mien::kWithoutLimits);
  try {
    const mien::Watching here(&watch);
    return run_command(read_command_line(count, words));
  } catch (const mien::Stopped&) {
    complain("interrupted", kFailed);
    die_of_interrupt();
  } catch (const std::bad_alloc&) {
    return complain(mien::memory_ran_out(), kFailed);
  } catch (const std::exception& failure) {
    return complain(failure.what(), kFailed);
  }
}
