#include "lib/rig/mouth/mouth.h"

#include <mien/quad_bezier.h>

#include "mouth_vector_private.h"
#include "tongue_private.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace mien {
namespace {

// Lengths are shares of the face's width.
constexpr double kRecede =
    0.034;  // puckered lips come forward: the teeth are seen farther back, so higher
constexpr double kTeethForward = 0.012;  // of the jaw's teeth
// Of the thickness at rest: of shut lips, and of lips that are not.
constexpr double kMostThick = 1.35, kMostThickOpen = 1.18;
constexpr double kPress = 0.45, kRoll = 0.9, kRollCorner = 0.6, kBitten = 0.3;
constexpr double kPuckerThin = 0.1, kPartThin = 0.25, kShrugThick = 0.2, kThrustThick = 0.22;
constexpr double kDimpleThin = 0.12;
// So much of what muscles pull the lower lip down an open jaw takes away.
constexpr double kStretched = 0.5;
constexpr double kStiff = 2.0 / 3;  // of a corner's way in or down a moustache does not go along

double jaw_pull(const Mouth& mouth, const FaceModel& model, const FaceVector& vector) {
  return mouth.open < 0 ? 0 : vector[std::size_t(model.layout[mouth.open].begin)];
}

/// r^0.75, of square roots alone: the same bits everywhere.
double power_of_keeping(double r) {
  const double root = std::sqrt(r);
  return root * std::sqrt(root);
}

/// One mouth of one face, being posed.
class MouthAtWork {
 public:
  MouthAtWork(const FaceModel& model, const FaceVector& rest, FaceVector& before,
              FaceVector& vector)
      : model_(model),
        mouth_(*model.mouth),
        rest_(rest),
        before_(before),
        now_(vector),
        to_(model, vector) {}

  void pose(std::span<const double> values) {
    n_ = mouth_numbers(mouth_, values, jaw_pull(mouth_, model_, now_));
    drawn_ = to_.line(mouth_, rest_);
    was_ = to_.line(mouth_);
    if (n_ == MouthNumbers{} && was_ == drawn_) return;
    before_ = now_;
    carry_by_jaw();
    // A lip that touches the teeth holds them where they were measured.
    const double recede = kRecede * mouth_.width * n_.pucker * (1 - n_.bite);
    for (const int slice : mouth_.skull_teeth) to_.add(slice, {0, recede});
    const std::optional<TeethEdge> teeth = teeth_edge();
    open_ = was_, give_up_gap(), ease_lower_lip();
    shape_lips(n_, {mouth_.drop, mouth_.width, mouth_.seam}, teeth, open_);
    shut_ = closed(open_, n_.close, mouth_.seam);
    place_lips();
    stay_under_nose();
    move_tongue(n_, mouth_, teeth, open_, tongue_share(), lip_bottom(), to_);
    to_.put(mouth_, shut_), shift_lips(open_, shut_);
    for (const MouthRider& rider : mouth_.riders) ride(rider);
    shift_lips(shut_, open_), to_.put(mouth_, open_);
  }

 private:
  std::optional<TeethEdge> teeth_edge() const {
    const auto& [a, b, c] = mouth_.teeth_edge;
    if (a < 0) return {};
    // Where they were drawn: a puckered mouth is measured with the teeth at their place.
    return TeethEdge{to_.get(before_, a), to_.get(before_, b), to_.get(before_, c)};
  }

  /// A mouth that rests open gives its gap up as far as jaw, lips or tongue are at work: then it does what others do.
  void give_up_gap() {
    constexpr double kLips =
        3;  // the jaw opens what the gap gives up; lips and tongue need it gone sooner
    const double lips = n_.part + n_.pucker + n_.funnel + n_.bite + n_.tongue_up +
                        n_.tongue_between + n_.tongue_out + n_.tongue_back +
                        std::max(n_.press[0], n_.press[1]) + std::max(n_.roll[0], n_.roll[1]) +
                        std::max(n_.shrug[0], n_.shrug[1]);
    const double share = std::clamp(n_.jaw + kLips * lips, 0.0, 1.0);
    for (std::size_t bend = 0; bend < 3; ++bend) {
      const double drawn = drawn_.upper[bend].y - drawn_.lower[bend].y;
      const double now = was_.upper[bend].y - was_.lower[bend].y;
      open_.lower[bend].y += share * std::max(0.0, std::min(drawn, now));
    }
  }

  /// Muscles pull a lip that the jaw has stretched less far down.
  void ease_lower_lip() {
    for (std::size_t bend = 0; bend < 3; ++bend) {
      const double pulled = was_.lower[bend].y - drawn_.lower[bend].y;
      open_.lower[bend].y -= kStretched * n_.jaw * std::min(pulled, 0.0);
    }
  }

