#include "tools/mien/studio/web_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace mien::command {
namespace {

namespace fs = std::filesystem;

std::string_view type_of(const fs::path& file) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kFileTypes{{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".wasm", "application/wasm"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".md", "text/markdown; charset=utf-8"},
      {".ts", "text/plain; charset=utf-8"},
      {".txt", "text/plain; charset=utf-8"},
  }};
  const std::string ending = file.extension();
  for (const auto& [known, type] : kFileTypes)
    if (ending == known) return type;
  return "application/octet-stream";
}

bool is_inside(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

}  // namespace

WebFolder::WebFolder(const fs::path& root) {
  std::error_code missing;
  root_ = fs::canonical(root, missing);
}

std::variant<WebFile, Elsewhere, NoFile> WebFolder::at(std::string_view path) const {
  if (!path.starts_with('/') || path.find('\0') != path.npos) return NoFile::missing;
  const fs::path below = fs::path(path).relative_path();
  if (std::ranges::find(below, "..") != below.end()) return NoFile::forbidden;
  std::error_code failed;
  fs::path found = fs::canonical(root_ / below, failed);
  if (failed || root_.empty()) return NoFile::missing;
  if (!is_inside(found, root_)) return NoFile::forbidden;
  if (fs::is_directory(found, failed)) {
    if (!path.ends_with('/')) return Elsewhere{fmt::format("/{}/", below.generic_string())};
    found /= "index.html";
    // The package's own folder has no page: the studio is what people come for.
    if (below.empty() && !fs::exists(found, failed)) return Elsewhere{"/studio/"};
  }
  if (!fs::is_regular_file(found, failed)) return NoFile::missing;
  return WebFile{found, type_of(found)};
}

}  // namespace mien::command
