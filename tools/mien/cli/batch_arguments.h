#pragma once
// What people typed after `mien batch` and `mien join`.

#include <optional>
#include <string>

namespace mien::command {

struct BatchArguments {
  std::string plan, output;  ///< a file, a folder
  std::optional<std::string> part;
};

struct JoinArguments {
  std::string plan, folder;
};

}  // namespace mien::command
