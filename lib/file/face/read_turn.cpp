// The turning head of a face file: how deep each feature lies.

#include <mien/side.h>
#include "face_draft_private.h"
#include "lib/base/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace mien {
namespace {

class TurnReader {
 public:
  TurnReader(Reading& in, const JsonNode& node, FaceDraft& face)
      : in_(in), node_(node), face_(face), turn_(face.model.turn) {}

  void read() {
    in_.expect_object(node_,
                      {"yaw", "pitch", "roll", "nearer", "pivot", "center", "radii", "still",
                       "flat", "raised", "plate", "skull", "body"},
                      "turn");
    turn_.yaw = channel("yaw"), turn_.pitch = channel("pitch"), turn_.roll = channel("roll");
    turn_.nearer = channel("nearer");
    const std::array<double, 3> pivot = in_.three(in_.need(node_, "pivot"));
    turn_.pivot = {pivot[0], pivot[1], pivot[2]};
    turn_.center = in_.pair(in_.need(node_, "center"));
    const std::array<double, 3> radii = in_.three(in_.need(node_, "radii"));
    for (const double r : radii)
      if (!(r > 0))
        in_.refuse(in_.need(node_, "radii"), fmt::format("a radius must be positive, got {}", r));
    turn_.radii = {radii[0], radii[1], radii[2]};
    if (const JsonNode* skull = in_.find(node_, "skull")) turn_.skull = positive(*skull);
    places_.resize(face_.model.features.size());
    seen_.resize(face_.model.layout.slices().size());
    read_places();
    turn_.slices.reserve(seen_.size());
    for (std::size_t i = 0; i < places_.size(); ++i)
      add_feature(face_.model.features[i], places_[i]);
    for (const Eye& eye : face_.model.eyes)
      if (eye.dome >= 0) {
        add({eye.dome, TurnKind::surface});
        add({eye.dome + 1, TurnKind::width, 0, eye.dome});
        add({eye.dome + 3, TurnKind::angle});
      }
  }

 private:
  double positive(const JsonNode& node) const {
    const double length = in_.number(node);
    if (!(length > 0))
      in_.refuse(node, fmt::format("a length of the head must be positive, got {}", length));
    return length;
  }

  struct Place {
    TurnKind kind = TurnKind::surface;
    double depth = 0;
  };

  Index<Channel> channel(std::string_view key) const {
    const JsonNode* node = in_.find(node_, key);
    if (!node) return {};
    const Control& control =
        face_.control_named(in_, *node, in_.string(*node)).in(face_.model.controls);
    const Index<Channel> found = control.channels[0];
    if (control.channels.size() != 1 || found.in(face_.model.channels).rest != 0)
      in_.refuse(*node, "the control that turns must have no sides and rest at 0");
    return found;
  }

  static std::string_view author_name(const Feature& f) {
    const std::size_t side = f.side == Side::none ? 0 : side_name(f.side).size() + 1;
    return f.name.substr(0, f.name.size() - side);
  }

  /// Places the features that an author calls so; whether there are any.
  bool place_features(std::string_view name, Place where) {
    bool any = false;
    for (const Side side : {Side::none, Side::left, Side::right}) {
      const int found = face_.feature_named(name, side);
      if (found < 0 || face_.model.features[std::size_t(found)].side != side) continue;
      places_[std::size_t(found)] = where, any = true;
    }
    return any;
  }

  /// Places a feature or, by a name like "hair/points/3", a single point of one.
  void place(const JsonNode& node, std::string_view name, Place where) {
    if (name.find('/') != std::string_view::npos) {
      for (const DriveTarget target : face_.targets(in_, node, name, Side::none, false))
        slice_places_.emplace_back(target.slice, where);
      return;
    }
    if (place_features(name, where)) return;
    std::vector<std::string_view> known;
    for (const Feature& f : face_.model.features) known.push_back(author_name(f));
    in_.refuse(node, unknown_name("feature", name, known));
  }

  void place_all(const JsonNode& names, TurnKind kind) {
    in_.expect(names, JsonKind::array);
    in_.for_each(names,
                 [&](const JsonNode& child, int) { place(child, in_.string(child), {kind}); });
  }

  /// {"share": 0.2, "radii": [X, Z], "features": [NAME, …]}: what follows the head.
  void read_body(const JsonNode& node) {
    in_.expect_object(node, {"share", "radii", "features"}, "body");
    turn_.body.share = in_.number(in_.need(node, "share"));
    if (!(turn_.body.share >= 0 && turn_.body.share <= 1))
      in_.refuse(in_.need(node, "share"),
                 fmt::format("a share of the yaw lies between 0 and 1, got {}", turn_.body.share));
    const JsonNode& radii = in_.need(node, "radii");
    in_.numbers(radii, 2, 2);
    const JsonNode& across = *in_.tree.first(radii);
    turn_.body.radii = {positive(across), positive(*in_.tree.next(across))};
    place_all(in_.need(node, "features"), TurnKind::body);
  }

