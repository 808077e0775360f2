#include "tools/mien/film/wave_file.h"

#include "lib/base/one_line.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace mien::command {
namespace {

/// Numbers in a WAV are little-endian.
std::uint32_t number_of(const char* bytes, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// A part of the file: its name, and how many bytes follow.
struct Chunk {
  std::string_view name;
  std::uint32_t size;
};

std::optional<Chunk> next_chunk(std::ifstream& file, std::array<char, 8>& head) {
  if (!file.read(head.data(), head.size())) return {};
  return Chunk{{head.data(), 4}, number_of(head.data() + 4, 4)};
}

}  // namespace

Expected<std::optional<double>> wave_seconds(const std::string& path) {
  const std::string name = one_line(path);
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed)) return Error{name, "is a directory"};
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{name, "cannot be read: " + std::generic_category().message(errno)};
  std::array<char, 12> start{};
  file.read(start.data(), start.size());
  if (file.gcount() == 0) return Error{name, "is empty"};
  const std::string_view words(start.data(), std::size_t(file.gcount()));
  if (!words.starts_with("RIFF")) return std::optional<double>{};
  if (words.size() < 12 || words.substr(8) != "WAVE")
    return Error{name, "begins like a WAV and is none"};
  std::array<char, 8> head{};
  std::uint32_t bytes_a_second = 0;
  while (const auto chunk = next_chunk(file, head)) {
    const std::streamoff begin = file.tellg();
    if (chunk->name == "fmt ") {
      std::array<char, 16> format{};
      if (!file.read(format.data(), format.size())) return Error{name, "its format is cut off"};
      bytes_a_second = number_of(format.data() + 8, 4);
    } else if (chunk->name == "data") {
      if (bytes_a_second == 0) return Error{name, "a WAV without a format before its sound"};
      file.seekg(0, std::ios::end);
      const double there = double(std::streamoff(file.tellg()) - begin);
      return std::optional(std::min(double(chunk->size), there) / bytes_a_second);
    }
    file.seekg(begin + std::streamoff(chunk->size) + chunk->size % 2);
  }
  return Error{name, "a WAV without sound"};
}

}  // namespace mien::command
