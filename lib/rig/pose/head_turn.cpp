#include "lib/rig/pose/head_turn.h"

#include <mien/face_model.h>
#include "lib/math/degrees.h"

#include <algorithm>
#include <cmath>

namespace mien {

Turn::Turn(const HeadTurn& head, double yaw, double pitch, double roll, bool y_up, double nearer)
    : head_(head),
      up_(y_up ? 1 : -1),
      roll_degrees_(roll),
      growth_(1 + nearer),
      yaw_(direction_at(yaw)),
      pitch_(direction_at(pitch)),
      roll_(direction_at(roll)),
      body_yaw_(direction_at(head.body.share * yaw)),
      middle_(up_ * (head.center.y - head.pivot.y)) {
  if (head.skull > 0) {
    const double deep = head.skull / head.radii.x * yaw_.y, front = head.radii.z / head.radii.y,
                 back = head.skull / head.radii.y;
    lean_ = std::max(1 - 0.5 * (front * front + back * back), 0.0);
    longer_ = std::sqrt(yaw_.x * yaw_.x + deep * deep) - 1;
  }
}

/// The height of the front over the ellipsoid's middle at a point.
double Turn::height(glm::dvec2 p) const {
  const double x = (p.x - head_.center.x) / head_.radii.x,
               y = (p.y - head_.center.y) / head_.radii.y;
  return head_.radii.z * std::sqrt(std::max(0.0, 1 - x * x - y * y));
}

/// Argument and result have y up.
glm::dvec2 Turn::rolled_up(glm::dvec2 p) const {
  return {p.x * roll_.x - p.y * roll_.y, p.x * roll_.y + p.y * roll_.x};
}

glm::dvec2 Turn::rolled(glm::dvec2 way) const {
  const glm::dvec2 q = rolled_up({way.x, up_ * way.y});
  return {q.x, up_ * q.y};
}

/// Argument and result are relative to the pivot, with y up.
glm::dvec2 Turn::turned(glm::dvec3 v) const {
  if (head_.skull > 0) {
    const double z = v.z * pitch_.x - (v.y - middle_) * pitch_.y;
    return rolled_up({v.x * yaw_.x + z * yaw_.y, v.y * pitch_.x + v.z * pitch_.y});
  }
  const double x = v.x * yaw_.x + v.z * yaw_.y, z = v.z * yaw_.x - v.x * yaw_.y;
  return rolled_up({x, v.y * pitch_.x + z * pitch_.y});
}

namespace {

/// 0 up to `from`, 1 from `to` on, smooth between.
double risen(double at, double from, double to) {
  const double u = std::clamp((at - from) / (to - from), 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

}  // namespace

/// How far a point of an outline goes aside as its head turns, beside what its depth does.
double Turn::outline_shift(glm::dvec2 p) const {
  if (!(head_.skull > 0) || yaw_.y == 0) return 0;
  const double ahead = yaw_.y < 0 ? -1 : 1, a = head_.radii.x;
  const double across =
      ahead * (p.x - head_.center.x) / a;  // 1 at the far edge, −1 at the near one
  const double up = up_ * (p.y - head_.center.y) / head_.radii.y;
  const double edge = std::min(across * across, 1.0);
  if (across < 0) {
    // Above the ear, which is drawn at the edge; wide hair and hats do not grow.
    const double skull = risen(up, 0, 0.8) * (1 - risen(-across, 1.05, 1.6));
    return -ahead * a * edge * 2 * std::max(longer_, 0.0) * skull;
  }
  // The cheekbone stands out; the temple above it, up to where hats begin, is hollow, and the jaw below it narrow.
  constexpr double kCheek = 0.02, kTemple = 0.05, kJaw = 0.09;
  const double cheek = risen(up, -0.3, 0) * (1 - risen(up, 0.2, 0.35));
  const double temple = risen(up, 0.22, 0.4) * (1 - risen(up, 0.4, 0.6));
  const double jaw = 1 - risen(up, -0.9, -0.35);
  return ahead * a * edge * std::abs(yaw_.y) * (kCheek * cheek - kTemple * temple - kJaw * jaw);
}

glm::dvec2 Turn::surface(glm::dvec2 p, double depth) const {
  return plate(p, height(p) + depth);
}

glm::dvec2 Turn::plate(glm::dvec2 p, double depth) const {
  const glm::dvec2 pivot{head_.pivot.x, head_.pivot.y};
  const glm::dvec2 q = turned({p.x - pivot.x, up_ * (p.y - pivot.y), depth - head_.pivot.z});
  return {pivot.x + growth_ * q.x, pivot.y + growth_ * up_ * q.y};
}

glm::dvec2 Turn::plate_foreshortening() const {
  return growth_ * glm::dvec2{std::max(yaw_.x, 0.0), std::max(pitch_.x, 0.0)};
}

glm::dvec2 Turn::flat(glm::dvec2 p, double depth) const {
  const double z = depth - head_.pivot.z, x = p.x - head_.pivot.x + outline_shift(p),
               y = up_ * (p.y - head_.pivot.y);
  // What hangs below the chin hangs upright again.
  const double b = head_.radii.y, above = y - middle_,
               axis = lean_ * (above > -b ? above : std::min(-2 * b - above, 0.0));
  const glm::dvec2 q =
      head_.skull > 0 ? rolled_up({x + (z * pitch_.x - axis * pitch_.y) * yaw_.y, y + z * pitch_.y})
                      : rolled_up({x + z * yaw_.y, y + z * yaw_.x * pitch_.y});
  return {head_.pivot.x + growth_ * q.x, head_.pivot.y + growth_ * up_ * q.y};
}

glm::dvec2 Turn::body(glm::dvec2 p) const {
  const double x = p.x - head_.pivot.x, aside = x / head_.body.radii.x;
  const double z = head_.body.radii.y * std::sqrt(std::max(0.0, 1 - aside * aside));
  return {head_.pivot.x + x * body_yaw_.x + z * body_yaw_.y, p.y};
}

/// The slopes of the turned surface along x and y, by its normal: the height's own slopes are
/// −(rz/rx)² x/h and −(rz/ry)² y/h. They are unbounded at the very edge, where everything is turned away or
/// seen in full; limits keep them finite there.
glm::dvec2 Turn::foreshortening(glm::dvec2 p) const {
  const glm::dvec3 r = head_.radii;
  const double h = std::max(height(p), 0.1 * r.z);
  const double slope_x = -(r.z / r.x) * (r.z / r.x) * (p.x - head_.center.x) / h;
  const double slope_y = -(r.z / r.y) * (r.z / r.y) * up_ * (p.y - head_.center.y) / h;
  const bool whole = head_.skull > 0;
  const double x = yaw_.x + slope_x * yaw_.y * (whole ? pitch_.x : 1),
               y = pitch_.x + slope_y * pitch_.y * (whole ? 1 : yaw_.x);
  return growth_ * glm::dvec2{std::clamp(x, 0.0, 1.5), std::clamp(y, 0.0, 1.5)};
}

namespace {

/// One turn of one face vector.
class Turning {
 public:
  Turning(const FaceModel& model, const Turn& turn, FaceVector& vector)
      : model_(model), turn_(turn), now_(vector) {}

  /// Sizes depend on where their point was before the turn, so sizes are turned first, then points.
  void all() {
    for (const bool points : {false, true})
      for (const TurnedSlice& slice : model_.turn.slices)
        if (is_point(slice.kind) == points) act(slice);
  }

 private:
  static bool is_point(TurnKind kind) {
    return kind == TurnKind::surface || kind == TurnKind::flat || kind == TurnKind::plate ||
           kind == TurnKind::body;
  }
  double* at(int slice) { return &now_[std::size_t(model_.layout[slice].begin)]; }
  void scale(int slice, double by) {
    if (by == 1) return;
    for (int i = 0; i < model_.layout[slice].size; ++i) at(slice)[i] *= by;
  }
  glm::dvec2 point(int slice) { return {at(slice)[0], at(slice)[1]}; }

  glm::dvec2 turned(glm::dvec2 p, const TurnedSlice& slice) const {
    if (slice.kind == TurnKind::flat) return turn_.flat(p, slice.depth);
    if (slice.kind == TurnKind::body) return turn_.body(p);
    if (slice.kind == TurnKind::plate) return turn_.plate(p, slice.depth);
    return turn_.surface(p, slice.depth);
  }

  void act(const TurnedSlice& slice) {
    double* v = at(slice.slice);
    if (slice.kind == TurnKind::angle) {
      v[0] += turn_.tilt();
      return;
    }
    if (is_point(slice.kind)) {
      const glm::dvec2 p = turned({v[0], v[1]}, slice);
      v[0] = p.x, v[1] = p.y;
      return;
    }
    if (slice.kind == TurnKind::length) return scale(slice.slice, turn_.growth());
    const bool level = slice.kind == TurnKind::plate_width || slice.kind == TurnKind::plate_size;
    const glm::dvec2 smaller =
        level ? turn_.plate_foreshortening() : turn_.foreshortening(point(slice.at));
    if (slice.kind == TurnKind::size || slice.kind == TurnKind::plate_size)
      return scale(slice.slice, std::sqrt(smaller.x * smaller.y));
    v[0] *= smaller.x, v[1] *= smaller.y;
    if (slice.kind == TurnKind::shift) {
      const glm::dvec2 way = turn_.rolled({v[0], v[1]});
      v[0] = way.x, v[1] = way.y;
    }
  }

  const FaceModel& model_;
  const Turn& turn_;
  FaceVector& now_;
};

}  // namespace

void turn_head(const FaceModel& model, std::span<const double> values, FaceVector& vector) {
  const HeadTurn& head = model.turn;
  const auto value = [&](Index<Channel> channel) {
    return channel ? values[std::size_t(channel.at)] : 0;
  };
  const double yaw = value(head.yaw), pitch = value(head.pitch), roll = value(head.roll);
  const double nearer = value(head.nearer);
  if (yaw == 0 && pitch == 0 && roll == 0 && nearer == 0) return;
  Turning(model, Turn(head, yaw, pitch, roll, model.canvas.y_up, nearer), vector).all();
}

}  // namespace mien
