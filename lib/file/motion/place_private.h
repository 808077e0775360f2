#pragma once

#include <functional>
#include <string>

namespace mien {

/// Where something stands in its file, "FILE:LINE:COLUMN", for an error that asks.
using Place = std::function<std::string()>;

}  // namespace mien
