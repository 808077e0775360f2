// The mouth of a face file: which of its points are corners, edges, lips, teeth and tongue, and what goes with the jaw.

#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mien {
namespace {

constexpr std::string_view kJawSlice = "jaw/open";

class MouthReader {
 public:
  MouthReader(Reading& in, const JsonNode& node, FaceDraft& face)
      : in_(in), node_(node), face_(face) {}

  void read() {
    in_.expect_object(node_,
                      {"corners", "upper", "lower", "seam", "width", "lips", "teeth", "tongue",
                       "jaw", "cheeks", "ride", "stiff", "under"},
                      "mouth");
    read_edges();
    if (const JsonNode* seam = in_.find(node_, "seam")) mouth_.seam = share(*seam, "lips meet");
    if (const JsonNode* under = in_.find(node_, "under")) mouth_.under = in_.pair(*under);
    if (const JsonNode* width = in_.find(node_, "width"))
      mouth_.width = positive(*width, "a face's width");
    if (const JsonNode* lips = in_.find(node_, "lips")) read_lips(*lips);
    if (const JsonNode* teeth = in_.find(node_, "teeth")) read_teeth(*teeth);
    if (const JsonNode* tongue = in_.find(node_, "tongue")) read_tongue(*tongue);
    read_jaw(in_.need(node_, "jaw"));
    if (const JsonNode* cheeks = in_.find(node_, "cheeks")) read_cheeks(*cheeks);
    read_riders();
    add_controls();
    face_.model.mouth = std::move(mouth_);
  }

 private:
  double share(const JsonNode& node, std::string_view what) const {
    const double number = in_.number(node);
    if (!(number >= 0 && number <= 1))
      in_.refuse(node,
                 fmt::format("{} from 0, the upper lip, to 1, the lower, got {}", what, number));
    return number;
  }
  double positive(const JsonNode& node, std::string_view what) const {
    const double number = in_.number(node);
    if (!(number > 0)) in_.refuse(node, fmt::format("{} must be positive, got {}", what, number));
    return number;
  }

  int point(const JsonNode& node, std::string_view name) const {
    const int slice = face_.slice_named(in_, node, name, Side::none);
    if (face_.model.layout[slice].kind != SliceKind::point)
      in_.refuse(node, fmt::format("{} is no point", in_quotes(name)));
    return slice;
  }
  int point(const JsonNode& node) const { return point(node, in_.string(node)); }

  /// "SLICE", or ["SLICE", "SLICE"] for one point that is written on both sides.
  MouthPoint mouth_point(const JsonNode& node) const {
    if (node.kind != JsonKind::array) return {point(node)};
    if (node.count != 2)
      in_.refuse(node,
                 fmt::format("expected a point, or the two that are one, got {}", node.count));
    const JsonNode& first = *in_.tree.first(node);
    const MouthPoint both{point(first), point(*in_.tree.next(first))};
    const auto at = [&](int slice) {
      return &face_.vector[std::size_t(face_.model.layout[slice].begin)];
    };
    if (!std::equal(at(both.slice), at(both.slice) + 2, at(both.twin)))
      in_.warn(node, "the two slices of one point have different places");
    return both;
  }

  void read_edges() {
    const JsonNode& corners = in_.need(node_, "corners");
    in_.expect(corners, JsonKind::array);
    if (corners.count != 2)
      in_.refuse(corners,
                 fmt::format("expected two corners, left and right, got {}", corners.count));
    in_.for_each(corners, [&](const JsonNode& one, int i) {
      mouth_.corners[std::size_t(i)] = mouth_point(one);
    });
    const int upper = read_edge(in_.need(node_, "upper"), mouth_.upper);
    const int lower = read_edge(in_.need(node_, "lower"), mouth_.lower);
    if (upper != lower)
      in_.refuse(in_.need(node_, "lower"),
                 fmt::format("both edges have as many bends: the upper one has {}, this one {}",
                             upper, lower));
    mouth_.has_handles = upper == 3;
  }

  int read_edge(const JsonNode& node, MouthEdge& edge) const {
    in_.expect(node, JsonKind::array);
    const int count = int(node.count);
    if (count != 1 && count != 3)
      in_.refuse(
          node,
          fmt::format("an edge has one bend, or a left handle, a middle and a right handle, got {}",
                      count));
    in_.for_each(node, [&](const JsonNode& one, int i) {
      edge[std::size_t(count == 1 ? 1 : i)] = mouth_point(one);
    });
    return count;
  }

  template <class Each>
  void for_each_key(const JsonNode& node, Each&& each) const {
    in_.expect(node, JsonKind::object);
    in_.for_each(node, [&](const JsonNode& child, int) {
      if (in_.tree.key(child) != "comment") each(child, in_.tree.key(child));
    });
  }

