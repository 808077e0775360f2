// Gradients, reliefs, groups and the light of a face file.

#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/face/feature/part_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mien {
namespace {

constexpr double kLeastLength = 1e-9;  ///< [face units] widths and radii that divide

/// Reads the numbers of one object that belongs to a feature, such as its "paint": adds its slices to the face.
class PartReader {
 public:
  PartReader(Reading& in, FaceDraft& face, const PaintPlace& place, const JsonNode& node,
             std::string_view name)
      : in_(in), face_(face), place_(place), node_(node), name_(name) {}

  bool has(std::string_view key) const { return in_.find(node_, key); }

  int slice(std::string_view key, SliceKind kind, int least, int most) {
    const JsonNode& value = in_.need(node_, key);
    if (value.kind == JsonKind::string)
      return face_.reference(in_, value, place_.side, kind, least);
    const std::span numbers = face_.slice_values(in_, value, kind, least, most, place_.mirrored);
    return face_.add_slice(in_, value, {place_.feature, "/", name_, "/", key}, kind, numbers,
                           written(place_.mirrored));
  }
  int slice(std::string_view key, SliceKind kind, int size) { return slice(key, kind, size, size); }
  int optional(std::string_view key, SliceKind kind, int size) {
    return has(key) ? slice(key, kind, size) : -1;
  }

  /// A length that something is divided by: it must be more than 0 as written. A pose may still make it 0
  /// later, which the scene must cope with.
  int divisor(std::string_view key, int size) {
    const int made = slice(key, SliceKind::length, size);
    for (int i = 0; i < size; ++i)
      if (face_.vector[std::size_t(face_.model.layout[made].begin + i)] < kLeastLength)
        in_.refuse(in_.need(node_, key), "expected more than 0");
    return made;
  }

 private:
  Reading& in_;
  FaceDraft& face_;
  const PaintPlace& place_;
  const JsonNode& node_;
  std::string_view name_;
};

/// [[place, "colour"], …]: one slice of the places, and the colours' own slices.
void read_stops(Reading& in, FaceDraft& face, const PaintPlace& place, const JsonNode& node,
                GradientPaint& gradient) {
  in.expect(node, JsonKind::array);
  if (node.count < 2) in.refuse(node, fmt::format("expected at least 2 stops, got {}", node.count));
  std::vector<double> places;
  in.for_each(node, [&](const JsonNode& stop, int) {
    in.expect(stop, JsonKind::array);
    if (stop.count != 2) in.refuse(stop, "expected [place, \"colour\"]");
    const double at = in.number(*in.tree.first(stop));
    if (at < 0) in.refuse(stop, fmt::format("a stop's place must not be negative, got {}", at));
    if (!places.empty() && at < places.back())
      in.refuse(stop, fmt::format("places must not fall, got {} after {}", at, places.back()));
    places.push_back(at);
    gradient.colors.push_back(read_paint(in, *in.tree.next(*in.tree.first(stop)), face));
  });
  gradient.places =
      face.add_slice(in, node, {place.feature, "/paint/places"}, SliceKind::ratio, places);
}

Index<GradientPaint> read_gradient(Reading& in, FaceDraft& face, const PaintPlace& place,
                                   const JsonNode& node) {
  constexpr std::array<std::string_view, 3> kAlong{"linear", "radial", "distance"};
  constexpr std::array<std::string_view, 3> kExtend{"pad", "repeat", "reflect"};
  const std::size_t along = in.word(in.need(node, "gradient"), "gradient", kAlong);
  PartReader part(in, face, place, node, "paint");
  GradientPaint gradient{};
  if (along == 0) {
    in.expect_object(node, {"gradient", "from", "to", "stops", "extend"}, "linear gradient");
    gradient.along =
        LinearPaint{part.slice("from", SliceKind::point, 2), part.slice("to", SliceKind::point, 2)};
  } else if (along == 1) {
    in.expect_object(node, {"gradient", "center", "radii", "tilt", "stops", "extend"},
                     "radial gradient");
    const int center = part.slice("center", SliceKind::point, 2);
    gradient.along = RadialPaint{center, part.slice("radii", SliceKind::length, 2),
                                 part.optional("tilt", SliceKind::angle, 1)};
  } else {
    in.expect_object(node, {"gradient", "inside", "outside", "stops", "extend"},
                     "distance gradient");
    gradient.along = DistancePaint{part.slice("inside", SliceKind::length, 1),
                                   part.slice("outside", SliceKind::length, 1)};
  }
  read_stops(in, face, place, in.need(node, "stops"), gradient);
  if (const JsonNode* extend = in.find(node, "extend"))
    gradient.extend = GradientPaint::Extend(in.word(*extend, "extension", kExtend));
  face.model.gradients.push_back(std::move(gradient));
  return last_of(face.model.gradients);
}

FaceDome read_dome(Reading& in, FaceDraft& face, const PaintPlace& place, const JsonNode& node,
                   int index) {
  in.expect_object(node, {"center", "radii", "tilt", "height"}, "dome");
  const PartName name("relief/domes", index);
  PartReader part(in, face, place, node, name);
  FaceDome dome{};
  dome.center = part.slice("center", SliceKind::point, 2);
  dome.radii = part.divisor("radii", 2);
  dome.height = part.slice("height", SliceKind::length, 1);
  dome.tilt = part.optional("tilt", SliceKind::angle, 1);
  return dome;
}

/// One half-width, or the thin and the thick one and what they vary by.
FaceContour read_contour(Reading& in, const JsonNode& node, PartReader& numbers, int color) {
  constexpr std::array<std::string_view, 2> kBy{"angle", "along"};
  in.expect_object(node, {"color", "half_width", "widths", "by"}, "contour");
  FaceContour made{.color = color, .half_width = -1};
  if (numbers.has("half_width") == numbers.has("widths"))
    in.refuse(node, "a contour has either \"half_width\" or \"widths\"");
  if (numbers.has("half_width")) {
    if (const JsonNode* by = in.find(node, "by"))
      in.refuse(*by, "a contour of one half-width varies by nothing: give it \"widths\"");
    made.half_width = numbers.slice("half_width", SliceKind::length, 1);
    return made;
  }
  made.by = FaceContour::By(1 + in.word(in.need(node, "by"), "way to vary", kBy));
  made.half_width = numbers.slice("widths", SliceKind::length, 2);
  return made;
}

}  // namespace

