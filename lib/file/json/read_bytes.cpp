#include "lib/file/json/read_bytes.h"

#include "lib/base/monotonic_seconds.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace mien {
namespace {

constexpr double kWriterComes = 1.0;  // [s] that a pipe without a writer is waited for

/// An open file, closed in the end.
struct OpenFile {
  int descriptor;
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

Error unreadable(const std::string& name) {
  return {name, fmt::format("cannot be read: {}", std::generic_category().message(errno))};
}

}  // namespace

Expected<Done> read_in_blocks(const std::filesystem::path& path,
                              const std::function<bool(std::string_view)>& take) {
  const std::string name = one_line(path.string());
  // Opening a pipe would wait for its writer for ever.
  const OpenFile file{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
  struct stat info = {};
  if (file.descriptor < 0 || ::fstat(file.descriptor, &info) != 0) return unreadable(name);
  if (S_ISDIR(info.st_mode)) return Error{name, "is a directory"};
  const double opened = monotonic_seconds();
  bool any = false;
  char block[1 << 16];
  for (;;) {
    const ssize_t got = ::read(file.descriptor, block, sizeof block);
    if (got > 0) {
      any = true;
      if (!take({block, std::size_t(got)})) return Done{};
    } else if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      pollfd waits{file.descriptor, POLLIN, 0};
      ::poll(&waits, 1, -1);  // there is a writer: until it writes or ends
    } else if (got < 0 && errno != EINTR) {
      return unreadable(name);
    } else if (got == 0) {
      if (!S_ISFIFO(info.st_mode) || any) return Done{};
      if (monotonic_seconds() - opened > kWriterComes)
        return Error{name, "is a pipe that nothing is written to"};
      ::poll(nullptr, 0, 10);
    }
  }
}

Expected<std::string> read_bytes(const std::filesystem::path& path, std::size_t most) {
  std::string bytes;
  const auto read = read_in_blocks(path, [&](std::string_view block) {
    bytes += block;
    return bytes.size() <= most;
  });
  if (!read) return read.error();
  if (bytes.size() > most)
    return Error{one_line(path.string()), fmt::format("longer than {} bytes (limit: bytes)", most)};
  return bytes;
}

}  // namespace mien
