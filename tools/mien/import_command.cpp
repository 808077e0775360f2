// mien import facemotion: a face of facemotion.js becomes a face file.

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

}  // namespace

int import_command(const ImportArguments& arguments) {
  if (arguments.format != "facemotion")
    return complain({"import " + arguments.format, "expected facemotion"}, kUsedWrongly);
  std::ifstream file(arguments.source, std::ios::binary);
  std::stringstream source;
  source << file.rdbuf();
  if (!file) return complain({arguments.source, "cannot be read"}, kFailed);
  FacemotionOptions options;
  options.morphology = arguments.morphology.value_or("");
  options.smooth = arguments.smooth;
  const auto text = face_text_from_facemotion(source.str(), arguments.source, options);
  if (!text) return complain(text.error(), kFailed);
  if (arguments.output == "-") return print(*text);
  const auto done = write_text(arguments.output, *text);
  return done ? int(kDone) : complain(done.error(), kFailed);
}

}  // namespace mien::command
