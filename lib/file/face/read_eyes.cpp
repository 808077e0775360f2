// The eyes of a face file: the balls behind the drawn eyes, and how lids move on them.

#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/face/feature/part_name.h"
#include "lib/rig/eye/bulge.h"
#include "lib/rig/eye/eye.h"
#include "lib/rig/eye/lid.h"

#include <fmt/format.h>

#include <array>

namespace mien {
namespace {

constexpr std::array<std::string_view, 2> kLaws{"native", "compat"};  // as enum BulgeLaw
constexpr int kBends = OpeningFigure::kLidBends;

/// "iris.left" as its author names it: "iris".
std::string_view author_name(const Feature& feature) {
  std::string_view name = feature.name;
  if (feature.side != Side::none) name.remove_suffix(side_name(feature.side).size() + 1);
  return name;
}

/// Reads one eye of one side: adds its slices to the face.
class EyeReader {
 public:
  EyeReader(Reading& in, const JsonNode& node, FaceDraft& face, std::string name, Side side,
            bool mirrored)
      : in_(in), node_(node), face_(face), mirrored_(mirrored) {
    instead_ = side == Side::none ? nullptr : in_.find(node_, side_name(side));
    eye_.name = std::move(name);
    eye_.side = side;
  }

  void read() {
    read_ball();
    read_gaze();
    if (const JsonNode* lids = find("lids")) read_lids(*lids);
    if (mirrored_) face_.mirrored_eyes.push_back(eye_.name);
    face_.model.eyes.push_back(std::move(eye_));
  }

 private:
  const JsonNode* find(std::string_view key) const {
    if (instead_)
      if (const JsonNode* found = in_.find(*instead_, key)) return found;
    return in_.find(node_, key);
  }
  const JsonNode& need(std::string_view key) const {
    const JsonNode* found = find(key);
    return found ? *found : in_.need(node_, key);
  }
  bool is_mirrored(std::string_view key) const {
    return mirrored_ && !(instead_ && in_.find(*instead_, key));
  }

  int add(std::string_view key, SliceKind kind, int size) {
    const JsonNode& node = need(key);
    const std::span values = face_.slice_values(in_, node, kind, size, size, is_mirrored(key));
    return face_.add_slice(in_, node, {eye_.name, "/", key}, kind, values,
                           written(is_mirrored(key)));
  }
  double value(int slice) const {
    return face_.vector[std::size_t(face_.model.layout[slice].begin)];
  }

  void read_ball() {
    eye_.center = add("center", SliceKind::point, 2);
    eye_.radius = add("radius", SliceKind::length, 1);
    const double radius = value(eye_.radius);
    if (!(radius > 0)) in_.refuse(need("radius"), "an eye's radius must be positive, got 0");
    if (const JsonNode* depth = find("depth")) eye_.depth = in_.number(*depth);
    if (!find("cornea")) {
      if (const JsonNode* bulge = find("bulge"))
        in_.refuse(*bulge, "a bulge needs a \"cornea\": the height of its cap");
      return;
    }
    eye_.cornea = add("cornea", SliceKind::length, 1);
    if (value(eye_.cornea) > radius)
      in_.refuse(need("cornea"),
                 fmt::format("a cornea is no higher than its eye's radius {}, got {}", radius,
                             value(eye_.cornea)));
    eye_.bulge = add("bulge", SliceKind::length, 1);
    if (const JsonNode* law = find("bulge_law"))
      eye_.law = BulgeLaw(in_.word(*law, "law of a bulge", kLaws));
    const double most = most_bulge(radius, value(eye_.cornea));
    if (eye_.law == BulgeLaw::native && value(eye_.bulge) > most)
      in_.refuse(need("bulge"),
                 fmt::format("a cornea of that height bulges by at most {:.6g}, got {}", most,
                             value(eye_.bulge)));
  }

