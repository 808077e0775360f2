#include "sdf/distance/feet/branches.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

double key_at(const Spine& s, double t, glm::dvec2 p) {
  return glm::distance(on_spine(s, t), p) - width_on_spine(s, t);
}

/// Whether the stretch has one foot seen from any place no farther from it than that.
bool has_one_foot(const Spine& s, double from, double to, double far) {
  // Of the speed that the bends leave: feet there are found in few steps.
  constexpr double kLeft = 0.3;
  const double bend2 = s.x2 * s.x2 + s.y2 * s.y2, dot = s.x1 * s.x2 + s.y1 * s.y2;
  const double slowest_at = bend2 > 0.0 ? std::clamp(-0.5 * dot / bend2, from, to) : from;
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0, widening = 0.0;
  for (const double t : {from, to, slowest_at}) {
    const glm::dvec2 speed = along_spine(s, t);
    slowest = std::min(slowest, glm::dot(speed, speed));
    fastest = std::max(fastest, glm::dot(speed, speed));
    widening = std::max(widening, std::abs(s.w1 + 2.0 * t * s.w2));
  }
  const double taken = 2.0 * far * (std::sqrt(bend2) + std::abs(s.w2));
  return slowest - taken - widening * std::sqrt(fastest) > kLeft * slowest;
}

double widest(const Spine& s) {
  return std::max({s.w0, s.w0 + 0.5 * s.w1 + 0.25 * s.w2, s.w0 + s.w1 + s.w2});
}

class Gathering {
 public:
  Gathering(const SpineList& outline, glm::dvec2 middle, double radius, Branches& to)
      : outline_(outline), middle_(middle), radius_(radius), to_(to) {}