void read_feature_paint(Reading& in, const JsonNode& node, const PaintPlace& place, FaceDraft& face,
                        Feature& feature) {
  if (node.kind == JsonKind::object)
    feature.gradient = read_gradient(in, face, place, node);
  else
    feature.paint = read_paint(in, node, face);
}

int read_opacity(Reading& in, const JsonNode& node, std::string_view of, FaceDraft& face) {
  const double opacity = in.number(node);
  if (!(opacity >= 0 && opacity <= 1))
    in.refuse(node, fmt::format("an opacity goes from 0 to 1, got {}", opacity));
  return face.add_slice(in, node, {of, "/opacity"}, SliceKind::ratio, std::array{opacity});
}

Index<FaceRelief> read_relief(Reading& in, const JsonNode& node, const PaintPlace& place,
                              FaceDraft& face) {
  constexpr std::array<std::string_view, 4> kProfiles{"flat", "bevel", "round", "custom"};
  in.expect_object(
      node, {"profile", "width", "height", "table", "sunk", "domes", "specular", "shininess"},
      "relief");
  PartReader part(in, face, place, node, "relief");
  FaceRelief relief;
  if (const JsonNode* profile = in.find(node, "profile"))
    relief.profile = FaceRelief::Profile(in.word(*profile, "profile", kProfiles));
  if (relief.profile != FaceRelief::Profile::flat) {
    relief.width = part.divisor("width", 1);
    relief.height = part.slice("height", SliceKind::length, 1);
  }
  if (relief.profile == FaceRelief::Profile::custom) {
    constexpr int kMostHeights = 1000;
    relief.table = part.slice("table", SliceKind::ratio, 2, kMostHeights);
  }
  if (const JsonNode* sunk = in.find(node, "sunk")) relief.sunk = in.boolean(*sunk);
  relief.specular = part.optional("specular", SliceKind::ratio, 1);
  relief.shininess = part.optional("shininess", SliceKind::ratio, 1);
  if (const JsonNode* domes = in.find(node, "domes")) {
    in.expect(*domes, JsonKind::array);
    in.for_each(*domes, [&](const JsonNode& dome, int i) {
      relief.domes.push_back(read_dome(in, face, place, dome, i));
    });
  }
  face.model.reliefs.push_back(std::move(relief));
  return last_of(face.model.reliefs);
}

