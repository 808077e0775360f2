#pragma once
// `mien animate …`, `mien morph …` and `mien mesh …` on the command line, and the options that pose a face.

#include "tools/mien/cli/animate_arguments.h"

#include <CLI/CLI.hpp>

namespace mien::command {

void add_animate(CLI::App& app, AnimateArguments& to);
void add_say(CLI::App& app, SayArguments& to);
void add_morph(CLI::App& app, MorphArguments& to);
void add_mesh(CLI::App& app, MeshArguments& to);
/// `mien sheet …` (sheet_options.cpp).
void add_sheet(CLI::App& app, SheetArguments& to);

/// FACE and the options that pose it, of every command that draws a face.
void add_pose(CLI::App* to, PosedFace& posed);

/// Options that others have too (command_line.cpp).
void add_picture(CLI::App* to, RenderArguments& render);
void add_threads(CLI::App* to, RenderArguments& render);

}  // namespace mien::command
