#include <mien/write.h>
#include "render/image/file/atomic_file.h"
#include "render/image/file/file_output.h"
#include "render/image/file/output_path.h"
#include "render/image/file/system_error.h"
#include "render/render_error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <new>

namespace mien {
namespace fs = std::filesystem;

namespace {

Expected<Done> put_text(const std::string& text, int descriptor) {
  FileOutput out(descriptor, true);
  if (!out.write(text.data(), text.size()))
    return Error{"", "cannot be written: " + system_error(out.failure())};
  return Done{};
}

Expected<Done> write_text(const std::string& text, const fs::path& path) {
  if (path == "-") return put_text(text, STDOUT_FILENO);
  const auto target = find_output_path(path);
  if (!target) return target.error();
  if (target->stream) {
    const int descriptor = ::open(target->path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return Error{"", "cannot be written: " + system_error(errno)};
    auto done = put_text(text, descriptor);
    ::close(descriptor);
    return done;
  }
  auto file = AtomicFile::begin(target->path);
  if (!file) return Error{"", file.error().what};
  if (auto done = put_text(text, file->descriptor()); !done) return done;
  if (auto done = file->commit(); !done) return Error{"", done.error().what};
  return Done{};
}

}  // namespace

Expected<std::vector<std::string>> write_svg(const Scene& scene, const fs::path& path,
                                             const SvgOptions& options) {
  const auto told = [&](const Error& error) {
    return error.where.empty() ? Error{path == "-" ? "standard output" : path.string(), error.what}
                               : error;
  };
  try {
    auto svg = svg_text(scene, options);
    if (!svg) return told(svg.error());
    if (auto done = write_text(svg->text, path); !done) return told(done.error());
    return std::move(svg->simplified);
  } catch (const std::bad_alloc&) {
    return told({"", std::string(kMemoryRanOut)});
  }
}

}  // namespace mien
