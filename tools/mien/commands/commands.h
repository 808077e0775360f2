#pragma once
// The commands, a file each. Each gives the exit code.

#include "tools/mien/cli/animate_arguments.h"
#include "tools/mien/cli/arguments.h"
#include "tools/mien/cli/batch_arguments.h"
#include "tools/mien/cli/pca_arguments.h"
#include "tools/mien/cli/serve_arguments.h"
#include "tools/mien/cli/studio_arguments.h"

#include <mien/expected.h>
#include <mien/image.h>

#include <functional>

namespace mien::command {

int render_command(const RenderArguments& arguments);
int bench_command(const BenchArguments& arguments);
int check_command(const CheckArguments& arguments);
/// check --nonsense.
int nonsense_command(const CheckArguments& arguments);
int scene_command(const SceneArguments& arguments);
int list_command(const ListArguments& arguments);
int set_command(const SetArguments& arguments);
int pca_command(const PcaArguments& arguments);
int morph_command(const MorphArguments& arguments);
int mesh_command(const MeshArguments& arguments);
/// A frame that is there already, by its number; an error's `where` is left empty.
using DrawnFrame = std::function<Expected<Image>(long frame)>;
/// `drawn`: where a film's frames come from instead of being drawn, on several threads at once.
int animate_command(const AnimateArguments& arguments, const DrawnFrame& drawn = {});
int say_command(const SayArguments& arguments);
int import_command(const ImportArguments& arguments);
int fit_command(const FitArguments& arguments);
int sheet_command(const SheetArguments& arguments);
int new_command(const NewArguments& arguments);
int code_command(const CodeArguments& arguments);
int parts_command(const PartsArguments& arguments);
int chernoff_command(const ChernoffArguments& arguments);
int stimuli_command(const StimuliArguments& arguments);
int batch_command(const BatchArguments& arguments);
int join_command(const JoinArguments& arguments);
int studio_command(const StudioArguments& arguments);
int serve_command(const ServeArguments& arguments);

}  // namespace mien::command
