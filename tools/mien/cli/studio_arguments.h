#pragma once
// What people typed after mien studio.

#include <optional>
#include <string>

namespace mien::command {

struct StudioArguments {
  std::optional<std::string> port, folder;
};

}  // namespace mien::command