  void carry_by_jaw() {
    const double drop = mouth_.drop * n_.jaw;
    const double middle = 0.5 * (drawn_.corners[0].x + drawn_.corners[1].x);
    for (const JawShare& share : mouth_.jaw) {
      const glm::dvec2 p = to_.get(share.slice);
      const double inwards = p.x > middle ? -1 : 1;
      to_.put(share.slice,
              {p.x + share.aside * 0.065 * mouth_.width * n_.aside + inwards * share.in * drop,
               p.y - share.down * (drop + kTeethForward * mouth_.width * n_.forward)});
    }
    if (n_.puff == 0) return;
    for (const CheekSwell& swell : mouth_.cheeks)
      to_.add(swell.slice,
              n_.puff * glm::dvec2(swell.by.x, model_.canvas.y_up ? swell.by.y : -swell.by.y));
  }

  /// How thick a lip is on a side, as a share of its thickness at rest: longer lips are thinner.
  double thickness(bool upper, std::size_t side) const {
    const std::size_t lip = upper ? 0 : 1;
    const double length = edge_length(shut_, upper, side);
    const double kept =
        length > 0 ? power_of_keeping(edge_length(drawn_, upper, side) / length) : kMostThick;
    const double roll = upper ? n_.roll[0] : std::max(n_.roll[1], kBitten * n_.bite);
    const double most = kMostThickOpen + (kMostThick - kMostThickOpen) * n_.close;
    return std::min(kept, most) * (1 - kPress * n_.press[side]) * (1 - kRoll * roll) *
           (1 - (upper ? 0 : kPuckerThin * std::max(n_.pucker, n_.funnel))) *
           (1 - kPartThin * n_.part) * (1 + kShrugThick * n_.shrug[lip]) *
           (1 + (upper ? 0 : kThrustThick * n_.forward)) * (1 - kDimpleThin * n_.dimple[side]);
  }

  static const std::array<glm::dvec2, 3>& edge_of(const LipLine& line, bool upper) {
    return upper ? line.upper : line.lower;
  }

  /// Painted lips stand beside the open edges.
  void place_lips() {
    double thick[2][2];
    for (const std::size_t lip : {0u, 1u})
      for (const std::size_t side : {0u, 1u}) thick[lip][side] = thickness(lip == 0, side);
    const auto mean = [&](bool upper) { return 0.5 * (thick[!upper][0] + thick[!upper][1]); };
    for (const LipPoint& point : mouth_.lip_points) {
      const auto bend = std::size_t(point.bend);
      const double by = bend == 1 ? mean(point.upper) : thick[!point.upper][bend == 0 ? 0 : 1];
      const glm::dvec2 was = edge_of(was_, point.upper)[bend];
      const glm::dvec2 beside = to_.get(point.slice) - was;
      to_.add(point.slice, edge_of(open_, point.upper)[bend] - was + (by - 1) * beside);
    }
    for (const LipWidth& width : mouth_.lip_widths) {
      double* w = to_.numbers(width.slice);
      const double by = width.side == 2 ? mean(width.upper) : thick[!width.upper][width.side];
      const double corner = 1 - kRollCorner * n_.roll[width.upper ? 0 : 1];
      for (int i = 0; i < to_.size(width.slice); ++i) w[i] *= i == 2 ? corner : by;
    }
  }

  /// How far the upper lip of a vector whose edges are `line` stands above the nose's base near its middle, on one side; less
  /// than 0: below.
  double above_nose(const FaceVector& v, const LipLine& line, std::size_t side,
                    glm::dvec2 base) const {
    constexpr double kBesideNose = 0.05;  // of the face's width
    constexpr int kPlaces = 8;
    const std::size_t handle = side == 0 ? 0 : 2;
    QuadBezier top{line.upper[1], line.upper[handle], line.corners[side]};
    for (const LipPoint& point : mouth_.lip_points)
      if (point.upper && point.bend == 1)
        top.p0 = to_.get(v, point.slice);
      else if (point.upper && point.bend == int(handle))
        top.p1 = to_.get(v, point.slice);
    if (!line.has_handles) top.p1 = 0.5 * (top.p0 + top.p2);
    std::array<double, 3> widths{};
    for (const LipWidth& width : mouth_.lip_widths)
      if (width.upper && width.side != int(1 - side) && to_.size(width.slice) == 3)
        std::copy_n(to_.numbers(v, width.slice), 3, widths.begin());
    double most = -mouth_.width;
    for (int i = 0; i <= kPlaces; ++i) {
      const double t = double(i) / kPlaces, s = 1 - t;
      const glm::dvec2 p = mien::point(top, t);
      if (std::abs(p.x - base.x) < kBesideNose * mouth_.width)
        most = std::max(
            most, p.y - base.y + s * s * widths[0] + 2 * s * t * widths[1] + t * t * widths[2]);
    }
    return most;
  }
  double above_nose(const FaceVector& v, const LipLine& line) const {
    const glm::dvec2 base = to_.seen(*mouth_.under);
    return std::max(above_nose(v, line, 0, base), above_nose(v, line, 1, base));
  }