  void read_places() {
    if (const JsonNode* still = in_.find(node_, "still")) place_all(*still, TurnKind::still);
    if (const JsonNode* body = in_.find(node_, "body")) read_body(*body);
    for (const auto& [key, kind] : {std::pair{"flat", TurnKind::flat},
                                    {"raised", TurnKind::surface},
                                    {"plate", TurnKind::plate}})
      if (const JsonNode* depths = in_.find(node_, key)) {
        in_.expect(*depths, JsonKind::object);
        in_.for_each(*depths, [&, kind = kind](const JsonNode& child, int) {
          if (in_.tree.key(child) != "comment")
            place(child, in_.tree.key(child), {kind, in_.number(child)});
        });
      }
    // What was said last of a slice counts.
    std::reverse(slice_places_.begin(), slice_places_.end());
    std::stable_sort(slice_places_.begin(), slice_places_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  /// If features share a slice, the first of them decides how it turns.
  void add(TurnedSlice slice) {
    char& seen = seen_[std::size_t(slice.slice)];
    if (!seen && slice.kind != TurnKind::still) turn_.slices.push_back(slice);
    seen = 1;
  }

  /// Of a point: its own place, or that of its feature.
  Place place_of(int slice, Place feature) const {
    const auto own =
        std::lower_bound(slice_places_.begin(), slice_places_.end(), slice,
                         [](const auto& placed, int wanted) { return placed.first < wanted; });
    return own == slice_places_.end() || own->first != slice ? feature : own->second;
  }

  void add_feature(const Feature& feature, Place where) {
    for_each_slice(feature.figure, [&](std::string_view, int slice) {
      if (face_.model.layout[slice].kind != SliceKind::point) return;
      const Place here = place_of(slice, where);
      add({slice, here.kind, here.depth});
    });
    if (const auto* text = std::get_if<TextFigure>(&feature.figure))
      if (with_the_head(where)) add({text->tilt, TurnKind::angle});
    if (feature.relief) add_domes(feature.relief.in(face_.model.reliefs));
    if (foreshortened(where)) add_sizes(feature.figure, where.kind == TurnKind::plate);
    if (feature.gradient) add_gradient(feature.gradient.in(face_.model.gradients), where);
    if (turn_.nearer && with_the_head(where)) add_lengths(feature.figure);
  }

  /// Domes go with the head where the file tells how deep they lie: those that eyes make follow these.
  void add_domes(const FaceRelief& relief) {
    for (const FaceDome& dome : relief.domes) {
      const Place here = place_of(dome.center, {TurnKind::still});
      if (here.kind != TurnKind::still) add({dome.center, here.kind, here.depth});
    }
  }

  /// What keeps its size as the head turns, and grows as it comes nearer.
  void add_lengths(const Figure& figure) {
    for_each_slice(figure, [&](std::string_view, int slice) {
      if (face_.model.layout[slice].kind == SliceKind::length) add({slice, TurnKind::length});
    });
  }

  static bool with_the_head(const Place& where) {
    return where.kind != TurnKind::still && where.kind != TurnKind::body;
  }

  static bool foreshortened(const Place& where) {
    return where.kind == TurnKind::surface || where.kind == TurnKind::plate;
  }

  void add_sizes(const Figure& figure, bool plate) {
    const TurnKind width = plate ? TurnKind::plate_width : TurnKind::width;
    const TurnKind size = plate ? TurnKind::plate_size : TurnKind::size;
    if (const auto* ellipse = std::get_if<EllipseFigure>(&figure)) {
      add({ellipse->radii, width, 0, ellipse->center});
      if (ellipse->tilt >= 0) add({ellipse->tilt, TurnKind::angle});
    } else if (const auto* rounded = std::get_if<RoundedFigure>(&figure)) {
      add({rounded->radii, width, 0, rounded->center});
      add({rounded->corner, size, 0, rounded->center});
      if (rounded->tilt >= 0) add({rounded->tilt, TurnKind::angle});
    } else if (const auto* disc = std::get_if<DiscFigure>(&figure)) {
      add({disc->radius, size, 0, disc->center});
    } else if (const auto* cut = std::get_if<CutDiscFigure>(&figure)) {
      add({cut->radius, size, 0, cut->center});
    } else if (const auto* text = std::get_if<TextFigure>(&figure)) {
      add({text->height, size, 0, text->center});
    } else if (const auto* scatter = std::get_if<ScatterFigure>(&figure)) {
      const auto& points = scatter->patch.points;
      add({scatter->mark.size, size, 0, points[points.size() / 2]});
    } else if (const auto* repeat = std::get_if<RepeatFigure>(&figure)) {
      add({repeat->mark.size, size, 0, repeat->points[repeat->points.size() / 2]});
    } else if (const auto* opening = std::get_if<OpeningFigure>(&figure);
               opening && opening->shifts >= 0) {
      for (int i = 0; i < 2 * OpeningFigure::kLidBends; ++i)
        add({opening->shifts + i, TurnKind::shift, 0, opening->upper});
    }
  }

  void add_gradient(const GradientPaint& gradient, Place where) {
    if (const auto* linear = std::get_if<LinearPaint>(&gradient.along)) {
      add({linear->from, where.kind, where.depth});
      add({linear->to, where.kind, where.depth});
    } else if (const auto* radial = std::get_if<RadialPaint>(&gradient.along)) {
      add({radial->center, where.kind, where.depth});
      if (turn_.nearer && where.kind == TurnKind::flat) add({radial->radii, TurnKind::length});
      if (!foreshortened(where)) return;
      add({radial->radii, where.kind == TurnKind::plate ? TurnKind::plate_width : TurnKind::width,
           0, radial->center});
      if (radial->tilt >= 0) add({radial->tilt, TurnKind::angle});
    }
  }

  Reading& in_;
  const JsonNode& node_;
  FaceDraft& face_;
  HeadTurn& turn_;
  std::vector<Place> places_;  ///< of the features
  std::vector<std::pair<int, Place>>
      slice_places_;        ///< of points with places of their own, by slice
  std::vector<char> seen_;  ///< of the slices
};

}  // namespace

void read_turn(Reading& in, const JsonNode& node, FaceDraft& face) {
  TurnReader(in, node, face).read();
}

}  // namespace mien
