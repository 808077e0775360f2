#include "render/image/file/system_error.h"

#include <system_error>

namespace mien {

std::string system_error(int code) {
  return std::generic_category().message(code);
}

}  // namespace mien
