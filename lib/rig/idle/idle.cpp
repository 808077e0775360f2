#include "lib/rig/idle/idle.h"

#include "lib/base/mixed_bits.h"
#include "lib/math/chance.h"
#include "lib/math/degrees.h"
#include "lib/rig/idle/renewal.h"
#include "lib/rig/idle/spring.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace mien {
namespace {

constexpr double kLongest = 0x1p26;  ///< [s] two years, after which life begins again
constexpr double kMostWait = 0.6;    ///< [s] of a blink

constexpr Spring kCorners{4.5, 0.7}, kBrows{7, 0.7};
constexpr double kNeckDelay = 0.09;          ///< [s] behind the eyes
constexpr glm::dvec2 kNeckShare{0.3, 0.26};  ///< of the gaze's angle
constexpr double kNeckSettling = Spring{12, 0.7}.settling();
constexpr double kJump = 0.042, kJumpPerDegree = 0.002;  ///< [s] of an eye

/// The random numbers of a face, for one purpose.
enum class Purpose : std::uint64_t { temper = 1, looks, blinks, breaths, corners, brows, sway };

class Draw {
 public:
  Draw(std::uint64_t seed, Purpose purpose)
      : stream_(mixed_bits(seed ^ mixed_bits(std::uint64_t(purpose)))) {}

  std::uint64_t stream() const { return stream_; }
  /// Within lo … hi, the `nth` number that is drawn for a count.
  double operator()(std::uint64_t nth, double count, double lo, double hi) const {
    return lo + chance(stream_ + nth, count) * (hi - lo);
  }

