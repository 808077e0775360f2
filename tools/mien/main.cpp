#include "lib/base/watch.h"
#include "tools/mien/cli/command_line.h"
#include "tools/mien/commands/run_command.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/messages.h"

#include <csignal>
#include <exception>
#include <new>

int main(int count, char** words) {
  using namespace mien::command;
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
    return complain("not enough memory", kFailed);
  } catch (const std::exception& failure) {
    return complain(failure.what(), kFailed);
  }
}
