#include "lib/rig/pose/unwrap.h"

#include <mien/box2.h>
#include <mien/face_model.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

namespace mien {
namespace {

constexpr double kNoDepth = std::numeric_limits<double>::infinity();
constexpr double kFilled = 0.8;  ///< share of a cell that a piece may take

/// Connected features as pieces, numbered in drawing order.
class Pieces {
 public:
  explicit Pieces(const FaceModel& model) : first_(model.features.size()) {
    for (std::size_t i = 0; i < first_.size(); ++i) first_[i] = i;
    std::unordered_map<int, std::size_t> owner;
    for (std::size_t i = 0; i < first_.size(); ++i) {
      const Feature& f = model.features[i];
      for (const FeatureClip& clip : f.clips) join(i, std::size_t(clip.feature.at));
      for_each_slice(f.figure, [&](std::string_view, int slice) {
        if (model.layout[slice].kind == SliceKind::point)
          if (const auto [at, added] = owner.emplace(slice, i); !added) join(i, at->second);
      });
    }
  }

  std::size_t of(std::size_t feature) const {
    while (first_[feature] != feature) feature = first_[feature];
    return feature;
  }

 private:
  void join(std::size_t a, std::size_t b) {
    a = of(a), b = of(b);
    first_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::size_t> first_;
};

struct Piece {
  glm::dvec2 lo{kNoDepth}, hi{-kNoDepth};
};

/// The extent of a figure about its only point; 0 for figures of several points.
glm::dvec2 radii_of(const Figure& figure, const Face& face) {
  const auto number = [&](int slice, int i) {
    return face.vector[std::size_t(face.model->layout[slice].begin + i)];
  };
  if (const auto* ellipse = std::get_if<EllipseFigure>(&figure))
    return {number(ellipse->radii, 0), number(ellipse->radii, 1)};
  if (const auto* disc = std::get_if<DiscFigure>(&figure))
    return glm::dvec2(number(disc->radius, 0));
  if (const auto* cut = std::get_if<CutDiscFigure>(&figure))
    return glm::dvec2(number(cut->radius, 0));
  if (const auto* text = std::get_if<TextFigure>(&figure))
    return 0.5 * number(text->height, 0) * glm::dvec2{text->outline->width, 1};
  return glm::dvec2(0);
}

/// How deep a slice lies, by the head's ellipsoid; 0 without one.
double depth_of(const FaceModel& model, int slice, glm::dvec2 p) {
  const HeadTurn& head = model.turn;
  for (const TurnedSlice& turned : head.slices) {
    if (turned.slice != slice) continue;
    if (turned.kind == TurnKind::flat || turned.kind == TurnKind::plate) return turned.depth;
    if (turned.kind == TurnKind::body) return 0;
    const double x = (p.x - head.center.x) / head.radii.x, y = (p.y - head.center.y) / head.radii.y;
    return turned.depth + head.radii.z * std::sqrt(std::max(0.0, 1 - x * x - y * y));
  }
  return 0;
}

/// Pieces that travel, in drawing order, and how large they are.
struct Boxes {
  std::vector<std::size_t> order;
  std::unordered_map<std::size_t, Piece> of;
};

glm::dvec2 point_at(const Face& face, int slice) {
  const double* at = &face.vector[std::size_t(face.model->layout[slice].begin)];
  return {at[0], at[1]};
}

Boxes boxes_of(const Face& rest, const Pieces& pieces) {
  const FaceModel& model = *rest.model;
  std::unordered_set<std::size_t> fixed;  // a band has no points to travel with: its piece stays
  for (std::size_t i = 0; i < model.features.size(); ++i)
    if (std::holds_alternative<BandFigure>(model.features[i].figure)) fixed.insert(pieces.of(i));
  Boxes boxes;
  for (std::size_t i = 0; i < model.features.size(); ++i) {
    const glm::dvec2 around = radii_of(model.features[i].figure, rest);
    for_each_slice(model.features[i].figure, [&](std::string_view, int slice) {
      if (model.layout[slice].kind != SliceKind::point || fixed.contains(pieces.of(i))) return;
      const auto [at, added] = boxes.of.emplace(pieces.of(i), Piece{});
      if (added) boxes.order.push_back(pieces.of(i));
      at->second.lo = glm::min(at->second.lo, point_at(rest, slice) - around);
      at->second.hi = glm::max(at->second.hi, point_at(rest, slice) + around);
    });
  }
  return boxes;
}

/// The slices of a feature's gradient and relief: visit(slice, whether it is a height).
template <class Visit>
void for_each_paint_slice(const FaceModel& model, const Feature& feature, Visit&& visit) {
  const auto travel = [&](int slice) {
    if (slice >= 0) visit(slice, false);
  };
  if (feature.gradient) {
    const auto& along = feature.gradient.in(model.gradients).along;
    if (const auto* linear = std::get_if<LinearPaint>(&along))
      travel(linear->from), travel(linear->to);
    else if (const auto* radial = std::get_if<RadialPaint>(&along))
      travel(radial->center), travel(radial->radii);
    else if (const auto* distance = std::get_if<DistancePaint>(&along))
      travel(distance->inside), travel(distance->outside);
  }
  if (!feature.relief) return;
  const FaceRelief& relief = feature.relief.in(model.reliefs);
  travel(relief.width);
  if (relief.height >= 0) visit(relief.height, true);
  for (const FaceDome& dome : relief.domes)
    travel(dome.center), travel(dome.radii), visit(dome.height, true);
}

/// The chart's cells: as many as there are pieces or a few more, row by row from the top of the canvas.
class Cells {
 public:
  Cells(const FaceCanvas& canvas, std::size_t pieces) : canvas_(canvas) {
    const glm::dvec2 size = canvas.box.hi - canvas.box.lo;
    const double count = double(std::max<std::size_t>(pieces, 1));
    columns_ = std::ceil(std::sqrt(count * size.x / size.y));
    rows_ = std::ceil(count / columns_);
    cell_ = {size.x / columns_, size.y / rows_};
  }

