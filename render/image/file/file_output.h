#pragma once
// Bytes into an open file or into memory, in order.

#include <mien/expected.h>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace mien {

/// Closes a file in the end, also where something is thrown.
struct ClosedInTheEnd {
  int descriptor;
  explicit ClosedInTheEnd(int open) : descriptor(open) {}
  ClosedInTheEnd(const ClosedInTheEnd&) = delete;
  ~ClosedInTheEnd();
};

/// Opens a pipe or a device to be written to; an error without an address, also where nobody reads from the pipe.
Expected<int> open_stream(const std::filesystem::path& path);

/// Writes go to the descriptor at once, unbuffered, so that the first failure is known with its
/// reason. The descriptor stays the caller's and stays open.
class FileOutput {
 public:
  /// `stream`: a pipe or the like, which takes bytes in order only.
  FileOutput(int descriptor, bool stream) : descriptor_(descriptor), stream_(stream) {}
  /// Into memory, behind what is there: for encoders that go on from byte to byte, as PNG's does. There is no descriptor.
  explicit FileOutput(std::vector<std::byte>& memory)
      : memory_(&memory), descriptor_(-1), stream_(true) {}

  int descriptor() const { return descriptor_; }
  bool stream() const { return stream_; }

  /// Behind what was written before. A pipe that is full is waited for as long as a watch (lib/base/watch.h) lets
  /// this thread. False at the first failure and ever after.
  bool write(const void* data, std::size_t size);

  /// errno's value of the first failure, or 0.
  int failure() const { return failure_; }
  /// For writers that do it themselves.
  void fail(int code) { failure_ = failure_ ? failure_ : code; }

 private:
  std::vector<std::byte>* memory_ = nullptr;
  int descriptor_;
  bool stream_;
  int failure_ = 0;
};

}  // namespace mien