  void read_gaze() {
    const double radius = value(eye_.radius);
    eye_.reach_x = eye_.reach_y = radius;
    if (const JsonNode* reach = find("reach")) {
      const glm::dvec2 both = in_.pair(*reach);
      eye_.reach_x = both.x, eye_.reach_y = both.y;
      for (const double r : {both.x, both.y})
        if (!(r >= 0 && r <= radius))
          in_.refuse(*reach, fmt::format("a gaze reaches from 0 to the eye's radius {}, got {}",
                                         radius, r));
    }
    const JsonNode* gaze = find("gaze");
    if (!gaze) return;
    in_.expect(*gaze, JsonKind::array);
    if (gaze->count != 2)
      in_.refuse(*gaze, fmt::format("expected two controls, for x and y, got {}", gaze->count));
    const JsonNode& x = *in_.tree.first(*gaze);
    eye_.gaze_x = channel(x, 0);
    eye_.gaze_y = channel(*in_.tree.next(x), 0);
  }

  /// The channel of a named control for this eye. It must rest at `rest`, where the eye does.
  Index<Channel> channel(const JsonNode& node, double rest) const {
    const std::string_view name = in_.string(node);
    const Index<Control> index = face_.control_on(in_, node, name, eye_.side);
    const Index<Channel> found = index.in(face_.model.controls).channels[0];
    if (found.in(face_.model.channels).rest != rest)
      in_.refuse(node, fmt::format("the control {} must rest at {}", in_quotes(name), rest));
    return found;
  }

  void read_lids(const JsonNode& node) {
    in_.expect_object(node,
                      {"opening", "follow_upper", "follow_lower", "blink", "bias", "meet", "crease",
                       "ride", "raise"},
                      "lid");
    const JsonNode& opening = in_.need(node, "opening");
    read_opening(opening);
    read_follow(node, "follow_upper", eye_.follow_upper);
    read_follow(node, "follow_lower", eye_.follow_lower);
    if (const JsonNode* blink = in_.find(node, "blink")) eye_.blink = channel(*blink, 0);
    if (const JsonNode* bias = in_.find(node, "bias")) eye_.bias = channel(*bias, 0);
    if (const JsonNode* meet = in_.find(node, "meet")) {
      eye_.meet = in_.number(*meet);
      if (!(eye_.meet >= 0 && eye_.meet <= 1))
        in_.refuse(*meet,
                   fmt::format("lids meet from 0, the upper, to 1, the lower, got {}", eye_.meet));
    }
    if (const JsonNode* crease = in_.find(node, "crease")) read_crease(*crease);
    if (const JsonNode* ride = in_.find(node, "ride")) read_riders(*ride);
    if (const JsonNode* raise = in_.find(node, "raise")) read_raised(*raise);
  }

  void read_opening(const JsonNode& node) {
    const std::string_view name = in_.string(node);
    const int found = face_.find_feature(name, eye_.side);
    Figure* figure = found < 0 ? nullptr : &face_.model.features[std::size_t(found)].figure;
    if (auto* opening = figure ? std::get_if<OpeningFigure>(figure) : nullptr) {
      eye_.upper = opening->upper, eye_.lower = opening->lower;
      eye_.inner = opening->inner, eye_.outer = opening->outer;
      if (eye_.bulge >= 0) add_shifts(node, found, *opening);
    } else if (const auto* band = figure ? std::get_if<BandFigure>(figure) : nullptr) {
      eye_.upper = band->upper, eye_.lower = band->lower;
      if (eye_.bulge >= 0) in_.refuse(node, "a bulge needs lids of the kind opening, not band");
    } else if (figure) {
      in_.refuse(node, fmt::format("{} is no opening and no band", in_quotes(name)));
    } else {
      std::vector<std::string_view> known;
      for (const Feature& f : face_.model.features)
        if (f.figure.index() == Figure(OpeningFigure{}).index() ||
            f.figure.index() == Figure(BandFigure{}).index())
          known.push_back(author_name(f));
      in_.refuse(node, unknown_name("opening", name, known));
    }
  }