  glm::dvec2 middle(std::size_t place) const {
    const double row = std::floor(double(place) / columns_),
                 column = double(place) - row * columns_;
    const double down = canvas_.y_up ? rows_ - 0.5 - row : row + 0.5;
    return canvas_.box.lo + glm::dvec2{(column + 0.5) * cell_.x, down * cell_.y};
  }

  /// How much smaller a piece of this size becomes; at most 1.
  double scale(glm::dvec2 size) const {
    const glm::dvec2 wide = glm::max(size, glm::dvec2(1e-9));
    return std::min({1.0, kFilled * cell_.x / wide.x, kFilled * cell_.y / wide.y});
  }

 private:
  const FaceCanvas& canvas_;
  double columns_, rows_;
  glm::dvec2 cell_;
};

}  // namespace

double unwrap_progress(UnwrapMode mode, double w, double r) {
  if (mode == UnwrapMode::linear || w >= 1) return std::clamp(w, 0.0, 1.0);
  const double late = w > r ? (w - r) / (1 - r) : 0;
  return mode == UnwrapMode::sine ? std::sin(0.5 * std::numbers::pi * late) : late;
}

UnwrapChart::UnwrapChart(const Face& rest) {
  const FaceModel& model = *rest.model;
  const Pieces pieces(model);
  const Boxes boxes = boxes_of(rest, pieces);
  const Cells cells(model.canvas, boxes.order.size());
  std::vector<char> seen(model.layout.slices().size());
  for (std::size_t i = 0; i < model.features.size(); ++i) {
    const auto found = boxes.of.find(pieces.of(i));
    if (found == boxes.of.end()) continue;
    const auto place = std::find(boxes.order.begin(), boxes.order.end(), found->first);
    const Piece& box = found->second;
    const double scale = cells.scale(box.hi - box.lo);
    Traveller next{.from = 0.5 * (box.lo + box.hi),
                   .to = cells.middle(std::size_t(place - boxes.order.begin())),
                   .scale = scale};
    const auto travel = [&](int slice, bool rise) {
      const Slice& s = model.layout[slice];
      next.point = s.kind == SliceKind::point;
      if (!next.point && s.kind != SliceKind::length && s.kind != SliceKind::shift) return;
      if (seen[std::size_t(slice)]++) return;
      next.begin = s.begin, next.size = s.size, next.scale = rise ? 0 : scale;
      travellers_.push_back(next);
    };
    for_each_slice(model.features[i].figure, [&](std::string_view, int slice) {
      if (model.layout[slice].kind == SliceKind::point)
        next.share = depth_of(model, slice, point_at(rest, slice));
      travel(slice, false);
    });
    for_each_paint_slice(model, model.features[i], travel);
  }
  share_depths();
}

void UnwrapChart::share_depths() {
  double deepest = kNoDepth, nearest = -kNoDepth;
  for (const Traveller& t : travellers_)
    deepest = std::min(deepest, t.share), nearest = std::max(nearest, t.share);
  for (Traveller& t : travellers_)
    t.share = nearest > deepest ? (t.share - deepest) / (nearest - deepest) : 0;
}

void UnwrapChart::act(UnwrapMode mode, double w, FaceVector& vector) const {
  if (!(w > 0)) return;
  for (const Traveller& t : travellers_) {
    const double v = unwrap_progress(mode, w, t.share);
    double* at = &vector[std::size_t(t.begin)];
    if (t.point)
      for (int i = 0; i < 2; ++i) at[i] += v * (t.to[i] + t.scale * (at[i] - t.from[i]) - at[i]);
    else
      for (int i = 0; i < t.size; ++i) at[i] += v * (t.scale * at[i] - at[i]);
  }
}

}  // namespace mien
