#include "figure_reader_private.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace mien {
namespace {

/// A kind and its own keys, and after them those of all features.
FigureKind with_all_keys(FigureKind kind) {
  kind.keys.insert(kind.keys.end(),
                   {"paint", "feather", "opacity", "relief", "shadow", "glow", "contour"});
  kind.sided = kind.keys.size();
  kind.keys.insert(kind.keys.end(),
                   {"kind", "name", "side", "mirror", "left", "right", "clip", "group"});
  return kind;
}

}  // namespace

FigureReader::Field FigureReader::field(std::string_view key) const {
  if (instead_)
    if (const JsonNode* found = in_.find(*instead_, key)) return {found, false};
  return {in_.find(node_, key), mirrored_};
}

FigureReader::Field FigureReader::need(std::string_view key) const {
  const Field found = field(key);
  if (!found.node) in_.need(node_, key);
  return found;
}

int FigureReader::slice(std::string_view key, SliceKind kind, int size) {
  const Field f = need(key);
  if (f.node->kind == JsonKind::string) return face_.reference(in_, *f.node, side_, kind, size);
  return add(*f.node, key, kind, size, f.mirrored);
}

int FigureReader::add(const JsonNode& node, std::string_view part, SliceKind kind, int size,
                      bool mirrored) {
  const std::span values = face_.slice_values(in_, node, kind, size, size, mirrored);
  return face_.add_slice(in_, node, {name_, "/", part}, kind, values, written(mirrored));
}

int FigureReader::point(const JsonNode& node, std::string_view part, bool mirrored) {
  if (node.kind == JsonKind::string) return face_.reference(in_, node, side_, SliceKind::point, 2);
  return add(node, part, SliceKind::point, 2, mirrored);
}

std::vector<int> FigureReader::point_list(const Field& points, std::string_view part, int least) {
  in_.expect(*points.node, JsonKind::array);
  if (int(points.node->count) < least)
    in_.refuse(*points.node, fmt::format("expected at least {} point{}, got {}", least,
                                         least == 1 ? "" : "s", points.node->count));
  std::vector<int> list;
  list.reserve(std::size_t(points.node->count));
  in_.for_each(*points.node, [&](const JsonNode& child, int i) {
    list.push_back(point(child, PartName(part, i), points.mirrored));
  });
  return list;
}

/// "half_width": one number or three.
int FigureReader::pen_width() {
  const Field width = need("half_width");
  if (width.node->kind == JsonKind::array && width.node->count != 3)
    in_.refuse(*width.node, fmt::format("expected 1 or 3 numbers, got {}", width.node->count));
  return slice("half_width", SliceKind::length, width.node->kind == JsonKind::array ? 3 : 1);
}

int FigureReader::optional_tilt() {
  return field("tilt").node ? slice("tilt", SliceKind::angle, 1) : -1;
}

BandFigure FigureReader::band() {
  return {slice("frame", SliceKind::frame, 2), slice("lower", SliceKind::parabola, 2),
          slice("upper", SliceKind::parabola, 2)};
}

EllipseFigure FigureReader::ellipse() {
  return {slice("center", SliceKind::point, 2), slice("radii", SliceKind::length, 2),
          optional_tilt()};
}

DiscFigure FigureReader::disc() {
  return {slice("center", SliceKind::point, 2), slice("radius", SliceKind::length, 1)};
}

CutDiscFigure FigureReader::cut_disc() {
  return {slice("center", SliceKind::point, 2), slice("radius", SliceKind::length, 1),
          slice("chords", SliceKind::ratio, 2)};
}

OpeningFigure FigureReader::opening() {
  return {slice("inner", SliceKind::point, 2), slice("upper", SliceKind::point, 2),
          slice("outer", SliceKind::point, 2), slice("lower", SliceKind::point, 2)};
}

RoundedFigure FigureReader::rounded() {
  return {slice("center", SliceKind::point, 2), slice("radii", SliceKind::length, 2),
          slice("corner", SliceKind::length, 1), optional_tilt()};
}

StrokeFigure FigureReader::stroke() {
  const Field spine = need("spine");
  in_.expect(*spine.node, JsonKind::array);
  if (spine.node->count != 3)
    in_.refuse(*spine.node, fmt::format("expected 3 points, got {}", spine.node->count));
  StrokeFigure figure{};
  in_.for_each(*spine.node, [&](const JsonNode& child, int i) {
    figure.spine[i] = point(child, PartName("spine", i), spine.mirrored);
  });
  figure.half_width = pen_width();
  return figure;
}

PolylineFigure FigureReader::polyline() {
  PolylineFigure figure{.points = point_list(need("points"), "points", 1), .half_width = 0};
  const Field width = need("half_width");
  const int widths = width.node->kind == JsonKind::array ? int(width.node->count) : 1;
  if (widths != 1 && widths != int(figure.points.size()))
    in_.refuse(*width.node, fmt::format("expected 1 number or one for each of {} points, got {}",
                                        figure.points.size(), widths));
  figure.half_width = slice("half_width", SliceKind::length, widths);
  figure.smooth = flag("smooth");
  return figure;
}

PathFigure FigureReader::path() {
  PathFigure figure;
  const Field points = field("points"), loops = field("loops");
  if (bool(points.node) == bool(loops.node))
    in_.refuse(node_, "a path has either \"points\" (one loop) or \"loops\" (any number)");
  if (points.node) figure.loops.push_back(loop(*points.node, "points", points.mirrored));
  if (loops.node) {
    in_.expect(*loops.node, JsonKind::array);
    in_.for_each(*loops.node, [&](const JsonNode& child, int i) {
      figure.loops.push_back(loop(child, PartName("loops", i), loops.mirrored));
    });
  }
  constexpr std::array<std::string_view, 2> kFills{"nonzero", "even_odd"};
  if (const Field fill = field("fill"); fill.node)
    figure.even_odd = in_.word(*fill.node, "fill rule", kFills) == 1;
  return figure;
}

