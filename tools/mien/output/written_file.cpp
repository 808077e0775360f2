#include "tools/mien/output/written_file.h"
#include "render/image/file/atomic_file.h"
#include "render/image/file/output_path.h"
#include "render/image/file/system_error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace mien::command {
namespace {

ByteSink sink_to(int descriptor) {
  return [descriptor](const void* bytes, std::size_t size) -> Expected<Done> {
    const char* at = static_cast<const char*>(bytes);
    while (size > 0) {
      const ssize_t put = ::write(descriptor, at, size);
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) return Error{"", "cannot be written: " + system_error(errno)};
      at += put;
      size -= std::size_t(put);
    }
    return Done{};
  };
}

Expected<Done> write_to(const std::string& path,
                        const std::function<Expected<Done>(const ByteSink&)>& write) {
  if (path == "-") return write(sink_to(STDOUT_FILENO));
  const auto target = find_output_path(path);
  if (!target) return target.error();
  if (target->stream) {
    const int descriptor = ::open(target->path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return Error{"", "cannot be written: " + system_error(errno)};
    auto done = write(sink_to(descriptor));
    ::close(descriptor);
    return done;
  }
  auto file = AtomicFile::begin(target->path);
  if (!file) return file.error();
  if (auto done = write(sink_to(file->descriptor())); !done) return done;
  return file->commit();
}

}  // namespace

Expected<Done> write_file(const std::string& path,
                          const std::function<Expected<Done>(const ByteSink&)>& write) {
  auto done = write_to(path, write);
  if (!done && done.error().where.empty())
    return Error{path == "-" ? "standard output" : path, done.error().what};
  return done;
}

}  // namespace mien::command
