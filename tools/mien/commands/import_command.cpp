// mien import: a face of facemotion.js becomes a face file, a head with targets those of a face.

#include "lib/file/json/read_bytes.h"
#include "render/image/file/written_file.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/import/facemotion.h"
#include "tools/mien/terminal/messages.h"

namespace mien::command {
namespace {

int import_targets(const ImportArguments& arguments) {
  const auto& files = arguments.files;
  if (files.size() < 4)
    return complain("import obj-targets: expected FACE MAP NEUTRAL TARGETS...", kUsedWrongly);
  return morph_command({.from_obj = true,
                        .rest = files[0],
                        .map = files[1],
                        .neutral = files[2],
                        .output = arguments.output,
                        .targets = {files.begin() + 3, files.end()}});
}

}  // namespace

int import_command(const ImportArguments& arguments) {
  if (arguments.format == "obj-targets") return import_targets(arguments);
  if (arguments.format != "facemotion")
    return complain({"import " + arguments.format, "expected facemotion or obj-targets"},
                    kUsedWrongly);
  if (arguments.files.size() != 1)
    return complain("import facemotion: expected one FILE", kUsedWrongly);
  FacemotionOptions options;
  const auto source = read_bytes(arguments.files[0], options.limits.bytes);
  if (!source) return complain(source.error(), kFailed);
  options.morphology = arguments.morphology.value_or("");
  options.smooth = arguments.smooth;
  const auto text = face_text_from_facemotion(*source, arguments.files[0], options);
  if (!text) return complain(text.error(), kFailed);
  const auto done = write_file(
      arguments.output, [&](const PutBytes& put) { return put(text->data(), text->size()); });
  return done ? int(kDone) : complain(done.error(), kFailed);
}

}  // namespace mien::command
