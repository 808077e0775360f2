#include "lib/file/json/placed_reader.h"

#include "lib/base/one_line.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace mien {
namespace {

Error unread(const std::string& name, int code) {
  return {name, fmt::format("cannot be read: {}", std::generic_category().message(code))};
}

}  // namespace

Expected<PlacedReader> PlacedReader::open(const std::filesystem::path& path) {
  PlacedReader file;
  file.name_ = one_line(path.string());
  // Opening a pipe would wait for its writer for ever.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return unread(file.name_, errno);
  const auto close = [](const int* open) {
    ::close(*open);
    delete open;
  };
  file.descriptor_ = std::shared_ptr<const int>(new int(descriptor), close);
  struct stat status = {};
  if (::fstat(descriptor, &status) != 0) return unread(file.name_, errno);
  if (S_ISDIR(status.st_mode)) return Error{file.name_, "is a directory"};
  if (!S_ISREG(status.st_mode)) return Error{file.name_, "is not a file"};
  file.size_ = std::size_t(status.st_size);
  return file;
}

Expected<Done> PlacedReader::read(std::size_t offset, std::size_t bytes, void* to) const {
  char* at = static_cast<char*>(to);
  while (bytes > 0) {
    const ssize_t got = ::pread(*descriptor_, at, bytes, off_t(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unread(name_, errno);
    if (got == 0) return Error{name_, "cannot be read to its end: it has changed meanwhile"};
    at += got, offset += std::size_t(got), bytes -= std::size_t(got);
  }
  return Done{};
}

}  // namespace mien
