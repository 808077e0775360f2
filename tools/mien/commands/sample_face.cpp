#include "tools/mien/commands/sample_face.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

namespace mien::command {

std::string sample_face_path(const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const bool name = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
  if (!name || fs::exists(fs::symlink_status(text, failed))) return text;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const char* folder : {"../share/mien/faces", "../../faces"}) {
    const fs::path face = (program / folder / (text + ".face.json")).lexically_normal();
    if (fs::is_regular_file(face, failed)) return face.string();
  }
  return text;
}

}  // namespace mien::command
