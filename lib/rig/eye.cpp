#include <mien/lib/rig/eye.h>

#include <mien/lib/face/face_model.h>
#include <mien/lib/rig/blink.h>
#include <mien/lib/rig/gaze.h>
#include <mien/lib/rig/lid.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace mien {
namespace {

constexpr std::size_t kBends = OpeningFigure::kLidBends;

/// One eye of one face, being posed.
class EyeAtWork {
 public:
  EyeAtWork(const FaceModel& model, const Eye& eye, const FaceVector& rest,
            std::span<const double> values, FaceVector& vector)
      : model_(model), eye_(eye), rest_(rest), values_(values), now_(vector) {}

  void pose() {
    gaze_ = gaze_of(eye_, values_);
    put_dome(model_, eye_, gaze_, now_);
    if (eye_.upper < 0) return;
    const LidPair at_rest{get(rest_, eye_.upper), get(rest_, eye_.lower)};
    share_ = meeting_share(value(eye_.bias), eye_.meet);
    const LidPair before{get(now_, eye_.upper), get(now_, eye_.lower)};
    LidPair lids = followed(before);
    if (lids != at_rest) lids = uncrossed(lids, up(at_rest), share_);
    lids = blinked(lids, value(eye_.blink), share_);
    if (lids != before) put(eye_.upper, lids.upper), put(eye_.lower, lids.lower);
    const LidPair moved{lids.upper - at_rest.upper, lids.lower - at_rest.lower};
    move_crease(moved.upper, up(at_rest));
    push(lids, at_rest);
    for (const LidRider& rider : eye_.riders) ride(rider, rider.upper ? moved.upper : moved.lower);
  }

 private:
  glm::dvec2 get(const FaceVector& v, int slice) const {
    const double* at = &v[std::size_t(model_.layout[slice].begin)];
    return {at[0], at[1]};
  }
  void put(int slice, glm::dvec2 p) {
    double* at = &now_[std::size_t(model_.layout[slice].begin)];
    at[0] = p.x, at[1] = p.y;
  }
  void add(int slice, glm::dvec2 way) {
    if (way != glm::dvec2(0)) put(slice, get(now_, slice) + way);
  }
  double value(int channel) const { return channel < 0 ? 0 : values_[std::size_t(channel)]; }
  bool are_parabolas() const { return eye_.inner < 0; }

  /// From the lower to the upper lid: across the line of the canthi (along b, for parabolas).
  glm::dvec2 up(const LidPair& at_rest) const {
    if (are_parabolas()) return {0, at_rest.upper.y >= at_rest.lower.y ? 1 : -1};
    const glm::dvec2 line = get(rest_, eye_.outer) - get(rest_, eye_.inner);
    const double length = glm::length(line);
    if (!(length > 0)) return {0, model_.canvas.y_up ? 1 : -1};
    const glm::dvec2 across{-line.y / length, line.x / length};
    const double side = glm::dot(at_rest.upper - at_rest.lower, across);
    const double sign = side != 0 ? side : (model_.canvas.y_up ? across.y : -across.y);
    return sign < 0 ? -across : across;
  }

  /// An edge's middle makes half of its bend's way; a parabola moves as a whole.
  LidPair followed(const LidPair& lids) const {
    const auto way = [&](const double(&share)[2]) {
      return are_parabolas() ? glm::dvec2(0, share[1] * gaze_.y)
                             : 2.0 * glm::dvec2(share[0] * gaze_.x, share[1] * gaze_.y);
    };
    return {lids.upper + way(eye_.follow_upper), lids.lower + way(eye_.follow_lower)};
  }

  void move_crease(glm::dvec2 way, glm::dvec2 up) {
    if (eye_.crease >= 0)
      add(eye_.crease, (glm::dot(way, up) > 0 ? eye_.crease_rise : eye_.crease_fall) * way);
  }

  /// The push at each bend of an edge.
  LidBends pushes(const EyeBody& body, glm::dvec2 inner, glm::dvec2 bend, glm::dvec2 outer,
                  glm::dvec3 axis) const {
    LidBends all = lid_bends({inner, bend, outer});
    for (glm::dvec2& b : all) b = edge_push(body, b, axis);
    return all;
  }

