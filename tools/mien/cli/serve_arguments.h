#pragma once
// What people typed after mien serve.

#include <optional>
#include <string>

namespace mien::command {

struct ServeArguments {
  std::optional<std::string> listen, most_size, cache, threads, queue, timeout;
};

}  // namespace mien::command
