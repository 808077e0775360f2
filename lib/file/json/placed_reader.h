#pragma once
// Bytes from any place of a file. A read that fails is an error with its reason; a stream's would pass for an end.
//
//   const auto file = PlacedReader::open("a.basis");
//   if (auto done = file->read(128, sizeof header, &header); !done) return done.error();

#include <mien/expected.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace mien {

class PlacedReader {
 public:
  /// Errors name the file, also if it is a directory or a pipe.
  static Expected<PlacedReader> open(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  /// As it was opened.
  std::size_t size() const { return size_; }
  /// All of these bytes, or an error that names the file. Threads may read at once.
  Expected<Done> read(std::size_t offset, std::size_t bytes, void* to) const;

 private:
  std::shared_ptr<const int> descriptor_;
  std::string name_;
  std::size_t size_ = 0;
};

}  // namespace mien
