#include "tools/mien/film/finished_frame.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

namespace mien::command {
namespace {

/// CRC-32 as PNG has it (ISO 3309).
std::uint32_t checksum(std::string_view bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> t{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int k = 0; k < 8; ++k) c = c & 1 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
      t[n] = c;
    }
    return t;
  }();
  std::uint32_t c = ~0u;
  for (const char byte : bytes) c = table[(c ^ static_cast<unsigned char>(byte)) & 0xff] ^ (c >> 8);
  return ~c;
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

}  // namespace

bool is_finished_frame(const std::filesystem::path& path, std::string_view recipe) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return false;
  const std::string all{std::istreambuf_iterator<char>(in), {}};
  std::string_view left = all;
  if (!left.starts_with("\x89PNG\r\n\x1a\n")) return false;
  left.remove_prefix(8);
  bool described = false;
  const std::string wanted = std::string("Description") + '\0' + std::string(recipe);
  while (left.size() >= 12) {
    const std::size_t length = number_at(left, 0);
    if (left.size() < 12 + length) return false;
    const std::string_view type = left.substr(4, 4), data = left.substr(8, length);
    if (checksum(left.substr(4, 4 + length)) != number_at(left, 8 + length)) return false;
    if (type == "tEXt" && data == wanted) described = true;
    left.remove_prefix(12 + length);
    if (type == "IEND") return left.empty() && described;
  }
  return false;
}

}  // namespace mien::command
