#include "tools/mien/commands/run_command.h"
#include "tools/mien/cli/file_roles.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/terminal/messages.h"

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
  int operator()(const BatchArguments& arguments) const { return batch_command(arguments); }
  int operator()(const JoinArguments& arguments) const { return join_command(arguments); }
  int operator()(const StudioArguments& arguments) const { return studio_command(arguments); }
  int operator()(const ServeArguments& arguments) const { return serve_command(arguments); }
};

}  // namespace

int run_command(const CommandLine& line) {
  const FileRoles roles = file_roles(line);
  if (const auto safe = check_file_roles(roles); !safe) return complain(safe.error(), kUsedWrongly);
  if (const auto open = check_places(roles); !open) return complain(open.error(), kFailed);
  return std::visit(Run{}, line);
}

}  // namespace mien::command
