#pragma once
// Which files a command line reads and writes, and whether one would destroy another.

#include "tools/mien/cli/command_line.h"

#include <mien/expected.h>

#include <string>
#include <vector>

namespace mien::command {

/// A file, and what the command line calls it: "--manifest", "TABLE".
struct FileRole {
  /// Of a file that is written; `looked_after`: the command itself tells early whether it can be.
  enum class Kind { data, picture, looked_after };

  std::string what, path;
  Kind kind = Kind::data;
};

struct FileRoles {
  std::vector<FileRole> read, written;
};

/// Files that a command reads and writes; "-" and words that are no files do not count.
FileRoles file_roles(const CommandLine& line);

/// An error if a file that is written is one that is read, or written twice. Files are told apart by what they are,
/// not by their names: links lead to the same file. Devices and pipes do not count. An error, too, if a picture's name
/// tells no format.
Expected<Done> check_file_roles(const FileRoles& roles);

/// An error if a file could not be written where it is to be, or a picture would go to a terminal: before the work, not
/// after it.
Expected<Done> check_places(const FileRoles& roles);

}  // namespace mien::command