 private:
  std::uint64_t stream_;
};

/// The neck on a way of `degrees`: short ways are short in time, too, so no few of a crowd's moves outrank all others and
/// happen to fall together.
Spring neck(glm::dvec2 way) {
  return {std::clamp(300 / std::max(glm::length(way), 1.0), 12.0, 26.0), 0.7};
}

double smooth(double u) {
  u = std::clamp(u, 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

/// sin of an angle in turns.
double wave(double turns) {
  return direction_at(360 * (turns - std::floor(turns))).y;
}

/// Where a number is that goes to level(count) at each moment; left(time since, way) is the share of the way to go.
template <class Level, class Left>
glm::dvec2 course(const Moments& moments, double time, Level&& level, Left&& left) {
  glm::dvec2 to = level(moments[0].count), now = to;
  for (const Moment& moment : moments) {
    const glm::dvec2 from = level(moment.before), way = to - from;
    now -= left(time - moment.time, way) * way;
    to = from;
  }
  return now;
}

/// One face at one moment.
class Life {
 public:
  Life(std::uint64_t seed, double time, double liveliness, const BlinkHolds& holds)
      : seed_(seed),
        time_(std::fmod(time, kLongest)),
        liveliness_(liveliness),
        holds_{holds.spans, holds.later + (time_ - time)},
        looks_(seed, Purpose::looks) {
    const Draw temper(seed, Purpose::temper);
    pace_ = temper(0, 0, 0.85, 1.2);
    fixation_ = temper(1, 0, 0.8, 1.15);
    between_blinks_ = temper(2, 0, 2.6, 4.8);
    breath_ = temper(3, 0, 3.2, 4.6);
    lag_ = temper(4, 0, -0.016, 0.016);
  }

  IdleNumbers all() {
    breathe();
    look();
    blink();
    live();
    return now_;
  }

 private:
  double& part(IdlePart of) { return now_[std::size_t(of)]; }
  void put(IdlePart of, double number) { part(of) = liveliness_ * number; }

  /// [degrees] to the subject's left and up, of the fixation of a count.
  glm::dvec2 target(double count) const {
    if (looks_(1, count, 0, 1) < 0.5) return {looks_(2, count, -2, 2), looks_(3, count, -1.5, 1.5)};
    const double aside = looks_(2, count, -8, 8);
    return {aside + (aside < 0 ? -4 : 4), looks_(3, count, -6.5, 5.5)};
  }
  Moments fixations(double until, double since) const {
    return moments_until(until, since, kLogNormal055, fixation_, looks_.stream());
  }

  void breathe() {
    const Draw draw(seed_, Purpose::breaths);
    constexpr GapLaw kSteady{0.82, 0.9, 0.94, 0.97, 1, 1.03, 1.06, 1.12, 1.25};
    const Moments moments = moments_until(time_, time_, kSteady, breath_, draw.stream());
    const double u = (time_ - moments[0].time) / (moments.next - moments[0].time);
    const double air = smooth(u / 0.42) - smooth((u - 0.42) / 0.46);
    rise_ = air * draw(1, moments[0].count, 0.7, 1);
    put(IdlePart::breath, rise_);
  }

  /// Slow and never the same again: waves whose lengths have no common measure.
  double sway(std::uint64_t axis) const {
    const Draw draw(seed_, Purpose::sway);
    constexpr double kTurns[] = {0.271, 0.117, 0.443}, kSizes[] = {0.55, 0.3, 0.15};
    double sum = 0;
    for (std::uint64_t i = 0; i < 3; ++i)
      sum += kSizes[i] * wave(pace_ * (1 + 0.13 * double(axis)) * kTurns[i] * time_ +
                              draw(axis, double(i), 0, 1));
    return sum;
  }

  void look() {
    const Moments moments = fixations(time_, time_ - kNeckDelay - kNeckSettling);
    const auto level = [&](double count) { return target(count); };
    const glm::dvec2 gaze = course(moments, time_, level, [](double since, glm::dvec2 way) {
      const double takes = kJump + kJumpPerDegree * std::max(std::abs(way.x), std::abs(way.y));
      return 1 - smooth(since / takes);
    });
    slow_gaze_ = course(moments, time_, level, [](double since, glm::dvec2 way) {
      return neck(way).left(since - kNeckDelay);
    });
    const glm::dvec2 head =
        kNeckShare * slow_gaze_ + glm::dvec2{4 * sway(0), 2.2 * sway(1) + 0.7 * rise_};
    put(IdlePart::yaw, head.x);
    put(IdlePart::pitch, head.y);
    put(IdlePart::roll, 2.8 * sway(2));
    put(IdlePart::gaze_x, direction_at(gaze.x - head.x).y);
    put(IdlePart::gaze_y, direction_at(gaze.y - head.y).y);
  }

  /// When the blink that is due at `time` begins: with a wide glance if there is one.
  double with_glance(double time) const {
    constexpr double kNear = 0.2, kWide = 7, kBefore = 0.03;
    for (const Moment& moment : fixations(time + kNear, time - kNear))
      if (moment.time > time - kNear &&
          std::abs(target(moment.count).x - target(moment.before).x) > kWide)
        return moment.time - kBefore;
    return time;
  }

  /// How far a lid is shut `since` [s] its blink began.
  static double lid(double since, double slow) {
    return smooth(since / (0.08 * slow)) - smooth((since - 0.11 * slow) / (0.17 * slow));
  }

  /// When a blink that is due at `begin` begins, so that no lid is down in a span that holds it up; in none while it would
  /// have to wait for too long.
  std::optional<double> held_up(double begin, double lasts) const {
    constexpr double kLongestHold = 0.5;
    const auto& [spans, later] = holds_;
    double at = begin;
    auto span = std::upper_bound(
        spans.begin(), spans.end(), begin,
        [later = later](double t, const SpokenSpan& one) { return t < one.end + later; });
    for (; span != spans.end() && span->begin + later < at + lasts && at - begin <= kMostWait;
         ++span)
      if (span->end - span->begin <= kLongestHold) at = std::max(at, span->end + later);
    if (at - begin > kMostWait) return {};
    return at;
  }

  void blink() {
    const Draw draw(seed_, Purpose::blinks);
    constexpr double kLongestBlink = 0.8, kNear = 0.25, kAgain = 0.34, kDown = 0.2;  // [s]
    const double longest = kLongestBlink + (holds_.spans.empty() ? 0 : kMostWait);
    for (const Moment& moment : moments_until(time_ + kNear, time_ - longest, kLogNormal045,
                                              between_blinks_, draw.stream())) {
      if (moment.time <= time_ - longest || !(draw(1, moment.count, 0, 1) < liveliness_)) continue;
      const double slow = draw(2, moment.count, 0.9, 1.15);
      const double down = kDown * slow + std::abs(lag_);
      const auto begin = held_up(with_glance(moment.time), down);
      if (!begin) continue;
      const double since = time_ - *begin, far = draw(3, moment.count, 0, 1) < 0.08 ? 0.7 : 1;
      const bool twice =
          draw(4, moment.count, 0, 1) < 0.14 && held_up(*begin + kAgain, down) == *begin + kAgain;
      const auto shut = [&](double t) {
        return far * std::max(lid(t, slow), twice ? lid(t - kAgain, slow) : 0);
      };
      double& left = part(IdlePart::blink_left);
      double& right = part(IdlePart::blink_right);
      left = std::max(left, shut(since - std::max(lag_, 0.0)));
      right = std::max(right, shut(since - std::max(-lag_, 0.0)));
    }
  }

  void live() {
    const Draw corners(seed_, Purpose::corners), brows(seed_, Purpose::brows);
    const auto follow = [&](const Draw& draw, const Spring& spring, double median, auto level) {
      const Moments moments =
          moments_until(time_, time_ - spring.settling(), kLogNormal055, median, draw.stream());
      return course(moments, time_, level,
                    [&](double since, glm::dvec2) { return spring.left(since); });
    };
    const glm::dvec2 mouth = follow(corners, kCorners, 2.2, [&](double count) {
      if (corners(1, count, 0, 1) < 0.3) return glm::dvec2(0);
      const double both = corners(2, count, -0.35, 0.55);
      return glm::dvec2{both + corners(3, count, -0.25, 0.25),
                        both + corners(4, count, -0.25, 0.25)};
    });
    put(IdlePart::corner_left, mouth.x);
    put(IdlePart::corner_right, mouth.y);
    const glm::dvec2 brow = follow(brows, kBrows, 2.6, [&](double count) {
      if (brows(1, count, 0, 1) < 0.5) return glm::dvec2(0);
      const double both = brows(2, count, -0.3, 0.6);
      return glm::dvec2{both + brows(3, count, -0.15, 0.15), both + brows(4, count, -0.15, 0.15)};
    });
    const double up = 0.06 * slow_gaze_.y;
    put(IdlePart::brow_left, brow.x + up);
    put(IdlePart::brow_right, brow.y + up);
    put(IdlePart::dilation, wave(0.11 * pace_ * time_ + Draw(seed_, Purpose::temper)(5, 0, 0, 1)));
  }

  std::uint64_t seed_;
  double time_, liveliness_;
  BlinkHolds holds_;
  Draw looks_;
  double pace_ = 1, fixation_ = 1, between_blinks_ = 3, breath_ = 4, lag_ = 0;
  double rise_ = 0;          ///< of the breath, 0 … 1
  glm::dvec2 slow_gaze_{0};  ///< [degrees] as the neck follows it
  IdleNumbers now_{};
};

}  // namespace

IdleNumbers idle_at(std::uint64_t seed, double time, double liveliness, const BlinkHolds& holds) {
  return Life(seed, time, liveliness, holds).all();
}

}  // namespace mien
