#include "tools/mien/film/wave_file.h"

#include "lib/file/json/placed_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

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

}  // namespace

Expected<std::optional<double>> wave_seconds(const std::string& path) {
  const auto file = PlacedReader::open(path);
  if (!file) return file.error();
  const std::string& name = file->name();
  const std::size_t size = file->size();
  if (size == 0) return Error{name, "is empty"};
  std::array<char, 12> start{};
  const std::string_view words(start.data(), std::min(size, start.size()));
  if (auto done = file->read(0, words.size(), start.data()); !done) return done.error();
  if (!words.starts_with("RIFF")) return std::optional<double>{};
  if (words.size() < 12 || words.substr(8) != "WAVE")
    return Error{name, "begins like a WAV and is none"};
  std::uint32_t bytes_a_second = 0;
  for (std::size_t at = start.size(); at + 8 <= size;) {
    std::array<char, 8> head{};
    if (auto done = file->read(at, head.size(), head.data()); !done) return done.error();
    const Chunk chunk{{head.data(), 4}, number_of(head.data() + 4, 4)};
    at += head.size();
    if (chunk.name == "fmt ") {
      std::array<char, 16> format{};
      if (at + format.size() > size) return Error{name, "its format is cut off"};
      if (auto done = file->read(at, format.size(), format.data()); !done) return done.error();
      bytes_a_second = number_of(format.data() + 8, 4);
    } else if (chunk.name == "data") {
      if (bytes_a_second == 0) return Error{name, "a WAV without a format before its sound"};
      return std::optional(double(std::min<std::size_t>(chunk.size, size - at)) / bytes_a_second);
    }
    at += std::size_t(chunk.size) + chunk.size % 2;
  }
  return Error{name, "a WAV without sound"};
}

}  // namespace mien::command
