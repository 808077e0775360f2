#include "lib/rig/eye/eye.h"

#include <mien/face_model.h>
#include "lib/rig/eye/blink.h"
#include "lib/rig/eye/gaze.h"
#include "lib/rig/eye/lid.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace mien {
namespace {

constexpr std::size_t kLidBendCount = OpeningFigure::kLidBends;
constexpr glm::dvec3 kAhead{0, 0, 1};

/// One eye of one face, being posed.
class EyeAtWork {
 public:
  EyeAtWork(const FaceModel& model, const Eye& eye, const FaceVector& rest,
            std::span<const double> values, FaceVector& vector, DrawnPushes& memory)
      : model_(model), eye_(eye), rest_(rest), values_(values), now_(vector), memory_(memory) {}

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
  double value(Index<Channel> channel) const {
    return channel ? values_[std::size_t(channel.at)] : 0;
  }
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

  /// The middle of an edge moves half as far as its bend; a parabola moves as a whole.
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

  /// Of the resting face, which is drawn with its bulge.
  const DrawnPushes& drawn_pushes(const EyeBody& body, const std::array<LidBends, 2>& drawn) {
    if (memory_.body == body && memory_.drawn == drawn) return memory_;
    memory_.body = body, memory_.drawn = drawn;
    for (std::size_t lid = 0; lid < 2; ++lid)
      for (std::size_t i = 0; i < kLidBendCount; ++i) {
        const glm::dvec2 push = drawn[lid][i] - standing_place(body, drawn[lid][i], kAhead);
        memory_.pushes[lid][i] = push;
        memory_.again[lid][i] = edge_push(body, drawn[lid][i] - push, kAhead);
      }
    return memory_;
  }

  void push(const LidPair& lids, const LidPair& at_rest) {
    if (eye_.shifts < 0) return;
    const EyeBody body = eye_body(model_, eye_, now_);
    if (body.bulge == 0) return;
    // The face at rest is taken to be drawn with the present bulge, so that setting the bulge alone moves
    // no lid.
    EyeBody rest_body = eye_body(model_, eye_, rest_);
    rest_body.bulge = body.bulge;
    const auto bends = [&](const FaceVector& v, glm::dvec2 bend) {
      return lid_bends({get(v, eye_.inner), bend, get(v, eye_.outer)});
    };
    const LidBends now[2] = {bends(now_, lids.upper), bends(now_, lids.lower)};
    const DrawnPushes& at =
        drawn_pushes(rest_body, {bends(rest_, at_rest.upper), bends(rest_, at_rest.lower)});
    const glm::dvec3 axis = gaze_axis(gaze_, body.radius);
    for (std::size_t i = 0; i < kLidBendCount; ++i) {
      const auto closed = [&](glm::dvec2 upper, glm::dvec2 lower) {
        const LidPair both = blinked({upper, lower}, value(eye_.blink), share_);
        return std::array{both.upper, both.lower};
      };
      // An unpushed lid is the drawn one less the push it was drawn with. That push is evaluated again, in
      // the same way as the present one, so that the resting face keeps every bit.
      const auto drawn = closed(at.pushes[0][i], at.pushes[1][i]),
                 less = closed(at.again[0][i], at.again[1][i]);
      for (std::size_t lid = 0; lid < 2; ++lid) {
        shifts_[lid][i] = edge_push(body, now[lid][i] - drawn[lid], axis) - less[lid];
        add(eye_.shifts + int(lid * kLidBendCount + i), shifts_[lid][i]);
      }
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
  DrawnPushes& memory_;
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
               FaceVector& vector, std::vector<DrawnPushes>& memory) {
  memory.resize(model.eyes.size());
  for (std::size_t i = 0; i < memory.size(); ++i)
    EyeAtWork(model, model.eyes[i], rest, values, vector, memory[i]).pose();
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
  const auto value = [&](Index<Channel> channel) {
    return channel ? values[std::size_t(channel.at)] : 0;
  };
  return {value(eye.gaze_x), value(eye.gaze_y)};
}

glm::dvec2 look_at(const FaceModel& model, const Eye& eye, const FaceVector& vector,
                   glm::dvec3 target) {
  return gaze_shift({center_of(model, eye, vector), eye.depth}, number(model, eye.radius, vector),
                    {eye.reach_x, eye.reach_y}, target);
}

}  // namespace mien
