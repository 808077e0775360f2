// The muscles of a face file, and what they hold on to.

#include "lib/file/face/read_muscles.h"
#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace mien {
namespace {

constexpr std::string_view kScale = "/scale";

/// A number between two bounds.
double bounded(const Reading& in, const JsonNode& node, double lo, double hi,
               std::string_view what) {
  const double number = in.number(node);
  if (!(number >= lo && number <= hi))
    in.refuse(node, fmt::format("{} goes from {} to {}, got {}", what, lo, hi, number));
  return number;
}

/// What an attachment's name refers to on a side.
struct Held {
  int slice;
  int component;  ///< −1: the feature's size; −2: a point
};
constexpr int kPoint = -2;

class MuscleReader {
 public:
  MuscleReader(Reading& in, FaceDraft& face) : in_(in), face_(face) {}

  void read(const JsonNode& node) {
    in_.expect_object(node, {"stiffness", "damping", "groups"}, "muscle system");
    MuscleSystem& system = face_.model.muscles;
    system.stiffness =
        bounded(in_, in_.need(node, "stiffness"), kLeastStiffness, kMostStiffness, "stiffness");
    system.damping =
        bounded(in_, in_.need(node, "damping"), kLeastDamping, kMostDamping, "damping");
    const JsonNode& groups = in_.need(node, "groups");
    in_.expect(groups, JsonKind::array);
    in_.for_each(groups, [&](const JsonNode& group, int) { read_group(group); });
  }

 private:
  void read_group(const JsonNode& node) {
    for (const std::string_view side : kSides)
      if (const JsonNode* instead = in_.find(node, side))
        in_.expect_object(*instead, {"strength", "stroke", "origin", "attach"}, "muscle");
    in_.expect_object(
        node, {"name", "side", "mirror", "strength", "stroke", "origin", "attach", "left", "right"},
        "muscle");
    const JsonNode& name_node = in_.need(node, "name");
    const std::string_view name = in_.checked_name(name_node, in_.string(name_node));
    const std::string_view control = face_.model.names.keep({"muscle.", name});
    const std::string_view kept = control.substr(control.size() - name.size());
    const JsonNode* side_node = in_.find(node, "side");
    const JsonNode* mirror = in_.find(node, "mirror");
    std::array<SidedChannel, 2> channels{};
    std::size_t count = 0;
    const auto add = [&] {
      face_.add_control(in_, name_node, {control, "pull", {}}, std::span(channels).first(count));
    };
    if (!side_node) {
      for (const std::string_view key : {"mirror", "left", "right"})
        if (const JsonNode* found = in_.find(node, key))
          in_.refuse(*found,
                     fmt::format("\"{}\" needs a \"side\": the one that the muscle is on", key));
      channels[count++] = {Side::none, add_muscle(node, kept, Side::none, false)};
      return add();
    }
    const Side written = in_.word(*side_node, "side", kSides) == 0 ? Side::left : Side::right;
    const bool mirrored = !mirror || in_.boolean(*mirror);
    for (const Side side : {Side::left, Side::right}) {
      if (side != written && !mirrored) continue;
      channels[count++] = {side, add_muscle(node, kept, side, side != written)};
    }
    add();
  }

  /// Returns the channel of its pull.
  Index<Channel> add_muscle(const JsonNode& node, std::string_view name, Side side, bool mirrored) {
    const JsonNode* instead = side == Side::none ? nullptr : in_.find(node, side_name(side));
    const auto field = [&](std::string_view key) -> std::pair<const JsonNode&, bool> {
      if (instead)
        if (const JsonNode* own = in_.find(*instead, key)) return {*own, false};
      return {in_.need(node, key), mirrored};
    };
    Muscle muscle{.name = name, .side = side};
    muscle.strength = bounded(in_, field("strength").first, 0, kMostStrength, "a strength");
    muscle.stroke = bounded(in_, field("stroke").first, 0, in_.limits.magnitude, "a stroke");
    const auto [origin_node, origin_mirrored] = field("origin");
    const glm::dvec2 at = in_.pair(origin_node);
    std::array<double, 2> origin{at.x, at.y};
    if (origin_mirrored) mirror_values(SliceKind::point, origin, face_.model.canvas.twice_axis());
    muscle.origin = {origin[0], origin[1]};
    muscle.channel = face_.add_channel({.rest = 0, .lo = 0, .hi = 1});
    face_.model.muscles.muscles.push_back(muscle);
    const auto [attach, attach_mirrored] = field("attach");
    read_attachments(attach, last_of(face_.model.muscles.muscles), attach_mirrored);
    return muscle.channel;
  }

