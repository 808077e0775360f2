// The features of a face file.

#include "figure_reader_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/face/face_draft_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mien {
namespace {

const FigureKind& read_kind(const Reading& in, const JsonNode& node) {
  return figure_kinds()[in.word(node, "kind of feature", figure_names())];
}

/// Refuses a name that no earlier feature has. The error tells whether the name comes later in the list or
/// nowhere. Nodes stand in the order of the file, in trees that were composed, too.
[[noreturn]] void refuse_later(const Reading& in, const JsonNode& node, const FaceDraft& face,
                               const JsonNode& features, std::string_view what) {
  const std::string_view wanted = in.string(node);
  in.for_each(features, [&](const JsonNode& feature, int) {
    const JsonNode* name = feature.kind == JsonKind::object ? in.find(feature, "name") : nullptr;
    if (name && name->kind == JsonKind::string && in.tree.string(*name) == wanted && name > &node)
      in.refuse(node, fmt::format("the feature {} comes later: move it before what it {}",
                                  in_quotes(wanted), what));
  });
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
  FeatureReader(Reading& in, const JsonNode& node, const JsonNode& features, FaceDraft& face)
      : in_(in), node_(node), features_(features), face_(face) {}

  void read() {
    in_.expect(node_, JsonKind::object);
    const FigureKind& kind = read_kind(in_, in_.need(node_, "kind"));
    check_keys(kind);
    const JsonNode& name_node = in_.need(node_, "name");
    const std::string_view name = in_.checked_name(name_node, in_.string(name_node));
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
  void check_keys(const FigureKind& kind) {
    const std::span<const std::string_view> known = kind.keys;
    for (const std::string_view side : kSides)
      if (const JsonNode* instead = in_.find(node_, side))
        in_.expect_object(*instead, known.first(kind.sided), kind.name);
    in_.expect_object(node_, known, kind.name);
  }

  void add(const FigureKind& kind, const JsonNode& name_node, std::string_view name, Side side,
           bool mirrored) {
    Feature feature;
    feature.name = face_.model.names.keep({name, side == Side::none ? "" : ".", side_name(side)});
    feature.side = side;
    if (face_.feature_named(feature.name) >= 0)
      in_.refuse(name_node, fmt::format("there is a feature {} already", in_quotes(feature.name)));
    if (face_.model.features.size() >= in_.limits.features)
      in_.refuse(node_,
                 fmt::format("more than {} features (limit: features)", in_.limits.features));
    const JsonNode* instead = side == Side::none ? nullptr : in_.find(node_, side_name(side));
    FigureReader reader(in_, face_, features_, node_, instead, feature.name, side, mirrored);
    feature.figure = kind.read(reader);
    count_figures(feature.figure);
    if (const auto paint = reader.field("paint"); paint.node)
      read_feature_paint(in_, *paint.node, {feature.name, side, paint.mirrored}, face_, feature);
    if (const auto opacity = reader.field("opacity"); opacity.node)
      feature.opacity = read_opacity(in_, *opacity.node, feature.name, face_);
    if (const auto relief = reader.field("relief"); relief.node)
      feature.relief = read_relief(in_, *relief.node, {feature.name, side, relief.mirrored}, face_);
    if (const auto feather = reader.field("feather"); feather.node) {
      if (feature.gradient)
        in_.refuse(*feather.node, "a feather softens one colour, not a gradient");
      feature.feather = reader.slice("feather", SliceKind::length, 1);
    }
    const SurroundingNodes around{reader.field("shadow").node, reader.field("glow").node,
                                  reader.field("contour").node};
    if (around.shadow || around.glow || around.contour) add_surroundings(around, feature);
    if (const JsonNode* group = in_.find(node_, "group"))
      feature.group = group_named(in_, *group, face_);
    if (const JsonNode* clip = in_.find(node_, "clip")) feature.clips = read_clips(*clip, side);
    face_.areas.push_back(area_of(feature));
    face_.add_feature(std::move(feature), mirrored);
  }

  /// Of all patterns, left and right counted.
  void count_figures(const Figure& figure) {
    const auto figures = std::visit([](const auto& f) { return figures_in(f); }, figure);
    if (figures == 1) return;
    face_.pattern_figures += figures;
    if (face_.pattern_figures > kMostPatternFigures)
      in_.refuse(node_,
                 fmt::format("the patterns of a face have at most {} figures in all, left and "
                             "right counted; with this one it is {}",
                             kMostPatternFigures, face_.pattern_figures));
  }

  void add_surroundings(const SurroundingNodes& around, Feature& feature) {
    feature.surroundings = read_surroundings(in_, around, feature.name, feature.side, face_);
    FaceSurroundings& made = feature.surroundings.in(face_.model.surroundings);
    if (const JsonNode* on = around.shadow ? in_.find(*around.shadow, "on") : nullptr)
      made.shadow->on = earlier_feature(in_, *on, feature.side, face_, features_, "lies below");
    const bool along = made.contour && made.contour->by == FaceContour::By::along;
    if (along && !has_one_outline(feature.figure))
      in_.refuse(in_.need(*around.contour, "by"),
                 "a contour varies \"along\" paths, openings, discs and ellipses alone; by "
                 "\"angle\" along all");
  }

  static bool has_one_outline(const Figure& figure) {
    return std::holds_alternative<PathFigure>(figure) ||
           std::holds_alternative<OpeningFigure>(figure) ||
           std::holds_alternative<DiscFigure>(figure) ||
           std::holds_alternative<EllipseFigure>(figure);
  }

  FeatureClip read_clip(const JsonNode& clip, Side side) const {
    const bool outside = clip.kind == JsonKind::object;
    if (outside) in_.expect_object(clip, {"outside"}, "clip");
    const JsonNode& name = outside ? in_.need(clip, "outside") : clip;
    return {earlier_feature(in_, name, side, face_, features_, "clips"), outside};
  }

  /// "head", {"outside": "cap"}, or a list of such.
  std::vector<FeatureClip> read_clips(const JsonNode& clip, Side side) const {
    if (clip.kind != JsonKind::array) return {read_clip(clip, side)};
    if (clip.count < 1) in_.refuse(clip, "expected at least 1 clip, got 0");
    std::vector<FeatureClip> clips;
    in_.for_each(clip, [&](const JsonNode& one, int) { clips.push_back(read_clip(one, side)); });
    return clips;
  }

  /// Areas made of areas made of areas: their figures double with every step, unless they are counted.
  FaceDraft::AreaSize area_of(const Feature& feature) {
    constexpr std::size_t kMostFigures = 10'000;
    FaceDraft::AreaSize size{.depth = 0,
                             .figures = std::size_t(std::visit(
                                 [](const auto& f) { return figures_in(f); }, feature.figure))};
    const auto take = [&](Index<Feature> other) {
      const FaceDraft::AreaSize& its = face_.areas[std::size_t(other.at)];
      size.depth = std::max(size.depth, its.depth + 1);
      size.figures += its.figures;
    };
    for (const FeatureClip& clip : feature.clips) take(clip.feature);
    if (const auto* area = std::get_if<AreaFigure>(&feature.figure))
      for (const auto* list : {&area->all, &area->any, &area->minus})
        for (const Index<Feature> other : *list) take(other);
    if (size.figures > kMostFigures)
      in_.refuse(node_, fmt::format("its area is made of more than {} figures, those of its clips "
                                    "counted",
                                    kMostFigures));
    // What plain features clipped to each other have was always allowed.
    const std::size_t plain = std::size_t(in_.limits.nesting) + 1;
    face_.area_figures += size.figures > plain ? size.figures - plain : 0;
    if (face_.area_figures > in_.limits.features)
      in_.refuse(node_, fmt::format("areas made of patterns and of other areas have more than {} "
                                    "figures in all (limit: features)",
                                    in_.limits.features));
    return size;
  }

  Reading& in_;
  const JsonNode& node_;
  const JsonNode& features_;
  FaceDraft& face_;
};

}  // namespace

Index<Feature> earlier_feature(const Reading& in, const JsonNode& node, Side side,
                               const FaceDraft& face, const JsonNode& features,
                               std::string_view what) {
  const int found = face.find_feature(in.string(node), side);
  if (found < 0) refuse_later(in, node, face, features, what);
  if (face.areas[std::size_t(found)].depth >= in.limits.nesting)
    in.refuse(node, fmt::format("features clipped more than {} deep (limit: nesting)",
                                in.limits.nesting));
  return {found};
}

void read_features(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::array);
  in.for_each(node,
              [&](const JsonNode& child, int) { FeatureReader(in, child, node, face).read(); });
}

}  // namespace mien