  const Feature& feature(const JsonNode& node) const {
    const int found = face_.feature_named(in_.string(node));
    if (found >= 0) return face_.model.features[std::size_t(found)];
    std::vector<std::string_view> known;
    for (const Feature& f : face_.model.features) known.push_back(f.name);
    in_.refuse(node, unknown_name("feature", in_.string(node), known));
  }

  template <class Kind>
  const Kind& figure(const JsonNode& node, std::string_view kind) const {
    const auto* found = std::get_if<Kind>(&feature(node).figure);
    if (!found) in_.refuse(node, fmt::format("{} is no {}", in_quotes(in_.string(node)), kind));
    return *found;
  }

  bool is_own(int slice) const {
    const auto has = [&](const MouthPoint& p) { return p.slice == slice || p.twin == slice; };
    return std::any_of(mouth_.corners.begin(), mouth_.corners.end(), has) ||
           std::any_of(mouth_.upper.begin(), mouth_.upper.end(), has) ||
           std::any_of(mouth_.lower.begin(), mouth_.lower.end(), has);
  }

  double x(int slice) const { return face_.vector[std::size_t(face_.model.layout[slice].begin)]; }

  /// The bend of an edge that is nearest, across.
  int bend_beside(const MouthEdge& edge, int slice) const {
    int nearest = 1;
    for (const int bend : {0, 2})
      if (const int other = edge[std::size_t(bend)].slice;
          other >= 0 &&
          std::abs(x(other) - x(slice)) < std::abs(x(edge[std::size_t(nearest)].slice) - x(slice)))
        nearest = bend;
    return nearest;
  }

  void read_lips(const JsonNode& node) {
    in_.expect_object(node, {"upper", "lower"}, "lips");
    for (const bool upper : {true, false})
      if (const JsonNode* list = in_.find(node, upper ? "upper" : "lower")) {
        in_.expect(*list, JsonKind::array);
        in_.for_each(*list, [&](const JsonNode& one, int) { read_lip(one, upper); });
      }
  }

  void read_lip(const JsonNode& node, bool upper) {
    const Feature& lip = feature(node);
    const int side = lip.side == Side::none ? 2 : lip.side == Side::left ? 0 : 1;
    for_each_slice(lip.figure, [&](std::string_view part, int slice) {
      if (part == "half_width") mouth_.lip_widths.push_back({slice, upper, side});
      const bool point = face_.model.layout[slice].kind == SliceKind::point;
      const bool known =
          is_own(slice) || std::any_of(mouth_.lip_points.begin(), mouth_.lip_points.end(),
                                       [&](const LipPoint& p) { return p.slice == slice; });
      if (point && !known)
        mouth_.lip_points.push_back(
            {slice, upper, bend_beside(upper ? mouth_.upper : mouth_.lower, slice)});
    });
  }

  void read_teeth(const JsonNode& node) {
    in_.expect_object(node, {"edge", "skull"}, "teeth");
    const JsonNode& edge = in_.need(node, "edge");
    in_.expect(edge, JsonKind::array);
    if (edge.count != 3)
      in_.refuse(edge, fmt::format("expected three bends in a row, got {}", edge.count));
    in_.for_each(
        edge, [&](const JsonNode& one, int i) { mouth_.teeth_edge[std::size_t(i)] = point(one); });
    const JsonNode* skull = in_.find(node, "skull");
    if (!skull) return;
    in_.expect(*skull, JsonKind::array);
    std::vector<const Feature*> teeth;
    in_.for_each(*skull, [&](const JsonNode& one, int) { teeth.push_back(&feature(one)); });
    // What is drawn on them alone belongs to them: gaps, braces.
    for (const Feature& f : face_.model.features)
      if (std::any_of(f.clips.begin(), f.clips.end(), [&](const FeatureClip& clip) {
            return !clip.outside &&
                   std::find(teeth.begin(), teeth.end(), &clip.feature.in(face_.model.features)) !=
                       teeth.end();
          }))
        teeth.push_back(&f);
    for (const Feature* f : teeth) add_points(*f, mouth_.skull_teeth);
  }

  void add_points(const Feature& f, std::vector<int>& to) const {
    for_each_slice(f.figure, [&](std::string_view, int slice) {
      if (face_.model.layout[slice].kind == SliceKind::point && !is_own(slice) &&
          std::find(to.begin(), to.end(), slice) == to.end())
        to.push_back(slice);
    });
  }

