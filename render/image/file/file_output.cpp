#include "render/image/file/file_output.h"
#include <mien/limits.h>
#include "lib/base/monotonic_seconds.h"
#include "render/image/file/system_error.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace mien {
namespace {

/// What a pipe takes at once when it takes anything.
constexpr std::size_t kAtOnce = 4096;

constexpr double kReaderComes = 1.0;  // [s] that a pipe without a reader is waited for

/// Until a stream takes bytes. Throws Stopped.
void wait_for(int descriptor) {
  pollfd waits{descriptor, POLLOUT, 0};
  while (::poll(&waits, 1, 20) == 0) end_if_stopped();
}

}  // namespace

Expected<int> open_stream(const std::filesystem::path& path) {
  const double began = monotonic_seconds();
  int descriptor = -1;
  do {
    descriptor = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0 || errno != ENXIO) break;
    end_if_stopped();
    ::poll(nullptr, 0, 10);
  } while (monotonic_seconds() - began < kReaderComes);
  if (descriptor < 0) {
    const int failed = errno;
    if (failed == ENXIO && std::filesystem::is_fifo(path))
      return Error{"", "is a pipe that nobody reads"};
    return Error{"", "cannot be written: " + system_error(failed)};
  }
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return descriptor;
}

ClosedInTheEnd::~ClosedInTheEnd() {
  ::close(descriptor);
}

bool FileOutput::write(const void* data, std::size_t size) {
  if (memory_) {
    const auto* const bytes = static_cast<const std::byte*>(data);
    memory_->insert(memory_->end(), bytes, bytes + size);
    return true;
  }
  const char* from = static_cast<const char*>(data);
  while (size > 0 && !failure_) {
    if (stream_) wait_for(descriptor_);
    const ssize_t put = ::write(descriptor_, from, stream_ ? std::min(size, kAtOnce) : size);
    if (put > 0)
      from += put, size -= std::size_t(put);
    else if (put == 0)
      fail(EIO);
    else if (errno != EINTR)
      fail(errno);
  }
  return !failure_;
}

}  // namespace mien
