#include "lib/file/json/read_bytes.h"

#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace mien {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Error unreadable(const std::string& name) {
  return {name, fmt::format("cannot be read: {}", std::generic_category().message(errno))};
}

}  // namespace

Expected<std::string> read_bytes(const std::filesystem::path& path, std::size_t most) {
  const std::string name = one_line(path.string());
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return Error{name, "is a directory"};
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) return unreadable(name);
  std::string bytes;
  char block[1 << 16];
  while (const std::size_t got = std::fread(block, 1, sizeof block, file.get())) {
    bytes.append(block, got);
    if (bytes.size() > most)
      return Error{name, fmt::format("longer than {} bytes (limit: bytes)", most)};
  }
  if (std::ferror(file.get())) return unreadable(name);
  return bytes;
}

}  // namespace mien
