#pragma once
#include <string>

namespace mien {

/// What an errno value means, in the words of the operating system: "No space left on device".
std::string system_error(int code);

}  // namespace mien