  /// Gives an opening, and every stroke along one of its edges, the shifts of its lids.
  void add_shifts(const JsonNode& node, int feature, OpeningFigure& opening) {
    if (opening.shifts >= 0) in_.refuse(node, "two eyes cannot share their lids");
    const std::string_view name = face_.model.features[std::size_t(feature)].name;
    for (int i = 0; i < 2 * kBends; ++i) {
      const PartName part(i < kBends ? "upper_shift" : "lower_shift", i % kBends);
      const int slice = face_.add_slice(in_, node, {name, "/", part}, SliceKind::shift,
                                        std::array{0.0, 0.0}, Written::nowhere);
      if (i == 0) opening.shifts = slice;
    }
    eye_.shifts = opening.shifts;
    for (Feature& f : face_.model.features)
      if (auto* stroke = std::get_if<StrokeFigure>(&f.figure);
          stroke && stroke->spine[0] == opening.inner && stroke->spine[2] == opening.outer) {
        if (stroke->spine[1] == opening.upper) stroke->shifts = opening.shifts;
        if (stroke->spine[1] == opening.lower) stroke->shifts = opening.shifts + kBends;
      }
  }

  void read_follow(const JsonNode& lids, std::string_view key, double (&share)[2]) {
    const JsonNode* node = in_.find(lids, key);
    if (!node) return;
    const glm::dvec2 both = in_.pair(*node);
    share[0] = both.x, share[1] = both.y;
  }

  void read_crease(const JsonNode& node) {
    in_.expect_object(node, {"point", "rise", "fall"}, "crease");
    const JsonNode& point = in_.need(node, "point");
    eye_.crease = face_.slice_named(in_, point, in_.string(point), eye_.side);
    if (face_.model.layout[eye_.crease].kind != SliceKind::point)
      in_.refuse(point, fmt::format("{} is no point", in_quotes(in_.string(point))));
    eye_.crease_rise = in_.number(in_.need(node, "rise"));
    eye_.crease_fall = in_.number(in_.need(node, "fall"));
  }

  glm::dvec2 at(int slice) const {
    const double* p = &face_.vector[std::size_t(face_.model.layout[slice].begin)];
    return {p[0], p[1]};
  }

  /// {"upper": [FEATURE, …], "lower": [FEATURE, …]}: strokes and polylines whose points ride.
  void read_riders(const JsonNode& node) {
    if (eye_.inner < 0) in_.refuse(node, "what rides needs lids of the kind opening, not band");
    in_.expect_object(node, {"upper", "lower"}, "ride");
    for (const bool upper : {true, false})
      if (const JsonNode* list = in_.find(node, upper ? "upper" : "lower")) {
        in_.expect(*list, JsonKind::array);
        in_.for_each(*list, [&](const JsonNode& child, int) { add_riders(child, upper); });
      }
  }

  void add_riders(const JsonNode& node, bool upper) {
    const QuadBezier edge{at(eye_.inner), at(upper ? eye_.upper : eye_.lower), at(eye_.outer)};
    const Figure& figure = feature_named(node).figure;
    const auto parameter = [&](int slice) { return nearest_parameter(edge, at(slice)); };
    if (const auto* stroke = std::get_if<StrokeFigure>(&figure)) {
      const double a = parameter(stroke->spine[0]), b = parameter(stroke->spine[2]);
      add_rider(stroke->spine[0], upper, a, a);
      add_rider(stroke->spine[1], upper, a, b);
      add_rider(stroke->spine[2], upper, b, b);
    } else if (const auto* line = std::get_if<PolylineFigure>(&figure)) {
      for (const int point : line->points) {
        const double t = parameter(point);
        add_rider(point, upper, t, t);
      }
    } else {
      in_.refuse(node, fmt::format("{} is no stroke and no polyline", in_quotes(in_.string(node))));
    }
  }

