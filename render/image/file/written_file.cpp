#include "render/image/file/written_file.h"
#include "render/image/file/atomic_file.h"
#include "render/image/file/file_output.h"
#include "render/image/file/output_path.h"
#include "render/image/file/system_error.h"

#include <fcntl.h>
#include <unistd.h>

namespace mien {
namespace fs = std::filesystem;

namespace {

using WriteBytes = std::function<Expected<Done>(const PutBytes&)>;

Expected<Done> write_into(int descriptor, const WriteBytes& write) {
  FileOutput out(descriptor, true);
  return write([&](const void* bytes, std::size_t size) -> Expected<Done> {
    if (!out.write(bytes, size))
      return Error{"", "cannot be written: " + system_error(out.failure())};
    return Done{};
  });
}

Expected<Done> write_to(const fs::path& path, const WriteBytes& write) {
  if (path == "-") return write_into(STDOUT_FILENO, write);
  const auto target = find_output_path(path);
  if (!target) return target.error();
  if (target->stream) {
    const auto descriptor = open_stream(target->path);
    if (!descriptor) return descriptor.error();
    const ClosedInTheEnd closed(*descriptor);
    return write_into(*descriptor, write);
  }
  auto file = AtomicFile::begin(target->path);
  if (!file) return Error{"", file.error().what};  // its path is where a link leads
  if (auto done = write_into(file->descriptor(), write); !done) return done;
  if (auto done = file->commit(); !done) return Error{"", done.error().what};
  return Done{};
}

}  // namespace

Expected<Done> write_file(const fs::path& path, const WriteBytes& write) {
  auto done = write_to(path, write);
  if (!done && done.error().where.empty())
    return Error{path == "-" ? "standard output" : path.string(), done.error().what};
  return done;
}

}  // namespace mien
