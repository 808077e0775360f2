#include "render/image/file/atomic_file.h"
#include "lib/base/folder_names.h"
#include "render/image/file/output_path.h"
#include "render/image/file/system_error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <random>
#include <string_view>
#include <utility>

namespace mien {
namespace fs = std::filesystem;

namespace {

constexpr int kMostTries =
    100;  // names taken, or swept away before they were locked: neither happens twice in life

std::string new_temporary_name() {
  std::random_device dice;
  const std::uint64_t number = std::uint64_t(dice()) << 32 | dice();
  return fmt::format("{}{:0{}x}{}", TemporaryName::kPrefix, number, TemporaryName::kDigits,
                     TemporaryName::kSuffix);
}

bool is_temporary_name(std::string_view name) {
  constexpr std::string_view prefix = TemporaryName::kPrefix, suffix = TemporaryName::kSuffix;
  if (name.size() != prefix.size() + TemporaryName::kDigits + suffix.size()) return false;
  const std::string_view digits = name.substr(prefix.size(), TemporaryName::kDigits);
  return name.starts_with(prefix) && name.ends_with(suffix) &&
         digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

enum class Named { still, no_longer, unknown };

/// Whether the file open as `descriptor` still goes by that name; errno tells why that is not known.
Named still_named(int descriptor, const fs::path& path) {
  struct stat open_file, named;
  if (::fstat(descriptor, &open_file) != 0) return Named::unknown;
  if (::lstat(path.c_str(), &named) != 0)
    return errno == ENOENT ? Named::no_longer : Named::unknown;
  const bool same = open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino;
  return same ? Named::still : Named::no_longer;
}

/// Removes one temporary unless somebody holds it. Holding its lock ourselves while we do keeps
/// away a run that has just created it and not locked it yet: that run sees its file gone and takes
/// another name.
void remove_leftover(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat info;
  const bool ours = ::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode);
  if (ours && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
      still_named(descriptor, path) == Named::still)
    ::unlink(path.c_str());
  ::close(descriptor);
}

/// 0, or errno's value. File systems that cannot flush say EINVAL, which is no failure of the file.
int flush(int descriptor) {
  int failed = 0;
  do failed = ::fsync(descriptor) == 0 ? 0 : errno;
  while (failed == EINTR);
  return failed == EINVAL ? 0 : failed;
}

/// Whatever comes of it, the new file is there and whole. A power cut that comes before its name has reached the disk
/// leaves the old one, whole as well. So a folder that cannot be read or flushed is no failure.
void flush_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  flush(descriptor);
  ::close(descriptor);
}

Error refused(const fs::path& path, const fs::path& folder, const std::string& why) {
  return {path.string(), "cannot write in " + folder.string() + ": " + why};
}

}  // namespace

void remove_leftovers(const fs::path& folder) {
  const auto names = folder_names(folder);
  if (!names) return;  // there is nothing to remove, or it cannot be known
  for (const std::string& name : *names)
    if (is_temporary_name(name)) remove_leftover(folder / name);
}

Expected<AtomicFile> AtomicFile::begin(const fs::path& path) {
  const fs::path folder = folder_of(path);
  remove_leftovers(folder);
  for (int tries = 0; tries < kMostTries; ++tries) {
    AtomicFile file(path, folder / new_temporary_name());
    if (!file.open() && (errno == EEXIST || errno == EINTR)) continue;
    if (file.descriptor_ < 0) return refused(path, folder, system_error(errno));
    // A file system without locks has no sweepers either: they need the lock as well.
    while (::flock(file.descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
    const Named named = still_named(file.descriptor_, file.temporary_);
    if (named == Named::still) return file;
    if (named == Named::unknown) return refused(path, folder, system_error(errno));
  }
  return refused(path, folder, "its temporary files vanish");
}

AtomicFile::AtomicFile(fs::path path, fs::path temporary)
    : path_(std::move(path)), temporary_(std::move(temporary)) {}

bool AtomicFile::open() {
  descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  return descriptor_ >= 0;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() {
  abandon();
}

void AtomicFile::abandon() {
  if (descriptor_ < 0) return;
  ::unlink(temporary_.c_str());
  ::close(std::exchange(descriptor_, -1));
}

Expected<Done> AtomicFile::commit() {
  const auto refuse = [&](int code) {
    abandon();
    return Error{path_.string(), "cannot be written: " + system_error(code)};
  };
  if (const int failed = flush(descriptor_)) return refuse(failed);
  // Once the name is taken nothing may fail, memory for a path neither.
  const fs::path folder = folder_of(path_);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) return refuse(errno);
  flush_folder(folder);
  ::close(std::exchange(descriptor_, -1));
  return Done{};
}

}  // namespace mien
