#include "tools/mien/http/http_answer.h"

namespace mien::command {

HttpAnswer told(int code, const std::string& sentence) {
  return {code,
          {{"Content-Type", "text/plain; charset=utf-8"}, {"Cache-Control", "no-store"}},
          std::make_shared<const std::string>(sentence + "\n")};
}

}  // namespace mien::command
