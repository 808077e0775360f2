#pragma once
#include <string>

namespace mien {

/// What the operating system says an errno value means: "No space left on device".
std::string system_error(int code);

}  // namespace mien