/// [x, y], "@reference", [x, y, "bend"] or ["@reference", "bend"].
PathFigure::Node FigureReader::path_node(const JsonNode& node, std::string_view part,
                                         bool mirrored) {
  const JsonNode* last = node.kind == JsonKind::array ? in_.tree.first(node) : nullptr;
  const JsonNode* const first = last;
  while (last && in_.tree.next(*last)) last = in_.tree.next(*last);
  if (!last || last->kind != JsonKind::string || node.count < 2)
    return {point(node, part, mirrored), false};
  constexpr std::array<std::string_view, 1> kMarks{"bend"};
  in_.word(*last, "mark of a point", kMarks);
  if (node.count == 2) return {face_.reference(in_, *first, side_, SliceKind::point, 2), true};
  if (node.count != 3) in_.refuse(node, "expected [x, y, \"bend\"]");
  std::array<double, 2> values{in_.number(*first), in_.number(*in_.tree.next(*first))};
  if (mirrored) mirror_values(SliceKind::point, values, face_.model.canvas.twice_axis());
  return {
      face_.add_slice(in_, node, {name_, "/", part}, SliceKind::point, values, written(mirrored)),
      true};
}

PathFigure::Loop FigureReader::loop(const JsonNode& node, std::string_view part, bool mirrored) {
  in_.expect(node, JsonKind::array);
  if (node.count < 3)
    in_.refuse(node, fmt::format("expected at least 3 points, got {}", node.count));
  PathFigure::Loop loop;
  loop.nodes.reserve(std::size_t(node.count));
  in_.for_each(node, [&](const JsonNode& child, int i) {
    loop.nodes.push_back(path_node(child, PartName(part, i), mirrored));
  });
  return loop;
}

std::vector<Index<Feature>> FigureReader::operands(std::string_view key) const {
  std::vector<Index<Feature>> found;
  const JsonNode* list = in_.find(node_, key);
  if (!list) return found;
  in_.expect(*list, JsonKind::array);
  if (list->count < 1) in_.refuse(*list, "expected at least 1 feature, got 0");
  in_.for_each(*list, [&](const JsonNode& name, int) {
    found.push_back(earlier_feature(in_, name, side_, face_, features_, "is part of"));
  });
  return found;
}

AreaFigure FigureReader::area() {
  AreaFigure figure{operands("all"), operands("any"), operands("minus")};
  if (figure.all.empty() && figure.any.empty())
    in_.refuse(node_, "an area has \"all\" or \"any\": the features that it is made of");
  if (field("grow").node) figure.grow = slice("grow", SliceKind::length, 1);
  return figure;
}

const std::vector<FigureKind>& figure_kinds() {
  using Reader = FigureReader;
  static const std::vector<FigureKind> all = [] {
    std::vector<FigureKind> kinds{
        {"band", {"frame", "lower", "upper"}, 0, [](Reader& r) -> Figure { return r.band(); }},
        {"ellipse",
         {"center", "radii", "tilt"},
         0,
         [](Reader& r) -> Figure { return r.ellipse(); }},
        {"disc", {"center", "radius"}, 0, [](Reader& r) -> Figure { return r.disc(); }},
        {"cut_disc",
         {"center", "radius", "chords"},
         0,
         [](Reader& r) -> Figure { return r.cut_disc(); }},
        {"stroke", {"spine", "half_width"}, 0, [](Reader& r) -> Figure { return r.stroke(); }},
        {"polyline",
         {"points", "half_width", "smooth"},
         0,
         [](Reader& r) -> Figure { return r.polyline(); }},
        {"path", {"points", "loops", "fill"}, 0, [](Reader& r) -> Figure { return r.path(); }},
        {"opening",
         {"inner", "upper", "outer", "lower"},
         0,
         [](Reader& r) -> Figure { return r.opening(); }},
        {"rounded",
         {"center", "radii", "corner", "tilt"},
         0,
         [](Reader& r) -> Figure { return r.rounded(); }},
        {"area", {"all", "any", "minus", "grow"}, 0, [](Reader& r) -> Figure { return r.area(); }},
        {"scatter",
         {"patch", "count", "stagger", "round", "of", "radius", "radii", "length", "half_width",
          "tilt", "seed", "jitter", "vary", "sway"},
         0,
         [](Reader& r) -> Figure { return r.scatter(); }},
        {"repeat",
         {"points", "smooth", "count", "of", "radius", "radii", "length", "half_width", "tilt",
          "seed", "jitter", "vary", "sway"},
         0,
         [](Reader& r) -> Figure { return r.repeat(); }},
        {"stripes",
         {"patch", "count", "half_width", "seed", "jitter", "vary"},
         0,
         [](Reader& r) -> Figure { return r.stripes(); }},
        {"text",
         {"text", "center", "height", "tilt"},
         0,
         [](Reader& r) -> Figure { return r.text(); }},
    };
    for (FigureKind& kind : kinds) kind = with_all_keys(std::move(kind));
    return kinds;
  }();
  return all;
}

const std::vector<std::string_view>& figure_names() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> names;
    for (const FigureKind& kind : figure_kinds()) names.push_back(kind.name);
    return names;
  }();
  return all;
}

}  // namespace mien
