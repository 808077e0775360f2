#include "lib/base/watch.h"
#include "tools/mien/cli/command_line.h"
#include "tools/mien/cli/file_roles.h"
#include "tools/mien/commands/commands.h"
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

struct Run {
  int operator()(const Help& help) const { return print(help.text); }
  int operator()(const WrongUse& wrong) const { return complain(wrong.sentence, kUsedWrongly); }
  int operator()(const RenderArguments& arguments) const { return render_command(arguments); }
  int operator()(const BenchArguments& arguments) const { return bench_command(arguments); }
  int operator()(const CheckArguments& arguments) const { return check_command(arguments); }
  int operator()(const SceneArguments& arguments) const { return scene_command(arguments); }
  int operator()(const ListArguments& arguments) const { return list_command(arguments); }
  int operator()(const SetArguments& arguments) const { return set_command(arguments); }
  int operator()(const PcaArguments& arguments) const { return pca_command(arguments); }
  int operator()(const MorphArguments& arguments) const { return morph_command(arguments); }
  int operator()(const MeshArguments& arguments) const { return mesh_command(arguments); }
  int operator()(const AnimateArguments& arguments) const { return animate_command(arguments); }
  int operator()(const SayArguments& arguments) const { return say_command(arguments); }
  int operator()(const ImportArguments& arguments) const { return import_command(arguments); }
  int operator()(const FitArguments& arguments) const { return fit_command(arguments); }
  int operator()(const SheetArguments& arguments) const { return sheet_command(arguments); }
  int operator()(const NewArguments& arguments) const { return new_command(arguments); }
  int operator()(const CodeArguments& arguments) const { return code_command(arguments); }
  int operator()(const PartsArguments& arguments) const { return parts_command(arguments); }
  int operator()(const ChernoffArguments& arguments) const { return chernoff_command(arguments); }
  int operator()(const StimuliArguments& arguments) const { return stimuli_command(arguments); }
  int operator()(const StudioArguments& arguments) const { return studio_command(arguments); }
  int operator()(const ServeArguments& arguments) const { return serve_command(arguments); }
};

/// Where memory runs out and nobody can catch that: before main(), where the parser of arguments makes its constants, and
/// in its functions that let no exception out.
[[noreturn]] void end_without_memory() {
  const std::type_info* const thrown = abi::__cxa_current_exception_type();
  if (!thrown || *thrown != typeid(std::bad_alloc)) std::abort();
  constexpr std::string_view kSentence = "mien: not enough memory\n";
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
    const CommandLine line = read_command_line(count, words);
    const FileRoles roles = file_roles(line);
    if (const auto safe = check_file_roles(roles); !safe)
      return complain(safe.error(), kUsedWrongly);
    if (const auto open = check_places(roles); !open) return complain(open.error(), kFailed);
    return std::visit(Run{}, line);
  } catch (const mien::Stopped&) {
    complain("interrupted", kFailed);
    die_of_interrupt();
  } catch (const std::bad_alloc&) {
    return complain("not enough memory", kFailed);
  } catch (const std::exception& failure) {
    return complain(failure.what(), kFailed);
  }
}