  void push(const LidPair& lids, const LidPair& at_rest) {
    if (eye_.shifts < 0) return;
    const EyeBody body = eye_body(model_, eye_, now_);
    if (body.bulge == 0) return;
    // The face is drawn with the bulge it has now: what is held or moved there moves no lid by itself.
    EyeBody rest_body = eye_body(model_, eye_, rest_);
    rest_body.bulge = body.bulge;
    const glm::dvec2 inner = get(now_, eye_.inner), outer = get(now_, eye_.outer);
    const glm::dvec2 inner0 = get(rest_, eye_.inner), outer0 = get(rest_, eye_.outer);
    const glm::dvec3 axis = gaze_axis(gaze_, body.radius), ahead{0, 0, 1};
    const LidBends upper = pushes(body, inner, lids.upper, outer, axis);
    const LidBends lower = pushes(body, inner, lids.lower, outer, axis);
    const LidBends upper0 = pushes(rest_body, inner0, at_rest.upper, outer0, ahead);
    const LidBends lower0 = pushes(rest_body, inner0, at_rest.lower, outer0, ahead);
    for (std::size_t i = 0; i < kBends; ++i) {
      const LidPair drawn = blinked({upper0[i], lower0[i]}, value(eye_.blink), share_);
      shifts_[0][i] = upper[i] - drawn.upper;
      shifts_[1][i] = lower[i] - drawn.lower;
      add(eye_.shifts + int(i), shifts_[0][i]);
      add(eye_.shifts + int(kBends + i), shifts_[1][i]);
    }
  }

  void ride(const LidRider& rider, glm::dvec2 way) {
    const LidBends& shifts = shifts_[rider.upper ? 0 : 1];
    add(rider.slice, bend_share(rider.a, rider.b) * way + shift_along(shifts, rider.a, rider.b));
  }

  const FaceModel& model_;
  const Eye& eye_;
  const FaceVector& rest_;
  std::span<const double> values_;
  FaceVector& now_;
  glm::dvec2 gaze_{0};
  double share_ = 1;
  std::array<LidBends, 2> shifts_{};
};

double number(const FaceModel& model, int slice, const FaceVector& vector) {
  return slice < 0 ? 0 : vector[std::size_t(model.layout[slice].begin)];
}

glm::dvec2 center_of(const FaceModel& model, const Eye& eye, const FaceVector& vector) {
  const double* at = &vector[std::size_t(model.layout[eye.center].begin)];
  return {at[0], at[1]};
}

}  // namespace

void pose_eyes(const FaceModel& model, const FaceVector& rest, std::span<const double> values,
               FaceVector& vector) {
  for (const Eye& eye : model.eyes) EyeAtWork(model, eye, rest, values, vector).pose();
}

void put_dome(const FaceModel& model, const Eye& eye, glm::dvec2 gaze, FaceVector& vector) {
  if (eye.dome < 0) return;
  const EyeBody body = eye_body(model, eye, vector);
  const CorneaDome dome = cornea_dome(body, gaze_axis(gaze, body.radius));
  double* at = &vector[std::size_t(model.layout[eye.dome].begin)];
  for (const double number :
       {dome.center.x, dome.center.y, dome.radii.x, dome.radii.y, dome.height, dome.tilt})
    *at++ = number;
}

EyeBody eye_body(const FaceModel& model, const Eye& eye, const FaceVector& vector) {
  return {.center = center_of(model, eye, vector),
          .radius = number(model, eye.radius, vector),
          .cornea = number(model, eye.cornea, vector),
          .bulge = number(model, eye.bulge, vector),
          .law = eye.law};
}

glm::dvec2 gaze_of(const Eye& eye, std::span<const double> values) {
  const auto value = [&](int channel) { return channel < 0 ? 0 : values[std::size_t(channel)]; };
  return {value(eye.gaze_x), value(eye.gaze_y)};
}

glm::dvec2 look_at(const FaceModel& model, const Eye& eye, const FaceVector& vector,
                   glm::dvec3 target) {
  return gaze_shift({center_of(model, eye, vector), eye.depth}, number(model, eye.radius, vector),
                    {eye.reach_x, eye.reach_y}, target);
}

}  // namespace mien
