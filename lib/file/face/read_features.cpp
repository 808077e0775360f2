// The features of a face file.

#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mien {
namespace {

/// Reads one side of one feature: adds its slices to the face.
class FigureReader {
 public:
  FigureReader(Reading& in, FaceDraft& face, const JsonNode& node, const JsonNode* instead,
               std::string name, Side side, bool mirrored)
      : in_(in),
        face_(face),
        node_(node),
        instead_(instead),
        name_(std::move(name)),
        side_(side),
        mirrored_(mirrored) {}

  BandFigure band() {
    return {slice("frame", SliceKind::frame, 2), slice("lower", SliceKind::parabola, 2),
            slice("upper", SliceKind::parabola, 2)};
  }
  EllipseFigure ellipse() {
    return {slice("center", SliceKind::point, 2), slice("radii", SliceKind::length, 2),
            field("tilt").node ? slice("tilt", SliceKind::angle, 1) : -1};
  }
  DiscFigure disc() {
    return {slice("center", SliceKind::point, 2), slice("radius", SliceKind::length, 1)};
  }
  CutDiscFigure cut_disc() {
    return {slice("center", SliceKind::point, 2), slice("radius", SliceKind::length, 1),
            slice("chords", SliceKind::ratio, 2)};
  }
  OpeningFigure opening() {
    return {slice("inner", SliceKind::point, 2), slice("upper", SliceKind::point, 2),
            slice("outer", SliceKind::point, 2), slice("lower", SliceKind::point, 2)};
  }
  StrokeFigure stroke() {
    const Field spine = need("spine");
    in_.expect(*spine.node, JsonKind::array);
    if (spine.node->count != 3)
      in_.refuse(*spine.node, fmt::format("expected 3 points, got {}", spine.node->count));
    StrokeFigure figure{};
    in_.for_each(*spine.node, [&](const JsonNode& child, int i) {
      figure.spine[i] = point(child, item("spine", i), spine.mirrored);
    });
    const Field width = need("half_width");
    if (width.node->kind == JsonKind::array && width.node->count != 3)
      in_.refuse(*width.node, fmt::format("expected 1 or 3 numbers, got {}", width.node->count));
    figure.half_width =
        slice("half_width", SliceKind::length, width.node->kind == JsonKind::array ? 3 : 1);
    return figure;
  }
  PolylineFigure polyline() {
    const Field points = need("points");
    in_.expect(*points.node, JsonKind::array);
    if (points.node->count < 1) in_.refuse(*points.node, "expected at least 1 point, got 0");
    PolylineFigure figure{};
    in_.for_each(*points.node, [&](const JsonNode& child, int i) {
      figure.points.push_back(point(child, item("points", i), points.mirrored));
    });
    figure.half_width = slice("half_width", SliceKind::length, 1);
    if (const Field smooth = field("smooth"); smooth.node)
      figure.smooth = in_.boolean(*smooth.node);
    return figure;
  }
  PathFigure path() {
    PathFigure figure;
    const Field points = field("points"), loops = field("loops");
    if (bool(points.node) == bool(loops.node))
      in_.refuse(node_, "a path has either \"points\" (one loop) or \"loops\" (any number)");
    if (points.node) figure.loops.push_back(loop(*points.node, "points", points.mirrored));
    if (loops.node) {
      in_.expect(*loops.node, JsonKind::array);
      in_.for_each(*loops.node, [&](const JsonNode& child, int i) {
        figure.loops.push_back(loop(child, item("loops", i), loops.mirrored));
      });
    }
    constexpr std::array<std::string_view, 2> kFills{"nonzero", "even_odd"};
    if (const Field fill = field("fill"); fill.node)
      figure.even_odd = in_.word(*fill.node, "fill rule", kFills) == 1;
    return figure;
  }

  /// A member's value for this side, and whether it was written for the other one.
  struct Field {
    const JsonNode* node;
    bool mirrored;
  };
  Field field(std::string_view key) const {
    if (instead_)
      if (const JsonNode* found = in_.find(*instead_, key)) return {found, false};
    return {in_.find(node_, key), mirrored_};
  }

 private:
  Field need(std::string_view key) const {
    const Field found = field(key);
    if (!found.node) in_.need(node_, key);
    return found;
  }

  int slice(std::string_view key, SliceKind kind, int size) {
    const Field f = need(key);
    if (f.node->kind == JsonKind::string) return face_.reference(in_, *f.node, side_, kind, size);
    return add(*f.node, key, kind, size, f.mirrored);
  }

