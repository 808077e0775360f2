#include "head_matrix_private.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mien {
namespace {

constexpr double kDegreesOfRadians = 180 / std::numbers::pi;

/// The matrix itself, inside of lists and objects.
const JsonNode* innermost(const Reading& in, const JsonNode& node) {
  const JsonNode* at = &node;
  for (;;) {
    if (at->kind == JsonKind::object) {
      const JsonNode* data = in.find(*at, "data");
      if (!data) data = &in.need(*at, "packedData");
      at = data;
      continue;
    }
    in.expect(*at, JsonKind::array);
    const JsonNode* first = in.tree.first(*at);
    if (!first) return nullptr;
    const bool rows = at->count == 4 && first->kind == JsonKind::array && first->count == 4;
    if (first->kind == JsonKind::number || rows) return at;
    at = first;
  }
}

/// 16 numbers by rows.
std::vector<double> rows_of(const Reading& in, const JsonNode& matrix) {
  std::vector<double> m;
  if (matrix.count != 4) {
    m = in.numbers(matrix, 16, 16);
    // The bottom row, 0 0 0 1, tells whether they come by columns.
    if (m[12] != 0 || m[13] != 0 || m[14] != 0)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) std::swap(m[4 * i + j], m[4 * j + i]);
    return m;
  }
  in.for_each(matrix, [&](const JsonNode& row, int) {
    const std::vector<double> four = in.numbers(row, 4, 4);
    m.insert(m.end(), four.begin(), four.end());
  });
  return m;
}

}  // namespace

std::optional<HeadAngles> head_turn_of(const Reading& in, const JsonNode& node) {
  const JsonNode* matrix = innermost(in, node);
  if (!matrix) return {};
  const std::vector<double> m = rows_of(in, *matrix);
  const auto at = [&](std::size_t row, std::size_t column) { return m[4 * row + column]; };
  const double scale = std::hypot(at(0, 2), at(1, 2), at(2, 2));
  if (!(scale > 0 && std::isfinite(scale))) in.refuse(*matrix, "this matrix turns nothing");
  return HeadAngles{std::atan2(at(0, 2), at(2, 2)) * kDegreesOfRadians,
                    std::asin(std::clamp(at(1, 2) / scale, -1.0, 1.0)) * kDegreesOfRadians,
                    std::atan2(at(1, 0), at(1, 1)) * kDegreesOfRadians};
}

}  // namespace mien