  /// What raises the upper lip stops below the nose, unless it is drawn higher, and takes the lower lip along.
  void stay_under_nose() {
    constexpr double kSkin = 0.015;  // between lip and nose, of the face's width
    if (!mouth_.under) return;
    const double over =
        above_nose(now_, open_) - std::max(above_nose(rest_, drawn_), -kSkin * mouth_.width);
    if (!(over > 0)) return;
    const LipLine before = open_;
    for (glm::dvec2& corner : open_.corners) corner.y -= over;
    for (std::size_t bend = 0; bend < 3; ++bend) {
      open_.upper[bend].y -= over;
      open_.lower[bend].y = std::min(open_.lower[bend].y, open_.upper[bend].y);
    }
    shift_lips(before, open_);
    shut_ = closed(open_, n_.close, mouth_.seam);
  }

  void shift_lips(const LipLine& from, const LipLine& to) {
    for (const LipPoint& point : mouth_.lip_points) {
      const auto bend = std::size_t(point.bend);
      to_.add(point.slice, edge_of(to, point.upper)[bend] - edge_of(from, point.upper)[bend]);
    }
  }

  /// Of the mouth's half width, at rest.
  double tongue_share() const {
    const double half = 0.5 * std::abs(drawn_.corners[0].x - drawn_.corners[1].x);
    if (mouth_.tongue.radii < 0 || half == 0) return 0;
    return rest_[std::size_t(model_.layout[mouth_.tongue.radii].begin)] / half;
  }

  double lip_bottom() const {
    for (const LipPoint& point : mouth_.lip_points)
      if (!point.upper && point.bend == 1) return to_.get(point.slice).y;
    return open_.lower[1].y;
  }

  void ride(const MouthRider& rider) {
    glm::dvec2 way{0};
    for (const MouthRider::With& with : rider.with)
      way += with.share * (to_.get(with.slice) - to_.get(before_, with.slice) -
                           (rider.stiff ? folding(with.slice) : glm::dvec2{0}));
    to_.add(rider.slice, way);
  }

  /// The part of a corner's way in or down, against the lip's middle, that would fold what lies over it.
  glm::dvec2 folding(int slice) const {
    for (const std::size_t s : {0u, 1u}) {
      if (mouth_.corners[s].slice != slice) continue;
      const glm::dvec2 way =
          (shut_.corners[s] - drawn_.corners[s]) - (shut_.upper[1] - drawn_.upper[1]);
      const bool right = drawn_.corners[s].x > drawn_.corners[1 - s].x;
      return kStiff *
             glm::dvec2{right ? std::min(way.x, 0.0) : std::max(way.x, 0.0), std::min(way.y, 0.0)};
    }
    return {0, 0};
  }

  const FaceModel& model_;
  const Mouth& mouth_;
  const FaceVector& rest_;
  FaceVector &before_, &now_;
  MouthVector to_;
  MouthNumbers n_;
  LipLine drawn_, was_, open_, shut_;  ///< at rest; before the mouth's laws; after them; and closed
};

}  // namespace

void pose_mouth(const FaceModel& model, const FaceVector& rest, std::span<const double> values,
                FaceVector& before, FaceVector& vector) {
  if (model.mouth) MouthAtWork(model, rest, before, vector).pose(values);
}

void close_lips(const FaceModel& model, std::span<const double> values, FaceVector& vector) {
  if (!model.mouth) return;
  const Mouth& mouth = *model.mouth;
  const double closure = mouth_numbers(mouth, values, 0).close;
  if (closure == 0) return;
  MouthVector to(model, vector);
  const LipLine open = to.line(mouth), shut = closed(open, closure, mouth.seam);
  to.put(mouth, shut);
  for (const LipPoint& point : mouth.lip_points) {
    const auto bend = std::size_t(point.bend);
    to.add(point.slice,
           point.upper ? shut.upper[bend] - open.upper[bend] : shut.lower[bend] - open.lower[bend]);
  }
}

}  // namespace mien