  std::string slice_name(std::string_view part) const {
    std::string name;
    name.reserve(name_.size() + 1 + part.size());
    return name.append(name_).append(1, '/').append(part);
  }

  /// "points/3"
  static std::string item(std::string_view list, int index) {
    return std::string(list).append(1, '/').append(std::to_string(index));
  }

  int add(const JsonNode& node, std::string_view part, SliceKind kind, int size, bool mirrored) {
    const std::vector<double> values =
        read_slice_values(in_, node, kind, size, size, face_.model.canvas, mirrored);
    return face_.add_slice(in_, node, slice_name(part), kind, values);
  }

  int point(const JsonNode& node, std::string_view part, bool mirrored) {
    if (node.kind == JsonKind::string)
      return face_.reference(in_, node, side_, SliceKind::point, 2);
    return add(node, part, SliceKind::point, 2, mirrored);
  }

  /// [x, y], "@reference", [x, y, "bend"] or ["@reference", "bend"].
  PathFigure::Node path_node(const JsonNode& node, std::string_view part, bool mirrored) {
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
    return {face_.add_slice(in_, node, slice_name(part), SliceKind::point, values), true};
  }

  PathFigure::Loop loop(const JsonNode& node, std::string_view part, bool mirrored) {
    in_.expect(node, JsonKind::array);
    if (node.count < 3)
      in_.refuse(node, fmt::format("expected at least 3 points, got {}", node.count));
    PathFigure::Loop loop;
    in_.for_each(node, [&](const JsonNode& child, int i) {
      loop.nodes.push_back(path_node(child, item(part, i), mirrored));
    });
    return loop;
  }

  Reading& in_;
  FaceDraft& face_;
  const JsonNode& node_;
  const JsonNode* instead_;  ///< this side's overrides
  std::string name_;
  Side side_;
  bool mirrored_;
};

/// A kind of feature: its name, its own keys and how it is read.
struct Kind {
  std::string_view name;
  std::vector<std::string_view> keys;
  Figure (*read)(FigureReader&);
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"band", {"frame", "lower", "upper"}, [](FigureReader& r) -> Figure { return r.band(); }},
      {"ellipse",
       {"center", "radii", "tilt"},
       [](FigureReader& r) -> Figure { return r.ellipse(); }},
      {"disc", {"center", "radius"}, [](FigureReader& r) -> Figure { return r.disc(); }},
      {"cut_disc",
       {"center", "radius", "chords"},
       [](FigureReader& r) -> Figure { return r.cut_disc(); }},
      {"stroke", {"spine", "half_width"}, [](FigureReader& r) -> Figure { return r.stroke(); }},
      {"polyline",
       {"points", "half_width", "smooth"},
       [](FigureReader& r) -> Figure { return r.polyline(); }},
      {"path", {"points", "loops", "fill"}, [](FigureReader& r) -> Figure { return r.path(); }},
      {"opening",
       {"inner", "upper", "outer", "lower"},
       [](FigureReader& r) -> Figure { return r.opening(); }},
  };
  return all;
}

const Kind& read_kind(const Reading& in, const JsonNode& node) {
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds()) names.push_back(kind.name);
  return kinds()[in.word(node, "kind of feature", names)];
}

/// Refuses a clip that names no earlier feature. The error says whether the name comes later in the list or
/// nowhere.
[[noreturn]] void refuse_clip(const Reading& in, const JsonNode& node, const FaceDraft& face) {
  const std::string_view wanted = in.string(node);
  const JsonNode* clipped = in.tree.at(node.parent);
  for (const JsonNode* feature = in.tree.next(*clipped); feature;
       feature = in.tree.next(*feature)) {
    const JsonNode* name = feature->kind == JsonKind::object ? in.find(*feature, "name") : nullptr;
    if (name && name->kind == JsonKind::string && in.tree.string(*name) == wanted)
      in.refuse(node, fmt::format("the feature {} comes later: move it before what it clips",
                                  in_quotes(wanted)));
  }
  std::vector<std::string_view> known;
  for (const Feature& f : face.model.features) {
    std::string_view name = f.name;
    if (f.side != Side::none) name.remove_suffix(side_name(f.side).size() + 1);
    known.push_back(name);
  }
  in.refuse(node, unknown_name("feature", wanted, known));
}

/// One feature of the file: one drawn feature, or one for each side.
class FeatureReader {
 public:
  FeatureReader(Reading& in, const JsonNode& node, FaceDraft& face)
      : in_(in), node_(node), face_(face) {}

