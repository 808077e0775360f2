// mien import: a face of facemotion.js becomes a face file, a head with targets those of a face.

#include <mien/lib/file/facemotion.h>
#include <mien/tools/mien/commands.h>
#include <mien/tools/mien/messages.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <system_error>

namespace mien::command {
namespace {

/// Written beside its target, then renamed: an error leaves the old file as it was.
Expected<Done> write_text(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  const auto failed = [&] {
    const Error error{path, "cannot be written: " + std::generic_category().message(errno)};
    std::remove(part.c_str());
    return error;
  };
  std::FILE* file = std::fopen(part.c_str(), "wb");
  if (!file) return failed();
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (std::fclose(file) != 0 || !written) return failed();
  if (std::rename(part.c_str(), path.c_str()) != 0) return failed();
  return Done{};
}

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
  std::ifstream file(arguments.files[0], std::ios::binary);
  std::stringstream source;
  source << file.rdbuf();
  if (!file) return complain({arguments.files[0], "cannot be read"}, kFailed);
  FacemotionOptions options;
  options.morphology = arguments.morphology.value_or("");
  options.smooth = arguments.smooth;
  const auto text = face_text_from_facemotion(source.str(), arguments.files[0], options);
  if (!text) return complain(text.error(), kFailed);
  if (arguments.output == "-") return print(*text);
  const auto done = write_text(arguments.output, *text);
  return done ? int(kDone) : complain(done.error(), kFailed);
}

}  // namespace mien::command
