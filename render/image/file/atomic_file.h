#pragma once
// A file that appears whole or not at all.
//
//   auto file = AtomicFile::begin("out/a.png");      // opens out/.mien-0f3c….part, locked
//   … write to file->descriptor() …
//   auto done = file->commit();                     // to the disk, then out/a.png in one step
//
// Without commit the temporary goes and the old file stays. A killed run leaves its temporary
// behind, unlocked: the next file begun in that folder removes it.

#include <mien/expected.h>

#include <filesystem>

namespace mien {

/// How temporaries are called: kPrefix, 16 hexadecimal digits, kSuffix.
struct TemporaryName {
  static constexpr char kPrefix[] = ".mien-";
  static constexpr char kSuffix[] = ".part";
  static constexpr int kDigits = 16;
};

class AtomicFile {
 public:
  /// `path` must not be a symbolic link (see target.h). First clears the folder of leftovers.
  static Expected<AtomicFile> begin(const std::filesystem::path& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// Open for reading and writing, empty.
  int descriptor() const { return descriptor_; }
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Flushes to the disk, takes the target's name, flushes the folder. On an error the old file is
  /// as it was.
  Expected<Done> commit();

 private:
  AtomicFile(std::filesystem::path path, std::filesystem::path temporary);
  bool open();
  void abandon();

  std::filesystem::path path_, temporary_;
  int descriptor_ = -1;
};

/// Removes the temporaries in a folder that no running process holds a lock on.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace mien