  void read() {
    in_.expect(node_, JsonKind::object);
    const Kind& kind = read_kind(in_, in_.need(node_, "kind"));
    check_keys(kind);
    const JsonNode& name_node = in_.need(node_, "name");
    const std::string name = in_.name(name_node);
    if (name == "palette" || name == "groups" || name.ends_with(".left") ||
        name.ends_with(".right"))
      in_.refuse(name_node, fmt::format("the name {} is taken: no feature may be called palette or "
                                        "groups or end in .left or .right",
                                        in_quotes(name)));
    const JsonNode* side_node = in_.find(node_, "side");
    const JsonNode* mirror_node = in_.find(node_, "mirror");
    if (!side_node) {
      for (const std::string_view key : {"mirror", "left", "right"})
        if (const JsonNode* found = in_.find(node_, key))
          in_.refuse(*found,
                     fmt::format("\"{}\" needs a \"side\": the one that the numbers are for", key));
      add(kind, name_node, name, Side::none, false);
      return;
    }
    const Side side = in_.word(*side_node, "side", kSides) == 0 ? Side::left : Side::right;
    add(kind, name_node, name, side, false);
    if (!mirror_node || in_.boolean(*mirror_node)) add(kind, name_node, name, other(side), true);
  }

 private:
  /// Warns of unknown keys, in the overrides too.
  void check_keys(const Kind& kind) {
    std::vector<std::string_view> known = kind.keys;
    known.insert(known.end(), {"paint", "opacity", "relief", "shadow", "glow", "contour"});
    for (const std::string_view side : kSides)
      if (const JsonNode* instead = in_.find(node_, side))
        in_.expect_object(*instead, known, kind.name);
    known.insert(known.end(), {"kind", "name", "side", "mirror", "left", "right", "clip", "group"});
    in_.expect_object(node_, known, kind.name);
  }

  void add(const Kind& kind, const JsonNode& name_node, const std::string& name, Side side,
           bool mirrored) {
    Feature feature;
    feature.name = feature_of_side(name, side);
    feature.side = side;
    if (face_.feature_by_name.contains(feature.name))
      in_.refuse(name_node, fmt::format("there is a feature {} already", in_quotes(feature.name)));
    if (face_.model.features.size() >= in_.limits.features)
      in_.refuse(node_,
                 fmt::format("more than {} features (limit: features)", in_.limits.features));
    const JsonNode* instead = side == Side::none ? nullptr : in_.find(node_, side_name(side));
    FigureReader reader(in_, face_, node_, instead, feature.name, side, mirrored);
    feature.figure = kind.read(reader);
    if (const auto paint = reader.field("paint"); paint.node)
      read_feature_paint(in_, *paint.node, {feature.name, side, paint.mirrored}, face_, feature);
    if (const auto opacity = reader.field("opacity"); opacity.node)
      feature.opacity = read_opacity(in_, *opacity.node, feature.name + "/opacity", face_);
    if (const auto relief = reader.field("relief"); relief.node)
      feature.relief = read_relief(in_, *relief.node, {feature.name, side, relief.mirrored}, face_);
    const SurroundingNodes around{reader.field("shadow").node, reader.field("glow").node,
                                  reader.field("contour").node};
    if (around.shadow || around.glow || around.contour)
      feature.surroundings = read_surroundings(in_, around, feature.name, side, face_);
    if (const JsonNode* group = in_.find(node_, "group"))
      feature.group = group_named(in_, *group, face_);
    if (const JsonNode* clip = in_.find(node_, "clip")) feature.clip = read_clip(*clip, side);
    face_.clip_depth.push_back(feature.clip ? face_.clip_depth[std::size_t(feature.clip.at)] + 1
                                            : 0);
    face_.feature_by_name.emplace(feature.name, int(face_.model.features.size()));
    face_.mirrored.push_back(mirrored);
    face_.model.features.push_back(std::move(feature));
  }

  Index<Feature> read_clip(const JsonNode& clip, Side side) const {
    const int found = face_.find_feature(in_.string(clip), side);
    if (found < 0) refuse_clip(in_, clip, face_);
    if (face_.clip_depth[std::size_t(found)] >= in_.limits.nesting)
      in_.refuse(clip, fmt::format("features clipped more than {} deep (limit: nesting)",
                                   in_.limits.nesting));
    return {found};
  }

  Reading& in_;
  const JsonNode& node_;
  FaceDraft& face_;
};

}  // namespace

void read_features(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::array);
  in.for_each(node, [&](const JsonNode& child, int) { FeatureReader(in, child, face).read(); });
}

}  // namespace mien