  /// Features over the ball whose surface the cornea raises: they get its dome.
  void read_raised(const JsonNode& node) {
    if (eye_.bulge < 0) in_.refuse(node, "without a bulge nothing is raised");
    in_.expect(node, JsonKind::array);
    eye_.dome = add_dome_slices(node);
    put_dome(face_.model, eye_, {0, 0}, face_.vector);
    in_.for_each(node, [&](const JsonNode& child, int) {
      Feature& feature = feature_named(child);
      if (!feature.relief) {
        face_.model.reliefs.push_back({});
        feature.relief = last_of(face_.model.reliefs);
      }
      feature.relief.in(face_.model.reliefs)
          .domes.push_back({eye_.dome, eye_.dome + 1, eye_.dome + 2, eye_.dome + 3});
    });
  }

  int add_dome_slices(const JsonNode& node) {
    const auto slice = [&](std::string_view part, SliceKind kind, int size) {
      constexpr std::array<double, 2> kFlat{};
      return face_.add_slice(in_, node, {eye_.name, "/dome/", part}, kind,
                             std::span(kFlat).first(std::size_t(size)), Written::nowhere);
    };
    const int first = slice("center", SliceKind::point, 2);
    slice("radii", SliceKind::length, 2);
    slice("height", SliceKind::length, 1);
    slice("tilt", SliceKind::angle, 1);
    return first;
  }

  Feature& feature_named(const JsonNode& node) const {
    const int found = face_.find_feature(in_.string(node), eye_.side);
    if (found >= 0) return face_.model.features[std::size_t(found)];
    std::vector<std::string_view> known;
    for (const Feature& f : face_.model.features) known.push_back(author_name(f));
    in_.refuse(node, unknown_name("feature", in_.string(node), known));
  }

  /// The opening's own points move with it already.
  void add_rider(int slice, bool upper, double a, double b) {
    for (const int own : {eye_.inner, eye_.outer, eye_.upper, eye_.lower})
      if (slice == own) return;
    eye_.riders.push_back({slice, upper, a, b});
  }

  Reading& in_;
  const JsonNode& node_;
  FaceDraft& face_;
  const JsonNode* instead_;
  bool mirrored_;
  Eye eye_{};
};

/// One eye of the file: one ball, or one for each side.
void read_eye(Reading& in, const JsonNode& node, FaceDraft& face) {
  constexpr std::array<std::string_view, 14> kKnown{
      "center", "radius", "depth", "cornea", "bulge",  "bulge_law", "reach",
      "gaze",   "lids",   "name",  "side",   "mirror", "left",      "right"};
  constexpr std::size_t kOwn = 9;  // those that may differ on a side come first
  in.expect_object(node, kKnown, "eye");
  const JsonNode& name_node = in.need(node, "name");
  const std::string name = in.name(name_node);
  const auto add = [&](Side side, bool mirrored) {
    std::string sided = feature_of_side(name, side);
    if (name == "palette" || face.feature_named(sided) >= 0 ||
        face.model.layout.find(sided + "/center") >= 0)
      in.refuse(name_node, fmt::format("the name {} is taken", in_quotes(sided)));
    if (side != Side::none)
      if (const JsonNode* instead = in.find(node, side_name(side)))
        in.expect_object(*instead, std::span(kKnown).first(kOwn), "eye");
    EyeReader(in, node, face, std::move(sided), side, mirrored).read();
  };
  const JsonNode* side_node = in.find(node, "side");
  if (!side_node) return add(Side::none, false);
  const Side side = in.word(*side_node, "side", kSides) == 0 ? Side::left : Side::right;
  add(side, false);
  const JsonNode* mirror = in.find(node, "mirror");
  if (!mirror || in.boolean(*mirror)) add(other(side), true);
}

}  // namespace

void read_eyes(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::array);
  in.for_each(node, [&](const JsonNode& child, int) { read_eye(in, child, face); });
}

}  // namespace mien
