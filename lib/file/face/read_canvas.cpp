// The picture's frame and the colours of a face file.

#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/picture/color_text.h"
#include "lib/picture/srgb.h"

#include <fmt/format.h>

#include <array>

namespace mien {
namespace {

constexpr double kLeastCanvas = 1e-9;  ///< sides shorter than this lose their pixels to rounding
constexpr double kMostAspect = 1e6;

Color read_color(const Reading& in, const JsonNode& node) {
  if (node.kind == JsonKind::string) {
    const std::optional<Color> color = color_from_text(in.string(node));
    if (!color)
      in.refuse(node, fmt::format("expected a colour like \"#rrggbb\", got {}",
                                  in_quotes(in.string(node))));
    return *color;
  }
  const std::vector<double> c = in.numbers(node, 3, 4);
  for (const double channel : c)
    if (!(channel >= 0 && channel <= 255))
      in.refuse(node, fmt::format("a colour's channels go from 0 to 255, got {}", channel));
  return color_from_srgb255(c[0], c[1], c[2], c.size() == 4 ? c[3] : 255);
}

}  // namespace

void read_canvas(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect_object(node, {"x", "y", "y_axis", "mirror_x", "unit"});
  FaceCanvas& canvas = face.model.canvas;
  const auto [left, right] = in.range(in.need(node, "x"));
  const auto [low, high] = in.range(in.need(node, "y"));
  const double width = right - left, height = high - low;
  if (width < kLeastCanvas || height < kLeastCanvas)
    in.refuse(node, fmt::format("a canvas must be at least {} wide and high", kLeastCanvas));
  if (width > kMostAspect * height || height > kMostAspect * width)
    in.refuse(node,
              fmt::format("a canvas must not be more than {} times longer than wide", kMostAspect));
  canvas.box = {{left, low}, {right, high}};
  constexpr std::array<std::string_view, 2> kAxes{"up", "down"};
  canvas.y_up = in.word(in.need(node, "y_axis"), "y_axis", kAxes) == 0;
  canvas.mirror_x = 0.5 * (left + right);
  if (const JsonNode* axis = in.find(node, "mirror_x")) canvas.mirror_x = in.number(*axis);
  if (const JsonNode* unit = in.find(node, "unit")) canvas.unit = one_line(in.string(*unit), 60);
}

void read_palette(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::object);
  in.for_each(node, [&](const JsonNode& child, int) {
    if (in.tree.key(child) == "comment") return;
    const std::string_view name = in.checked_name(child, in.tree.key(child));
    const Color c = read_color(in, child);
    face.add_slice(in, child, {"palette/", name}, SliceKind::color, std::array{c.r, c.g, c.b, c.a});
  });
}

int read_paint(Reading& in, const JsonNode& node, const FaceDraft& face) {
  const std::string_view name = in.string(node);
  constexpr std::string_view kPalette = "palette/";
  const int found = face.find_slice_of("palette", name);
  if (found >= 0) return found;
  std::vector<std::string_view> known;
  for (const Slice& slice : face.model.layout.slices())
    if (slice.name.starts_with(kPalette)) known.push_back(slice.name.substr(kPalette.size()));
  in.refuse(node, unknown_name("palette colour", name, known));
}

}  // namespace mien