  void read_tongue(const JsonNode& node) {
    in_.expect_object(node, {"body", "tip", "out", "groove"}, "tongue");
    MouthTongue& tongue = mouth_.tongue;
    const auto ellipse = [&](std::string_view key, int& center, int& radii) {
      if (const JsonNode* one = in_.find(node, key)) {
        const auto& found = figure<EllipseFigure>(*one, "ellipse");
        center = found.center, radii = found.radii;
      }
    };
    ellipse("body", tongue.center, tongue.radii);
    ellipse("tip", tongue.tip_center, tongue.tip_radii);
    if (const JsonNode* out = in_.find(node, "out")) {
      figure<PathFigure>(*out, "path");
      tongue.out_opacity = opacity(*out, tongue.out);
      if (tongue.out.size() != 7)
        in_.refuse(*out,
                   fmt::format("a tongue that is out has 7 bends, got {}", tongue.out.size()));
    }
    if (const JsonNode* groove = in_.find(node, "groove")) {
      figure<StrokeFigure>(*groove, "stroke");
      tongue.groove_opacity = opacity(*groove, tongue.groove);
    }
  }

  int opacity(const JsonNode& node, std::vector<int>& points) const {
    const Feature& f = feature(node);
    if (f.opacity < 0)
      in_.refuse(node, fmt::format("{} needs an \"opacity\", 0 at rest", in_quotes(f.name)));
    add_points(f, points);
    return f.opacity;
  }

  /// Sums of shares are large where somebody writes lengths for them.
  double of_jaw(const JsonNode& node, double share) const {
    if (!(std::abs(share) <= 2))
      in_.refuse(node, fmt::format("a share of the jaw goes from -2 to 2, got {}", share));
    return share;
  }

  void read_jaw(const JsonNode& node) {
    in_.expect_object(node, {"drop", "shares"}, "jaw");
    mouth_.drop = positive(in_.need(node, "drop"), "the drop of a jaw");
    const JsonNode* shares = in_.find(node, "shares");
    if (!shares) return;
    std::vector<double> numbers;
    mouth_.jaw.reserve(std::size_t(shares->count));
    for_each_key(*shares, [&](const JsonNode& child, std::string_view name) {
      in_.numbers(child, 1, 3, numbers);
      const auto number = [&](std::size_t i, double otherwise) {
        return i < numbers.size() ? of_jaw(child, numbers[i]) : otherwise;
      };
      const int slice = point(child, name);
      if (is_own(slice))
        in_.refuse(child, "corners and edges go with the jaw by the mouth's own law");
      mouth_.jaw.push_back({slice, number(0, 0), number(1, number(0, 0)), number(2, 0)});
    });
  }

  void read_cheeks(const JsonNode& node) {
    for_each_key(node, [&](const JsonNode& child, std::string_view name) {
      mouth_.cheeks.push_back({point(child, name), in_.pair(child)});
    });
  }

  void read_riders() {
    if (const JsonNode* ride = in_.find(node_, "ride"))
      for_each_key(*ride, [&](const JsonNode& child, std::string_view name) {
        MouthRider rider{.slice = point(child, name)};
        if (is_own(rider.slice)) in_.refuse(child, "corners and edges ride on nothing");
        rider.with.reserve(std::size_t(child.count));
        for_each_key(child, [&](const JsonNode& with, std::string_view other) {
          rider.with.push_back({point(with, other), of_jaw(with, in_.number(with))});
        });
        mouth_.riders.push_back(std::move(rider));
      });
    const JsonNode* stiff = in_.find(node_, "stiff");
    if (!stiff) return;
    in_.expect(*stiff, JsonKind::array);
    in_.for_each(*stiff, [&](const JsonNode& one, int) {
      const int slice = point(one);
      const auto found =
          std::find_if(mouth_.riders.begin(), mouth_.riders.end(),
                       [&](const MouthRider& rider) { return rider.slice == slice; });
      if (found == mouth_.riders.end())
        in_.refuse(one, fmt::format("{} does not ride", in_quotes(in_.string(one))));
      found->stiff = true;
    });
  }

  void add_controls() {
    const std::array rest{0.0};
    mouth_.open =
        face_.add_slice(in_, node_, {kJawSlice}, SliceKind::ratio, rest, Written::nowhere);
    for (std::size_t act = 0; act < kMouthActs; ++act) {
      const MouthControl& control = kMouthControls[act];
      const auto channel = [&] {
        return face_.add_channel(
            {.rest = 0, .lo = control.least, .hi = 1, .joins = control.least == 0});
      };
      auto& [left, right] = mouth_.channels[act];
      left = right = channel();
      const Control made{face_.model.names.keep(control.name), "ratio", {}};
      if (control.sided) {
        right = channel();
        face_.add_control(
            in_, node_, made,
            std::array{SidedChannel{Side::left, left}, SidedChannel{Side::right, right}});
      } else {
        face_.add_control(in_, node_, made, std::array{SidedChannel{Side::none, left}});
      }
    }
  }

  Reading& in_;
  const JsonNode& node_;
  FaceDraft& face_;
  Mouth mouth_;
};

}  // namespace

void read_mouth(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::object);
  MouthReader(in, node, face).read();
}

}  // namespace mien
