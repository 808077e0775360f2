#include "lib/rig/mouth/lip_line.h"

#include <mien/quad_bezier.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace mien {
namespace {

constexpr std::size_t kMiddle = 1;
constexpr std::size_t handle_of(std::size_t side) {
  return side == 0 ? 0 : 2;
}

// Lengths are shares of the face's width; shares of the jaw are of its drop.
constexpr double kHandleOfUpper = 0.06,
                 kHandleOfLower = 0.95;  // shares of the jaw; the upper middle stays
constexpr double kAside = 0.065, kShift = 0.06;
constexpr double kCornerAside = 0.6, kUpperAside = 0.25, kUpperHandleAside = 0.3;
constexpr double kNarrow = 0.10;  // corners come in as the jaw opens
constexpr double kPuckerIn = 0.50, kFunnelIn = 0.36, kStretchOut = 0.16, kDimpleOut = 0.05;
constexpr double kStretchDown = 0.006, kDimpleUp = 0.010;
// Handles go to these shares of the corner's way, or an open mouth is a wedge.
constexpr double kRound = 0.75, kRoundUpper = 0.76, kRoundLower = 0.95;
constexpr double kRoundFunnel = 0.9, kRoundPucker = 0.25;
constexpr double kLevel = 0.7,
                 kLevelFunnel = 0.6;  // corners of a round mouth come level, or it has horns
constexpr double kBite = 0.020;       // the lower lip covers so much of the upper teeth
constexpr double kBiteShows = 0.030, kBiteShowsBeside = 0.012;  // of them are seen above it
constexpr double kBeside = 0.07;                           // where a handle is held to the teeth
constexpr double kClearBetween = 0.036, kClearUp = 0.026;  // below the teeth where a tongue shows

double lift_of(const MouthNumbers& n, bool upper) {
  const double parted = upper ? 0.030 : -0.036, funnelled = upper ? 0.004 : -0.036;
  const double puckered = upper ? -0.030 : -0.022, thrust = upper ? 0.006 : 0.012;
  return parted * n.part + funnelled * n.funnel + puckered * n.pucker + thrust * n.forward +
         0.006 * n.shrug[0] + 0.020 * n.shrug[1];
}

class LipShaping {
 public:
  LipShaping(const MouthNumbers& n, const MouthMeasures& measures, LipLine& line)
      : n_(n),
        drop_(measures.drop * n.jaw),
        measures_(measures),
        width_(measures.width),
        line_(line) {}

  void move() {
    move_corners();
    round_ = kRound * std::min(1.0, n_.jaw + kRoundFunnel * n_.funnel + kRoundPucker * n_.pucker);
    move_edge(line_.upper, true);
    move_edge(line_.lower, false);
    const double level = 0.5 * (line_.upper[kMiddle].y + line_.lower[kMiddle].y);
    const double share = kLevel * std::min(1.0, n_.pucker + kLevelFunnel * n_.funnel);
    for (glm::dvec2& corner : line_.corners) corner.y += (level - corner.y) * share;
  }

  void meet_teeth(const TeethEdge& teeth) {
    // Where the tongue shows, the lower lip bares the teeth; by as much as it shows, or a breath of a sound would open lips that
    // lie over them.
    const double clear = std::max(kClearBetween * n_.tongue_between, kClearUp * n_.tongue_up);
    const double shows = std::clamp(std::max(n_.tongue_between, n_.tongue_up), 0.0, 1.0);
    for (std::size_t bend = 0; bend < 3; ++bend) {
      if (bend != kMiddle && !line_.has_handles) continue;
      const double aside = bend == kMiddle ? 0 : bend == 0 ? kBeside : -kBeside;
      const double edge = teeth.y(teeth.b.x + aside * width_);
      glm::dvec2 &u = line_.upper[bend], &l = line_.lower[bend];
      l.y += shows * std::min(0.0, edge - clear * width_ - l.y);
      if (n_.bite == 0) continue;
      const double bitten = edge + kBite * width_;
      const double shown = (bend == kMiddle ? kBiteShows : kBiteShowsBeside) * width_;
      u.y = (1 - n_.bite) * u.y + n_.bite * std::max(u.y, bitten + shown);
      l.y = (1 - n_.bite) * l.y + n_.bite * bitten;
    }
  }

