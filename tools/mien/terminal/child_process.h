#pragma once
// Programs that do a part of the work in a process of their own.

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <vector>

namespace mien::command {

/// Starts the program whose name is the first word, a path or found in PATH. Its standard input, output and error, and
/// what else it is given, are these descriptors; -1 is nothing. It is in a process group of its own: Ctrl-C is for this
/// program only. Returns 0 or an errno.
int start_process(const std::vector<std::string>& words, const std::vector<int>& descriptors,
                  pid_t& id);

/// Waits for its end: the exit code, or -1 where a signal ended it.
int end_of_process(pid_t id);

/// The last line that was written to a file.
std::string last_line(std::FILE* file);

}  // namespace mien::command