Index<FaceSurroundings> read_surroundings(Reading& in, const SurroundingNodes& nodes,
                                          std::string_view feature, Side side, FaceDraft& face) {
  const PaintPlace place{feature, side,
                         false};  // lengths have no mirror; one lamp casts all shadows
  FaceSurroundings made;
  const auto color = [&](const JsonNode& node) {
    return read_paint(in, in.need(node, "color"), face);
  };
  if (const JsonNode* shadow = nodes.shadow) {
    in.expect_object(*shadow, {"color", "blur", "shift", "on"}, "shadow");
    PartReader numbers(in, face, place, *shadow, "shadow");
    made.shadow = FaceShadow{color(*shadow),
                             numbers.divisor("blur", 1),
                             numbers.optional("shift", SliceKind::shift, 2),
                             {}};
  }
  if (const JsonNode* glow = nodes.glow) {
    in.expect_object(*glow, {"color", "reach"}, "glow");
    PartReader numbers(in, face, place, *glow, "glow");
    made.glow = FaceGlow{color(*glow), numbers.divisor("reach", 1)};
  }
  if (const JsonNode* contour = nodes.contour) {
    PartReader numbers(in, face, place, *contour, "contour");
    made.contour = read_contour(in, *contour, numbers, color(*contour));
  }
  face.model.surroundings.push_back(made);
  return last_of(face.model.surroundings);
}

void read_groups(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::object);
  in.for_each(node, [&](const JsonNode& child, int) {
    if (in.tree.key(child) == "comment") return;
    in.expect_object(child, {"opacity", "mix", "clip"}, "group");
    FaceGroup group{.name = in.name(child, in.tree.key(child))};
    if (const JsonNode* opacity = in.find(child, "opacity"))
      group.opacity = read_opacity(in, *opacity, "groups/" + group.name, face);
    if (const JsonNode* mix = in.find(child, "mix"))
      group.mix = MixMode(in.word(*mix, "way to mix", kMixModes));
    face.model.groups.push_back(std::move(group));
  });
}

Index<FaceGroup> group_named(Reading& in, const JsonNode& node, const FaceDraft& face) {
  std::vector<std::string_view> known;
  for (const FaceGroup& group : face.model.groups) known.push_back(group.name);
  const Index<FaceGroup> group{int(in.word(node, "group", known))};
  const std::vector<Feature>& features = face.model.features;
  const bool seen = std::any_of(features.begin(), features.end(),
                                [&](const Feature& f) { return f.group == group; });
  if (seen && features.back().group != group)
    in.refuse(node, fmt::format("the features of the group {} must stand together",
                                in_quotes(in.string(node))));
  return group;
}

void read_group_clips(Reading& in, const JsonNode& node, FaceDraft& face) {
  int index = 0;
  in.for_each(node, [&](const JsonNode& child, int) {
    if (in.tree.key(child) == "comment") return;
    const Index<FaceGroup> group{index++};
    const JsonNode* clip = in.find(child, "clip");
    if (!clip) return;
    std::vector<std::string_view> known;
    int found = -1, first = int(face.model.features.size());
    for (int i = int(face.model.features.size()); i-- > 0;) {
      const Feature& f = face.model.features[std::size_t(i)];
      known.push_back(f.name);
      if (f.name == in.string(*clip)) found = i;
      if (f.group == group) first = i;
    }
    if (found < 0) in.refuse(*clip, unknown_name("feature", in.string(*clip), known));
    if (found >= first)
      in.refuse(*clip, fmt::format("the feature {} must come before the group that it clips",
                                   in_quotes(in.string(*clip))));
    group.in(face.model.groups).clip = {found};
  });
}

void read_light(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect_object(node, {"direction", "ambient"}, "light");
  FaceLight& light = face.model.light;
  if (const JsonNode* direction = in.find(node, "direction")) {
    const std::array<double, 3> to = in.three(*direction);
    if (!(to[2] > 0))
      in.refuse(*direction, "a lamp shines from the front: the third number must be more than 0");
    light.direction = {to[0], to[1], to[2]};
  }
  if (const JsonNode* ambient = in.find(node, "ambient")) {
    light.ambient = in.number(*ambient);
    if (!(light.ambient >= 0 && light.ambient <= 1))
      in.refuse(*ambient, fmt::format("ambient light goes from 0 to 1, got {}", light.ambient));
  }
}

}  // namespace mien