  void uncross() {
    for (std::size_t bend = 0; bend < 3; ++bend) line_.set(bend, uncrossed(line_.pair(bend)));
  }

 private:
  void move_corners() {
    const double middle = 0.5 * (line_.corners[0].x + line_.corners[1].x);
    for (std::size_t s = 0; s < 2; ++s) {
      glm::dvec2& corner = line_.corners[s];
      wide_[s] = (1 - kNarrow * n_.jaw) * (1 - kPuckerIn * n_.pucker) *
                 (1 - kFunnelIn * n_.funnel) * (1 + kStretchOut * n_.stretch[s]) *
                 (1 + kDimpleOut * n_.dimple[s]);
      if (wide_[s] != 1) corner.x = middle + (corner.x - middle) * wide_[s];
      corner.x += shift() + aside(kCornerAside);
      corner.y += (kDimpleUp * n_.dimple[s] - kStretchDown * n_.stretch[s]) * width_ -
                  measures_.seam * drop_;
    }
  }

  void move_edge(std::array<glm::dvec2, 3>& edge, bool upper) {
    const double lift = lift_of(n_, upper) * width_;
    glm::dvec2& middle = edge[kMiddle];
    const double before = middle.x;
    middle.x += shift() + aside(upper ? kUpperAside : 1);
    middle.y += lift - (upper ? 0 : drop_);
    if (!line_.has_handles) return;
    const double share = upper ? kHandleOfUpper : kHandleOfLower;
    for (std::size_t s = 0; s < 2; ++s) {
      glm::dvec2& handle = edge[handle_of(s)];
      const double own = aside(upper ? kUpperHandleAside : 1) - aside(upper ? kUpperAside : 1);
      if (wide_[s] == 1)
        handle.x += middle.x - before + own;
      else
        handle.x = middle.x + (handle.x - before + own) * wide_[s];
      const double rounded =
          middle.x + (upper ? kRoundUpper : kRoundLower) * (line_.corners[s].x - middle.x);
      if (round_ != 0) handle.x = (1 - round_) * handle.x + round_ * rounded;
      handle.y += lift - share * drop_;
    }
  }

  double shift() const { return kShift * width_ * n_.shift; }
  double aside(double share) const { return share * kAside * width_ * n_.aside; }

  const MouthNumbers& n_;
  const double drop_;
  const MouthMeasures& measures_;
  const double width_;
  LipLine& line_;
  std::array<double, 2> wide_{};
  double round_ = 0;
};

double length_of(const QuadBezier& curve) {
  constexpr int kPieces = 8;
  double length = 0;
  glm::dvec2 last = curve.p0;
  for (int i = 1; i <= kPieces; ++i) {
    const glm::dvec2 next = point(curve, double(i) / kPieces);
    length += glm::distance(last, next), last = next;
  }
  return length;
}

}  // namespace

double TeethEdge::y(double x) const {
  // u from −1 to 1, and a sum that commutes: mirrored places have the same height, bit for bit.
  const glm::dvec2 from = 0.5 * (a + b), to = 0.5 * (b + c);
  const double middle = 0.5 * (from.x + to.x), half = 0.5 * (to.x - from.x);
  const double u = half == 0 ? 0 : std::clamp((x - middle) / half, -1.0, 1.0);
  const double ends = (1 - u) * (1 - u) * from.y + (1 + u) * (1 + u) * to.y;
  return 0.25 * ends + 0.5 * (1 - u * u) * b.y;
}

void shape_lips(const MouthNumbers& n, const MouthMeasures& measures,
                const std::optional<TeethEdge>& teeth, LipLine& line) {
  LipShaping shaping(n, measures, line);
  shaping.move();
  if (teeth) shaping.meet_teeth(*teeth);
  shaping.uncross();
}

LipLine closed(LipLine line, double closure, double seam) {
  for (std::size_t bend = 0; bend < 3; ++bend)
    line.set(bend, closed(line.pair(bend), closure, seam));
  return line;
}

double edge_length(const LipLine& line, bool upper, std::size_t side) {
  const std::array<glm::dvec2, 3>& edge = upper ? line.upper : line.lower;
  if (!line.has_handles) return 0.5 * length_of({line.corners[0], edge[kMiddle], line.corners[1]});
  return length_of({edge[kMiddle], edge[handle_of(side)], line.corners[side]});
}

}  // namespace mien