  void read_attachments(const JsonNode& node, Index<Muscle> muscle, bool mirrored) {
    in_.expect(node, JsonKind::object);
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string_view name = in_.tree.key(child);
      if (name == "comment") return;
      for_each_held(child, name, muscle.in(face_.model.muscles.muscles).side,
                    [&](Held held) { attach(child, muscle, held, mirrored); });
    });
  }

  void attach(const JsonNode& node, Index<Muscle> muscle, Held held, bool mirrored) {
    MuscleHold hold{muscle, 0};
    const bool long_form = node.kind == JsonKind::object;
    if (long_form) in_.expect_object(node, {"weight", "stroke"}, "attachment");
    hold.weight = bounded(in_, long_form ? in_.need(node, "weight") : node, 0, 1, "a weight");
    const JsonNode* stroke = long_form ? in_.find(node, "stroke") : nullptr;
    if (held.component == kPoint) {
      if (stroke) in_.refuse(*stroke, "points follow their muscle's own stroke");
      hold_point(held.slice, hold);
      return;
    }
    const Muscle& m = muscle.in(face_.model.muscles.muscles);
    if (stroke)
      hold.stroke = in_.number(*stroke);
    else if (held.component < 0)
      hold.stroke = -m.stroke / size_of(node, held.slice);
    else
      in_.refuse(node, "a number needs a stroke: {\"weight\": …, \"stroke\": …}");
    if (mirrored && held.component >= 0 && face_.model.layout[held.slice].kind == SliceKind::angle)
      hold.stroke = 0 - hold.stroke;
    hold_number(held, hold);
  }

  /// The mean radius of a feature whose size a muscle holds. A stroke counts relative to it: the muscle
  /// pulls the rim towards the centre.
  double size_of(const JsonNode& node, int slice) const {
    const Slice& s = face_.model.layout[slice];
    double sum = 0;
    for (int i = 0; i < s.size; ++i) sum += face_.vector[std::size_t(s.begin + i)];
    if (!(sum > 0)) in_.refuse(node, fmt::format("{} is 0: nothing to scale", in_quotes(s.name)));
    return sum / s.size;
  }

  /// A point and its mirror image that both lie on the axis are one point.
  void hold_point(int slice, MuscleHold hold) {
    const int twin = twin_of(slice);
    const int key = twin < 0 ? slice : std::min(slice, twin);
    std::vector<MusclePoint>& points = face_.model.muscles.points;
    point_of_.resize(face_.model.layout.slices().size(), -1);
    int& point = point_of_[std::size_t(key)];
    if (point < 0) {
      point = int(points.size());
      points.push_back({key, twin < 0 ? -1 : std::max(slice, twin), {}});
      points.back().holds.reserve(4);
    }
    points[std::size_t(point)].holds.push_back(hold);
  }

  int twin_of(int slice) const {
    const Slice& s = face_.model.layout[slice];
    const std::size_t slash = s.name.find('/');
    const int feature = face_.feature_named(s.name.substr(0, slash));
    if (feature < 0) return -1;
    const Feature& f = face_.model.features[std::size_t(feature)];
    if (f.side == Side::none) return -1;
    const std::string_view name = f.name.substr(0, f.name.size() - side_name(f.side).size() - 1);
    const int twin = face_.find_slice_of(name, other(f.side), s.name.substr(slash));
    if (twin < 0) return -1;
    const double axis = face_.model.canvas.mirror_x;
    const auto x = [&](int at) { return face_.vector[std::size_t(face_.model.layout[at].begin)]; };
    return x(slice) == axis && x(twin) == axis ? twin : -1;
  }

  void hold_number(Held held, MuscleHold hold) {
    std::vector<MuscleNumber>& numbers = face_.model.muscles.numbers;
    const Layout& layout = face_.model.layout;
    number_of_.resize(layout.size() + layout.slices().size(), -1);
    int& number =
        number_of_[held.component < 0 ? layout.size() + std::size_t(held.slice)
                                      : std::size_t(layout[held.slice].begin + held.component)];
    if (number < 0) {
      number = int(numbers.size());
      numbers.push_back({held.slice, held.component, {}});
    }
    numbers[std::size_t(number)].holds.push_back(hold);
  }

  /// What a name refers to: for a muscle of a side, its own side; for a muscle without one, both sides.
  template <class Each>
  void for_each_held(const JsonNode& node, std::string_view name, Side side, Each&& each) const {
    bool any = false;
    const auto look = [&](Side s) {
      if (const std::optional<Held> held = find(node, name, s)) each(*held), any = true;
    };
    look(side);
    if (!any && side == Side::none) look(Side::left), look(Side::right);
    if (any) return;
    const std::vector<std::string> known = known_names();
    in_.refuse(node, unknown_name("point or number", name, {known.begin(), known.end()}));
  }

  std::optional<Held> find(const JsonNode& node, std::string_view name, Side side) const {
    if (const int slice = face_.find_slice(name, side); slice >= 0) {
      const Slice& s = face_.model.layout[slice];
      if (s.kind == SliceKind::point) return Held{slice, kPoint};
      if (s.size == 1) return Held{slice, 0};
      in_.refuse(node, fmt::format("{} is {} numbers: say which, like \"{}/{}\"", in_quotes(name),
                                   s.size, name, component_name(s.kind, 0)));
    }
    if (name.ends_with(kScale)) {
      const int feature = face_.find_feature(name.substr(0, name.size() - kScale.size()), side);
      if (feature >= 0) return Held{size_slice(node, name, feature), -1};
    }
    const std::size_t slash = name.rfind('/');
    if (slash == std::string_view::npos) return {};
    const int slice = face_.find_slice(name.substr(0, slash), side);
    if (slice < 0) return {};
    const Slice& s = face_.model.layout[slice];
    for (int i = 0; i < s.size; ++i)
      if (component_name(s.kind, i) == name.substr(slash + 1)) {
        if (s.kind == SliceKind::point)
          in_.refuse(node,
                     fmt::format("muscles hold points as a whole: \"{}\"", name.substr(0, slash)));
        return Held{slice, i};
      }
    return {};
  }

  /// The radius or radii of a feature.
  int size_slice(const JsonNode& node, std::string_view name, int feature) const {
    int size = -1;
    for_each_slice(face_.model.features[std::size_t(feature)].figure,
                   [&](std::string_view part, int slice) {
                     if (part == "radius" || part == "radii") size = slice;
                   });
    if (size < 0)
      in_.refuse(node, fmt::format("{}: only discs and ellipses have a scale", in_quotes(name)));
    return size;
  }

  /// Everything that can be held, by the names that authors use.
  std::vector<std::string> known_names() const {
    std::vector<std::string> names;
    for (const Slice& slice : face_.model.layout.slices()) {
      const std::string_view feature = slice.name.substr(0, slice.name.find('/'));
      const int found = face_.feature_named(feature);
      std::string name(slice.name);
      if (found >= 0) {
        const Side side = face_.model.features[std::size_t(found)].side;
        if (side != Side::none)
          name.erase(feature.size() - side_name(side).size() - 1, side_name(side).size() + 1);
      }
      const std::size_t slash = name.find('/');
      const std::string_view part = std::string_view{name}.substr(slash + 1);
      if (part == "radius" || part == "radii") names.push_back(name.substr(0, slash) + "/scale");
      names.push_back(std::move(name));
    }
    return names;
  }

  Reading& in_;
  FaceDraft& face_;
  std::vector<int> point_of_;   ///< by slice; −1: not held
  std::vector<int> number_of_;  ///< by number of the face vector, then by slice whose size is held
};

}  // namespace

void read_muscles(Reading& in, const JsonNode& node, FaceDraft& face) {
  MuscleReader(in, face).read(node);
}

}  // namespace mien
