#include "tools/mien/cli/named_file.h"

#include <filesystem>

namespace mien::command {

std::pair<std::string, std::string> name_and_file(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos && text.find('/') > equals)
    return {text.substr(0, equals), text.substr(equals + 1)};
  const std::string file = std::filesystem::path(text).filename().string();
  return {file.substr(0, file.find('.')), text};
}

}  // namespace mien::command
