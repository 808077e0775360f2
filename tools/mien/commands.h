#pragma once
// The commands, a file each. Each gives the exit code.

#include <mien/tools/mien/arguments.h>

namespace mien::command {

int render_command(const RenderArguments& arguments);
int bench_command(const BenchArguments& arguments);
int check_command(const CheckArguments& arguments);
int scene_command(const SceneArguments& arguments);
int list_command(const ListArguments& arguments);

}  // namespace mien::command
