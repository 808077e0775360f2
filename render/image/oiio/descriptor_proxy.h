#pragma once
// An open file as OpenImageIO's writers want it.

#include <OpenImageIO/filesystem.h>

namespace mien {

/// Writes go to the descriptor at once, unbuffered, so that the first failure is known with its
/// reason and nothing is left to fail at closing. The descriptor stays the caller's and stays open.
class DescriptorProxy final : public OIIO::Filesystem::IOProxy {
 public:
  /// `stream`: a pipe or the like, which takes bytes in order only.
  DescriptorProxy(int descriptor, bool stream);

  const char* proxytype() const override { return "descriptor"; }
  bool seek(int64_t offset) override;
  size_t read(void* buffer, size_t size) override;
  size_t write(const void* buffer, size_t size) override;
  size_t pread(void* buffer, size_t size, int64_t offset) override;
  size_t pwrite(const void* buffer, size_t size, int64_t offset) override;
  size_t size() const override;

  /// errno's value of the first failure, or 0.
  int failure() const { return failure_; }

 private:
  int descriptor_;
  bool stream_;
  int failure_ = 0;
};

}  // namespace mien
