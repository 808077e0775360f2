#include <mien/obj.h>

#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"

#include <fmt/format.h>

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <cmath>
#include <string>
#include <string_view>
#include "lib/base/from_chars.h"

namespace mien {
namespace {

constexpr std::size_t kMostBytes = std::size_t(1) << 30;

std::string_view next_word(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return line = {};
  line.remove_prefix(begin);
  const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
  line.remove_prefix(word.size());
  return word;
}

/// The parser takes anything that is no number for 0, so points are checked here first.
Expected<Done> check_points(std::string_view text, const std::string& name) {
  long number = 1, points = 0;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = end + 1;
    if (next_word(line) != "v") continue;
    ++points;
    for (int axis = 0; axis < 3; ++axis) {
      std::string_view word = next_word(line);
      if (word.starts_with('+')) word.remove_prefix(1);
      double value = 0;
      const auto [stop, failed] = from_chars(word.data(), word.data() + word.size(), value);
      if (failed != std::errc{} || stop != word.data() + word.size() || !std::isfinite(value))
        return Error{fmt::format("{}:{}", name, number),
                     fmt::format("expected three finite numbers, got {}", in_quotes(word))};
    }
  }
  if (points == 0) return Error{name, "has no points: it is not an OBJ file"};
  return Done{};
}

}  // namespace

Expected<Mesh> read_obj(const std::filesystem::path& path) {
  const auto text = read_bytes(path, kMostBytes);
  if (!text) return text.error();
  return read_obj_text(*text, path.string());
}

Expected<Mesh> read_obj_text(std::string_view text, std::string_view path) {
  const std::string name = one_line(path);
  if (auto checked = check_points(text, name); !checked) return checked.error();
  tinyobj::ObjReader reader;
  tinyobj::ObjReaderConfig how;
  how.triangulate = true;
  if (!reader.ParseFromString(std::string{text}, "", how))
    return Error{name, fmt::format("cannot be read: {}", one_line(reader.Error()))};
  Mesh mesh;
  const auto& numbers = reader.GetAttrib().vertices;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    mesh.points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  for (const tinyobj::shape_t& shape : reader.GetShapes())
    for (std::size_t i = 0; i + 2 < shape.mesh.indices.size(); i += 3) {
      std::array<int, 3> triangle;
      for (std::size_t c = 0; c < 3; ++c) {
        triangle[c] = shape.mesh.indices[i + c].vertex_index;
        if (triangle[c] < 0 || std::size_t(triangle[c]) >= mesh.points.size())
          return Error{name, fmt::format("a face names point {}, and there are {}", triangle[c] + 1,
                                         mesh.points.size())};
      }
      mesh.triangles.push_back(triangle);
    }
  return mesh;
}

Expected<Done> check_fits(const Mesh& neutral, const Mesh& target,
                          const std::filesystem::path& path) {
  if (neutral.points.size() == target.points.size()) return Done{};
  return Error{one_line(path.string()), fmt::format("has {} points, but the neutral mesh has {}",
                                                    target.points.size(), neutral.points.size())};
}

}  // namespace mien
