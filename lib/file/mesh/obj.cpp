#include <mien/obj.h>
#include "lib/base/memory_ran_out.h"

#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"

#include <fmt/format.h>

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
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

/// What a line says, without its comment, and with the lines that a backslash continues it by.
class Lines {
 public:
  explicit Lines(std::string_view text) : left_(text) {
    if (left_.starts_with("\xEF\xBB\xBF")) left_.remove_prefix(3);
  }

  /// The next one; false at the end.
  bool next() {
    if (left_.empty()) return false;
    line_.clear();
    first_ = number_ + 1;
    for (bool more = true; more && !left_.empty();) {
      std::string_view one = physical();
      const std::size_t comment = one.find('#');
      one = one.substr(0, comment);
      const std::size_t last = one.find_last_not_of(" \t");
      more =
          comment == std::string_view::npos && last != std::string_view::npos && one[last] == '\\';
      line_ += more ? one.substr(0, last) : one;
      line_ += ' ';
    }
    return true;
  }
  std::string_view line() const { return line_; }
  long number() const { return first_; }

 private:
  /// Ends with "\n", "\r\n" or an old Mac's "\r".
  std::string_view physical() {
    const std::size_t end = std::min(left_.find_first_of("\r\n"), left_.size());
    const std::string_view one = left_.substr(0, end);
    left_.remove_prefix(end);
    left_.remove_prefix(left_.starts_with("\r\n") ? 2 : left_.empty() ? 0 : 1);
    ++number_;
    return one;
  }

  std::string_view left_;
  std::string line_;
  long number_ = 0, first_ = 0;
};

/// Points and faces as an OBJ file says them, checked: the library takes what is no number for 0, and lets numbers
/// wrap.
struct Polygons {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::int64_t>> faces;  ///< of points, counted from 0
  std::vector<long> lines;                       ///< of faces
};

Expected<glm::dvec3> read_point(std::string_view line) {
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    std::string_view word = next_word(line);
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [stop, failed] = from_chars(word.data(), word.data() + word.size(), point[axis]);
    if (failed != std::errc{} || stop != word.data() + word.size() || !std::isfinite(point[axis]))
      return Error{"", fmt::format("expected three finite numbers, got {}", in_quotes(word))};
  }
  return point;
}

/// The point of "3", "3/1", "3//2" or "-1/-1/-1"; none: another word.
std::optional<std::int64_t> corner(std::string_view word) {
  std::optional<std::int64_t> point;
  for (int i = 0; i < 3; ++i) {
    const std::string_view index = word.substr(0, word.find('/'));
    std::int64_t value = 0;
    const auto [stop, failed] = std::from_chars(index.data(), index.data() + index.size(), value);
    const bool whole = failed == std::errc{} && stop == index.data() + index.size() && value != 0;
    if (!whole && (i == 0 || !index.empty())) return {};
    if (i == 0) point = value;
    if (index.size() == word.size()) return point;
    word.remove_prefix(index.size() + 1);
  }
  return {};
}

Expected<std::vector<std::int64_t>> read_polygon(std::string_view line, std::size_t points) {
  std::vector<std::int64_t> face;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    const auto index = corner(word);
    if (!index)
      return Error{"",
                   fmt::format("expected a corner of a face like 3, 3/1 or 3//2, counted from 1, "
                               "got {}",
                               in_quotes(word))};
    face.push_back(*index > 0 ? *index - 1 : std::int64_t(points) + *index);
    if (face.back() < 0)
      return Error{
          "", fmt::format("a face names point {}, and there are {} before it", *index, points)};
  }
  if (face.size() < 3)
    return Error{"", fmt::format("a face of {} points; it has 3 or more", face.size())};
  return face;
}

Expected<Polygons> read_polygons(std::string_view text, const std::string& name) {
  Polygons all;
  for (Lines lines(text); lines.next();) {
    std::string_view line = lines.line();
    const std::string_view what = next_word(line);
    const auto at = [&](const Error& wrong) {
      return Error{fmt::format("{}:{}", name, lines.number()), wrong.what};
    };
    if (what == "v") {
      const auto point = read_point(line);
      if (!point) return at(point.error());
      all.points.push_back(*point);
    } else if (what == "f") {
      auto face = read_polygon(line, all.points.size());
      if (!face) return at(face.error());
      all.faces.push_back(*std::move(face));
      all.lines.push_back(lines.number());
    }
  }
  if (all.points.empty()) return Error{name, "has no points: it is not an OBJ file"};
  for (std::size_t i = 0; i < all.faces.size(); ++i)
    for (const std::int64_t point : all.faces[i])
      if (std::size_t(point) >= all.points.size())
        return Error{
            fmt::format("{}:{}", name, all.lines[i]),
            fmt::format("a face names point {}, and there are {}", point + 1, all.points.size())};
  return all;
}

/// The polygons alone, as the library reads them.
std::string text_of_polygons(const Polygons& all) {
  std::string text;
  for (const glm::dvec3& p : all.points)
    fmt::format_to(std::back_inserter(text), "v {:.17g} {:.17g} {:.17g}\n", p.x, p.y, p.z);
  for (const auto& face : all.faces) {
    text += 'f';
    for (const std::int64_t point : face)
      fmt::format_to(std::back_inserter(text), " {}", point + 1);
    text += '\n';
  }
  return text;
}

}  // namespace

Expected<Mesh> read_obj(const std::filesystem::path& path) try {
  const auto text = read_bytes(path, kMostBytes);
  if (!text) return text.error();
  return read_obj_text(*text, path.string());
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

Expected<Mesh> read_obj_text(std::string_view text, std::string_view path) try {
  const std::string name = one_line(path);
  auto polygons = read_polygons(text, name);
  if (!polygons) return polygons.error();
  tinyobj::ObjReader reader;
  tinyobj::ObjReaderConfig how;
  how.triangulate = true;
  if (!reader.ParseFromString(text_of_polygons(*polygons), "", how))
    return Error{name, "its faces cannot be cut into triangles"};
  Mesh mesh;
  mesh.points = std::move(polygons->points);
  for (const tinyobj::shape_t& shape : reader.GetShapes())
    for (std::size_t i = 0; i + 2 < shape.mesh.indices.size(); i += 3) {
      std::array<int, 3> triangle;
      for (std::size_t c = 0; c < 3; ++c) triangle[c] = shape.mesh.indices[i + c].vertex_index;
      mesh.triangles.push_back(triangle);
    }
  return mesh;
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<Done> check_fits(const Mesh& neutral, const Mesh& target,
                          const std::filesystem::path& path) try {
  if (neutral.points.size() == target.points.size()) return Done{};
  return Error{one_line(path.string()), fmt::format("has {} points, but the neutral mesh has {}",
                                                    target.points.size(), neutral.points.size())};
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

}  // namespace mien
