#pragma once
// A folder as a web server sees it: paths of addresses, and the files that they stand for.

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

namespace mien::command {

/// A file to be sent, and what browsers have to be told that it is.
struct WebFile {
  std::filesystem::path path;
  std::string_view type;  ///< "application/wasm"
};

/// The path that is meant instead: a folder's, with its slash.
struct Elsewhere {
  std::string path;
};

enum class NoFile { missing, forbidden };

class WebFolder {
 public:
  explicit WebFolder(const std::filesystem::path& root);

  /// What a path stands for, which is decoded already and may be anything. Files outside of the folder are forbidden,
  /// whether dots or symbolic links lead to them.
  std::variant<WebFile, Elsewhere, NoFile> at(std::string_view path) const;

 private:
  std::filesystem::path root_;  ///< without symbolic links
};

}  // namespace mien::command
