// mien morph: one person becoming another; targets out of pairs of face files, or of heads in OBJ files.

#include <mien/face_file.h>
#include <mien/morph_file.h>
#include <mien/obj.h>
#include <mien/obj_map.h>
#include "render/image/file/written_file.h"
#include "tools/mien/cli/named_file.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/people/morph_between.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>

namespace mien::command {
namespace {

/// Targets of face files.
Expected<std::string> from_faces(const MorphArguments& arguments, const Face& rest) {
  std::vector<MorphTarget> targets;
  for (const std::string& text : arguments.targets) {
    const auto [name, file] = name_and_file(text);
    auto face = read_face_or_code(file);
    if (!face) return face.error();
    targets.push_back({name, *std::move(face)});
  }
  return morph_text(rest, targets);
}

Expected<std::string> from_heads(const MorphArguments& arguments, const Face& rest) {
  const auto map = read_obj_map(rest, arguments.map);
  if (!map) return map.error();
  const auto neutral = read_obj(arguments.neutral);
  if (!neutral) return neutral.error();
  std::vector<std::pair<std::string, Mesh>> targets;
  for (const std::string& text : arguments.targets) {
    const auto [name, file] = name_and_file(text);
    auto mesh = read_obj(file);
    if (!mesh) return mesh.error();
    if (const auto fits = check_fits(*neutral, *mesh, file); !fits) return fits.error();
    targets.emplace_back(name, *std::move(mesh));
  }
  return morph_text_from_meshes(rest, *map, *neutral, targets);
}

}  // namespace

int morph_command(const MorphArguments& arguments) {
  if (!arguments.people.empty()) return morph_between(arguments);
  const auto rest = read_face_or_report(arguments.rest);
  if (!rest) return kFailed;
  const auto text =
      arguments.from_obj ? from_heads(arguments, *rest) : from_faces(arguments, *rest);
  if (!text) {
    Error wrong = text.error();
    if (wrong.where.empty()) wrong.where = arguments.from_obj ? arguments.map : arguments.rest;
    return complain(wrong, kFailed);
  }
  const auto done = write_file(
      arguments.output, [&](const PutBytes& put) { return put(text->data(), text->size()); });
  return done ? kDone : complain(done.error(), kFailed);
}

}  // namespace mien::command
