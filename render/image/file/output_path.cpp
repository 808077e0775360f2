#include "render/image/file/output_path.h"
#include "render/image/file/system_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace mien {
namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

namespace {

constexpr int kMostLinks = 40;  // as many as Linux itself follows

/// The path at the end of a chain of links, which need not exist; errno's value when the chain has
/// no end.
int follow(fs::path& path) {
  for (int links = 0; links < kMostLinks; ++links) {
    std::error_code failed;
    const fs::path next = fs::read_symlink(path, failed);
    if (failed) return 0;
    path = next.is_absolute() ? next : folder_of(path) / next;
  }
  return ELOOP;
}

}  // namespace

Expected<OutputPath> find_output_path(const fs::path& given) {
  const auto refuse = [&](const std::string& what) { return Error{given.string(), what}; };
  if (given.empty()) return Error{"", "the output's name is empty"};

  struct stat info;
  const bool exists = ::stat(given.c_str(), &info) == 0;
  if (!exists && errno != ENOENT) return refuse("cannot be written: " + system_error(errno));
  if (exists && S_ISDIR(info.st_mode)) return refuse("is a directory, not a file");
  if (!given.has_filename()) return refuse("names a directory, not a file");
  if (exists && ::faccessat(AT_FDCWD, given.c_str(), W_OK, AT_EACCESS) != 0) {
    return refuse("is write-protected: " + system_error(errno));
  }
  if (exists && !S_ISREG(info.st_mode)) return OutputPath{given, true};

  fs::path end = given;
  if (const int failed = follow(end)) return refuse("cannot be written: " + system_error(failed));
  const fs::path folder = folder_of(end);
  if (::stat(folder.c_str(), &info) != 0)
    return refuse("its folder " + folder.string() + ": " + system_error(errno));
  if (!S_ISDIR(info.st_mode)) return refuse(folder.string() + " is not a folder");
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    return refuse("its folder " + folder.string() + " cannot be written: " + system_error(errno));
  }
  return OutputPath{end, false};
}

}  // namespace mien
