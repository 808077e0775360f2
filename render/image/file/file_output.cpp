#include "render/image/file/file_output.h"

#include <unistd.h>

#include <cerrno>

namespace mien {

bool FileOutput::write(const void* data, std::size_t size) {
  const char* from = static_cast<const char*>(data);
  while (size > 0 && !failure_) {
    const ssize_t put = ::write(descriptor_, from, size);
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
