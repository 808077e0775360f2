#include <mien/lib/rig/unwrap.h>

#include <mien/lib/face/face_model.h>
#include <mien/lib/geom/box2.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

namespace mien {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kFilled = 0.8;  ///< share of a cell that a piece may take

/// Which features hang together, numbered in drawing order.
class Pieces {
 public:
  explicit Pieces(const FaceModel& model) : first_(model.features.size()) {
    for (std::size_t i = 0; i < first_.size(); ++i) first_[i] = i;
    std::unordered_map<int, std::size_t> owner;
    for (std::size_t i = 0; i < first_.size(); ++i) {
      const Feature& f = model.features[i];
      if (f.clip >= 0) join(i, std::size_t(f.clip));
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
  glm::dvec2 lo{kEndless}, hi{-kEndless};
};

/// How far a figure of one point reaches around it; 0 for those of many.
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
  return glm::dvec2(0);
}

/// How deep a slice lies, by the head's ellipsoid; 0 without one.
double depth_of(const FaceModel& model, int slice, glm::dvec2 p) {
  const HeadTurn& head = model.turn;
  for (const TurnedSlice& turned : head.slices) {
    if (turned.slice != slice) continue;
    if (turned.kind == TurnKind::flat) return turned.depth;
    const double x = (p.x - head.center.x) / head.radii.x, y = (p.y - head.center.y) / head.radii.y;
    return turned.depth + head.radii.z * std::sqrt(std::max(0.0, 1 - x * x - y * y));
  }
  return 0;
}

}  // namespace

double unwrap_progress(UnwrapMode mode, double w, double r) {
  if (mode == UnwrapMode::linear || w >= 1) return std::clamp(w, 0.0, 1.0);
  const double late = w > r ? (w - r) / (1 - r) : 0;
  return mode == UnwrapMode::sine ? std::sin(0.5 * std::numbers::pi * late) : late;
}

UnwrapChart::UnwrapChart(const Face& rest) {
  const FaceModel& model = *rest.model;
  const Layout& layout = model.layout;
  const auto point = [&](int slice) {
    const double* at = &rest.vector[std::size_t(layout[slice].begin)];
    return glm::dvec2{at[0], at[1]};
  };
  const Pieces pieces(model);
  std::unordered_set<std::size_t> fixed;  // a band has no points to travel with: its piece stays
  for (std::size_t i = 0; i < model.features.size(); ++i)
    if (std::holds_alternative<BandFigure>(model.features[i].figure)) fixed.insert(pieces.of(i));
  std::vector<std::size_t> order;  // of the pieces that have points
  std::unordered_map<std::size_t, Piece> boxes;
  for (std::size_t i = 0; i < model.features.size(); ++i) {
    const glm::dvec2 around = radii_of(model.features[i].figure, rest);
    for_each_slice(model.features[i].figure, [&](std::string_view, int slice) {
      if (layout[slice].kind != SliceKind::point || fixed.contains(pieces.of(i))) return;
      const auto [at, added] = boxes.emplace(pieces.of(i), Piece{});
      if (added) order.push_back(pieces.of(i));
      at->second.lo = glm::min(at->second.lo, point(slice) - around);
      at->second.hi = glm::max(at->second.hi, point(slice) + around);
    });
  }

  const Box2& canvas = model.canvas.box;
  const glm::dvec2 size = canvas.hi - canvas.lo;
  const double count = double(std::max<std::size_t>(order.size(), 1));
  const double columns = std::ceil(std::sqrt(count * size.x / size.y));
  const double rows = std::ceil(count / columns);
  const glm::dvec2 cell{size.x / columns, size.y / rows};

  double deepest = kEndless, nearest = -kEndless;
  std::vector<char> seen(layout.slices().size());
  for (std::size_t i = 0; i < model.features.size(); ++i) {
    const auto found = boxes.find(pieces.of(i));
    if (found == boxes.end()) continue;
    const auto place = double(std::find(order.begin(), order.end(), found->first) - order.begin());
    const Piece& box = found->second;
    const glm::dvec2 wide = glm::max(box.hi - box.lo, glm::dvec2(1e-9));
    const double scale = std::min({1.0, kFilled * cell.x / wide.x, kFilled * cell.y / wide.y});
    const double row = std::floor(place / columns), column = place - row * columns;
    const double down = model.canvas.y_up ? rows - 0.5 - row : row + 0.5;
    const glm::dvec2 to = canvas.lo + glm::dvec2{(column + 0.5) * cell.x, down * cell.y};
    const glm::dvec2 middle = 0.5 * (box.lo + box.hi);
    double piece_depth = 0;
    for_each_slice(model.features[i].figure, [&](std::string_view, int slice) {
      const Slice& s = layout[slice];
      const bool is_point = s.kind == SliceKind::point;
      if (!is_point && s.kind != SliceKind::length && s.kind != SliceKind::shift) return;
      if (is_point) piece_depth = depth_of(model, slice, point(slice));
      if (seen[std::size_t(slice)]++) return;
      deepest = std::min(deepest, piece_depth), nearest = std::max(nearest, piece_depth);
      travellers_.push_back({s.begin, s.size, is_point, middle, to, scale, piece_depth});
    });
  }
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
