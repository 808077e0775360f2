#pragma once
// Where a path given by people really leads.

#include <mien/expected.h>

#include <filesystem>

namespace mien {

/// A place that can be written.
struct OutputPath {
  std::filesystem::path path;  ///< no symbolic link: links are followed, so that they stay links
  bool stream = false;  ///< a device or a pipe: written straight into, as it cannot be replaced
};

/// Follows links (also to files that do not exist yet) and tells beforehand what would fail: a
/// directory, a missing or unwritable folder, a write-protected file. Changes nothing. `where` of
/// the error is `path` as given.
Expected<OutputPath> find_output_path(const std::filesystem::path& path);

/// The folder a file is in, as a path that can be opened.
std::filesystem::path folder_of(const std::filesystem::path& path);

}  // namespace mien
