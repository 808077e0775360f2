#include "lib/file/json/json_text.h"
#include "lib/picture/color_text.h"
#include "lib/picture/srgb.h"
#include "written_slice_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {
namespace {

using Channels = std::array<double, 4>;  ///< of a colour, as files say them: 0 … 255

/// The channel, 0 … 255, that reads back as `linear` light; where none does, the nearest.
double encoded_channel(double linear) {
  const double nearest = 255 * srgb_from_linear(linear), whole = std::round(nearest);
  const auto is_it = [&](double c) { return linear_from_srgb(c / 255) == linear; };
  if (is_it(whole)) return whole;
  constexpr int kReach = 8;  // roundings that both powers make together
  double below = nearest, above = nearest;
  for (int i = 0; i < kReach; ++i) {
    if (is_it(below)) return below;
    if (is_it(above)) return above;
    below = std::nextafter(below, 0.0), above = std::nextafter(above, 255.0);
  }
  return nearest;
}

/// "#rrggbb" or "#rrggbbaa", in quotes, if it is exactly that colour.
std::optional<std::string> quoted_hex(const Channels& channels, std::span<const double> color) {
  std::string text = "#";
  for (const double channel : channels)
    if (text.size() < 7 || channel != 255) text += fmt::format("{:02x}", int(std::lround(channel)));
  const std::optional<Color> back = color_from_text(text);
  const bool same = back && std::equal(color.begin(), color.end(),
                                       std::array{back->r, back->g, back->b, back->a}.begin());
  return same ? std::optional("\"" + text + "\"") : std::nullopt;
}

void write_color(const JsonNode& node, std::span<const double> color, TextEdits& to) {
  const Channels channels{encoded_channel(color[0]), encoded_channel(color[1]),
                          encoded_channel(color[2]), 255 * color[3]};
  if (node.kind == JsonKind::string)
    if (const auto hex = quoted_hex(channels, color)) return to.replace(node.offset, *hex);
  std::string list;
  for (std::size_t i = 0; i < (color[3] == 1 ? 3 : 4); ++i)
    list += (i == 0 ? "[" : ", ") + json_number(channels[i]);
  to.replace(node.offset, list + "]");
}

void write_number(const JsonNode& node, double value, TextEdits& to) {
  if (node.number != value) to.replace(node.offset, json_number(value));
}

}  // namespace

std::optional<std::vector<double>> written_mirrored(SliceKind kind, std::span<const double> values,
                                                    double twice_axis) {
  std::vector<double> written(values.begin(), values.end());
  mirror_values(kind, written, twice_axis);
  std::vector<double> back = written;
  mirror_values(kind, back, twice_axis);
  if (!std::equal(back.begin(), back.end(), values.begin())) return {};
  return written;
}

void write_slice(const JsonTree& tree, const JsonNode& node, const Slice& slice,
                 std::span<const double> values, TextEdits& to) {
  if (slice.kind == SliceKind::color) return write_color(node, values, to);
  if (node.kind == JsonKind::number) return write_number(node, values[0], to);
  const JsonNode* one = tree.first(node);
  for (const double value : values) {
    write_number(one->kind == JsonKind::array ? *tree.first(*one) : *one, value, to);  // of a stop
    one = tree.next(*one);
  }
}

}  // namespace mien
