#pragma once
#include <mien/expected.h>

#include <dirent.h>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace mien {

/// What is in a folder, in any order, without "." and "..". The iterators of the standard library of GCC 12 end the
/// program where memory runs out; this throws std::bad_alloc.
/// Here, so that no library has to export it.
inline Expected<std::vector<std::string>> folder_names(const std::filesystem::path& folder) {
  struct Close {
    void operator()(DIR* open) const { ::closedir(open); }
  };
  errno = 0;
  const std::unique_ptr<DIR, Close> open(::opendir(folder.c_str()));
  std::vector<std::string> names;
  while (const dirent* const entry = open ? ::readdir(open.get()) : nullptr) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
    errno = 0;
  }
  if (const int failed = errno)
    return Error{folder.string(), std::generic_category().message(failed)};
  return names;
}

}  // namespace mien
