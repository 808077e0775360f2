#include "render/image/oiio/descriptor_proxy.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace mien {

DescriptorProxy::DescriptorProxy(int descriptor, bool stream)
    : IOProxy("", Write), descriptor_(descriptor), stream_(stream) {}

bool DescriptorProxy::seek(int64_t offset) {
  if (stream_ && offset != m_pos) {
    failure_ = failure_ ? failure_ : ESPIPE;
    return false;
  }
  m_pos = offset;
  return true;
}

size_t DescriptorProxy::read(void* buffer, size_t size) {
  const size_t got = pread(buffer, size, m_pos);
  m_pos += int64_t(got);
  return got;
}

size_t DescriptorProxy::write(const void* buffer, size_t size) {
  const size_t put = pwrite(buffer, size, m_pos);
  m_pos += int64_t(put);
  return put;
}

size_t DescriptorProxy::pread(void* buffer, size_t size, int64_t offset) {
  size_t got = 0;
  while (got < size) {
    const ssize_t now =
        ::pread(descriptor_, static_cast<char*>(buffer) + got, size - got, offset + int64_t(got));
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) break;
    got += size_t(now);
  }
  return got;
}

size_t DescriptorProxy::pwrite(const void* buffer, size_t size, int64_t offset) {
  size_t put = 0;
  while (put < size && !failure_) {
    const char* from = static_cast<const char*>(buffer) + put;
    const ssize_t now = stream_ ? ::write(descriptor_, from, size - put)
                                : ::pwrite(descriptor_, from, size - put, offset + int64_t(put));
    if (now > 0)
      put += size_t(now);
    else if (now == 0)
      failure_ = EIO;
    else if (errno != EINTR)
      failure_ = errno;
  }
  return put;
}

size_t DescriptorProxy::size() const {
  struct stat info;
  return !stream_ && ::fstat(descriptor_, &info) == 0 ? size_t(info.st_size) : size_t(m_pos);
}

}  // namespace mien