  void run() {
    to_.count = 0, to_.stroke = outline_.stroke, to_.crowded = false;
    to_.figures.resize(std::size_t(Branches::kRows * Branches::kStride));
    const std::size_t count = outline_.spines.size();
    keys_.resize(2 * count);
    best_ = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
      keys_[2 * i] = key_at(outline_.spines[i], 0.0, middle_);
      keys_[2 * i + 1] = key_at(outline_.spines[i], 1.0, middle_);
      best_ = std::min({best_, keys_[2 * i], keys_[2 * i + 1], near_chord(outline_.spines[i])});
    }
    for (now_ = 0; now_ < count && !to_.crowded; ++now_) {
      wide_ = widest(outline_.spines[now_]), turn_ = -1.0;
      cut(0.0, 1.0, keys_[2 * now_], keys_[2 * now_ + 1]);
    }
    fill_up();
  }

 private:
  /// A key on the spine that is least if it is straight: what is far from the nearest is then never listed.
  double near_chord(const Spine& s) const {
    const glm::dvec2 begin = on_spine(s, 0.0), chord = on_spine(s, 1.0) - begin;
    const double length2 = glm::dot(chord, chord);
    if (!(length2 > 0.0)) return key_at(s, 0.0, middle_);
    return key_at(s, std::clamp(glm::dot(middle_ - begin, chord) / length2, 0.0, 1.0), middle_);
  }

  /// How fast key may change along the stretch: speeds and widenings are largest at its ends.
  double reach(double from, double to) const {
    const Spine& s = outline_.spines[now_];
    const auto at = [&](double t) {
      return glm::length(along_spine(s, t)) + std::abs(s.w1 + 2.0 * t * s.w2);
    };
    return std::max(at(from), at(to));
  }

  void cut(double from, double to, double key_from, double key_to) {
    const Spine& s = outline_.spines[now_];
    const double length = reach(from, to) * (to - from);
    if (0.5 * (key_from + key_to - length) > best_ + 2.0 * radius_) return;
    const double far = std::max(best_ + wide_, 0.0) + 2.0 * radius_;
    // [of the disc's radius, of the way to the spine] Stretches as short as that are not cut.
    constexpr double kShort = 0.3, kShortFar = 0.1;
    // [radii] Floats place what is as long as that to within 1e-4 px.
    constexpr double kLong = 64.0;
    const bool single = has_one_foot(s, from, to, far);
    // Cut at its vertex a parabola has one least distance within each half. A stretch that is cut at all is cut there,
    // or a middle could happen to be the vertex and be taken for a mere joint.
    constexpr double kTurns = 0.05;  // [px]
    const double bend2 = s.x2 * s.x2 + s.y2 * s.y2;
    const double vertex = bend2 > 0.0 ? -0.5 * (s.x1 * s.x2 + s.y1 * s.y2) / bend2 : from;
    const double margin = 0.02 * (to - from);
    const bool turns = vertex > from + margin && vertex < to - margin;
    const bool is_long = length > kLong * radius_ ||
                         (!single && length > std::max(kShort * radius_, kShortFar * far));
    if (turns && (is_long || (!single && length > kTurns))) {
      turn_ = vertex;
      return cut_at(vertex, from, to, key_from, key_to);
    }
    if (is_long) return cut_at(0.5 * (from + to), from, to, key_from, key_to);
    // Where the vertex lies beyond the spine's end, a stretch may have a least distance at the end beside the one within.
    const bool begins = from == 0.0 && vertex < 0.0, ends = to == 1.0 && vertex > 1.0;
    const bool of_its_own = outline_.stroke && !single && bend2 > 0.0 && (begins || ends);
    if (to_.count + int(of_its_own) >= Branches::kMost) {
      to_.crowded = true;
      return;
    }
    add(from, to, key_from, key_to, single);
    if (of_its_own) add_end(begins ? 0.0 : 1.0);
  }
  void cut_at(double t, double from, double to, double key_from, double key_to) {
    const double key = key_at(outline_.spines[now_], t, middle_);
    best_ = std::min(best_, key);
    cut(from, t, key_from, key), cut(t, to, key, key_to);
  }

  void add(double from, double to, double key_from, double key_to, bool single) {
    const Spine& s = outline_.spines[now_];
    // A foot right at a joint must be inside one of both.
    constexpr double kLap = 0.02;
    constexpr int kSamples = 8;
    double start = key_to < key_from ? 1.0 : 0.0, least = std::min(key_from, key_to);
    for (int i = 1; i < kSamples; ++i) {
      const double t = double(i) / kSamples, key = key_at(s, from + (to - from) * t, middle_);
      if (key < least) least = key, start = t;
    }
    best_ = std::min(best_, least);
    const glm::dvec2 next = outline_.next.empty()
                                ? glm::dvec2{0.0}
                                : along_spine(outline_.spines[outline_.next[now_]], 0.0);
    const glm::dvec2 before = outline_.before.empty()
                                  ? glm::dvec2{0.0}
                                  : along_spine(outline_.spines[outline_.before[now_]], 1.0);
    const double by = to - from;
    const glm::dvec2 begin = on_spine(s, from) - middle_, way = by * along_spine(s, from);
    const double figures[Branches::kRows] = {
        begin.x,
        way.x,
        by * by * s.x2,
        begin.y,
        way.y,
        by * by * s.y2,
        width_on_spine(s, from),
        by * (s.w1 + 2.0 * from * s.w2),
        by * by * s.w2,
        from > 0.0 ? -kLap : 0.0,
        to < 1.0 ? 1.0 + kLap : 1.0,
        -from / by,
        (1.0 - from) / by,
        turn_ >= 0.0 && from >= turn_ ? (turn_ - from) / by - kLap : -from / by,
        turn_ >= 0.0 && to <= turn_ ? (turn_ - from) / by + kLap : (1.0 - from) / by,
        s.side,
        s.begin_x,
        s.begin_y,
        s.end_x,
        s.end_y,
        next.x,
        next.y,
        before.x,
        before.y,
        single                       ? 1.0
        : s.w1 == 0.0 && s.w2 == 0.0 ? 0.0
                                     : -1.0,
        start,
        0.0,
        0.0};
    put(figures);
  }

  /// A stroke's end as a branch: a stretch of no length.
  void add_end(double t) {
    const Spine& s = outline_.spines[now_];
    const glm::dvec2 end = on_spine(s, t) - middle_;
    double figures[Branches::kRows] = {};
    figures[Branches::x0] = end.x, figures[Branches::y0] = end.y;
    figures[Branches::w0] = width_on_spine(s, t), figures[Branches::single] = 1.0;
    put(figures);
  }

  void put(const double (&figures)[Branches::kRows]) {
    float* column = to_.figures.data() + to_.count++;
    for (int r = 0; r < Branches::kRows; ++r) column[r * Branches::kStride] = float(figures[r]);
  }

  /// Lanes read beyond the last branch.
  void fill_up() {
    const int whole = (to_.count + 15) / 16 * 16;
    for (int r = 0; r < Branches::kRows; ++r) {
      float* row = to_.figures.data() + r * Branches::kStride;
      for (int i = to_.count; i < whole; ++i) row[i] = row[0];
    }
  }

  const SpineList& outline_;
  const glm::dvec2 middle_;
  const double radius_;
  Branches& to_;
  std::size_t now_ = 0;
  double wide_ = 0, best_ = 0;
  double turn_ = -1;  ///< where the spine was cut at its vertex

  std::vector<double>& keys_ = to_.keys;
};

}  // namespace

void gather_branches(const SpineList& outline, glm::dvec2 middle, double radius, Branches& to) {
  Gathering(outline, middle, radius, to).run();
}

}  // namespace mien
