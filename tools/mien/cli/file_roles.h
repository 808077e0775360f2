#pragma once
// Which files a command line reads and writes, and whether one would destroy another.

#include "tools/mien/cli/command_line.h"

#include <mien/expected.h>

#include <string>
#include <vector>

namespace mien::command {

/// A file, and what the command line calls it: "--manifest", "TABLE".
struct FileRole {
  std::string what, path;
};

struct FileRoles {
  std::vector<FileRole> read, written;
};

/// Files that a command reads and writes; "-" and words that are no files do not count.
FileRoles file_roles(const CommandLine& line);

/// An error if a file that is written is one that is read, or written twice. Files are told apart by what they are,
/// not by their names: links lead to the same file. Devices and pipes do not count.
Expected<Done> check_file_roles(const FileRoles& roles);

}  // namespace mien::command
