#include "tongue_private.h"

#include <algorithm>
#include <array>

namespace mien {
namespace {

// Lengths are shares of the face's width.
constexpr double kBodyUp = 0.008;  // how far above the teeth's edge a raised tongue ends
constexpr double kBodyBack = 0.02, kBackWider = 0.15, kWider = 0.25;
constexpr double kMostOfMouth = 0.62;  // of the mouth's half width: no tongue is wider
constexpr double kTipAbove = 0.012;    // over the teeth's edge, when it is between the teeth
constexpr double kTipHalf = 0.085, kTipOfMouth = 0.6, kTipLeast = 0.012, kTipTouches = 1.04;
constexpr double kOutHalf = 0.078, kOutBelow = 0.03, kOutLong = 0.075;
constexpr double kOutUnderTeeth = 0.006, kOutUnderLip = 0.02, kGroove = 0.6;

class TongueAtWork {
 public:
  TongueAtWork(const MouthNumbers& n, const Mouth& mouth, const LipLine& line, MouthVector& to)
      : n_(n), tongue_(mouth.tongue), width_(mouth.width), line_(line), to_(to) {
    half_ = 0.5 * (line.corners[0].x - line.corners[1].x);
    sign_ = half_ < 0 ? -1 : 1;
    half_ *= sign_;
  }

  void body(double teeth, double share) {
    if (tongue_.center < 0) return;
    glm::dvec2 at = to_.get(tongue_.center);
    double* radii = to_.numbers(tongue_.radii);
    const double raised = std::max(at.y, teeth + kBodyUp * width_ - radii[1]);
    at.y = (1 - n_.tongue_up) * at.y + n_.tongue_up * raised - kBodyBack * width_ * n_.tongue_back;
    to_.put(tongue_.center, at);
    radii[0] = std::min(radii[0], std::max(kMostOfMouth, share) * half_) *
               (1 + kBackWider * n_.tongue_back) * (1 + kWider * n_.tongue_wide);
  }

  void tip(double teeth) {
    if (tongue_.tip_center < 0 || n_.tongue_between == 0) return;
    const double share = std::min(n_.tongue_between, 1.0), top = teeth + kTipAbove * width_;
    const double high = std::max(kTipLeast * width_, 0.5 * (top - line_.lower[1].y));
    to_.put(tongue_.tip_center, {line_.lower[1].x, top - high});
    double* radii = to_.numbers(tongue_.tip_radii);
    radii[0] =
        share * std::min(kTipHalf * width_, kTipOfMouth * half_) * (1 + kWider * n_.tongue_wide);
    radii[1] = share * high * kTipTouches;
  }

  void out(double teeth, double lip_bottom) {
    if (tongue_.out.empty() || n_.tongue_out == 0) return;
    const double x = line_.lower[1].x;
    const double top =
        std::min(teeth - kOutUnderTeeth * width_, line_.upper[1].y - kOutUnderLip * width_);
    const double low = lip_bottom - (kOutBelow + kOutLong * n_.tongue_out) * width_;
    const double w =
        sign_ * std::min(kOutHalf * width_, kMostOfMouth * half_) * (1 + kWider * n_.tongue_wide);
    const std::array<glm::dvec2, 7> bends{{{0, top - 0.004 * width_},
                                           {0.95 * w, top},
                                           {1.05 * w, lip_bottom},
                                           {0.75 * w, low},
                                           {-0.75 * w, low},
                                           {-1.05 * w, lip_bottom},
                                           {-0.95 * w, top}}};
    for (std::size_t i = 0; i < bends.size(); ++i)
      to_.put(tongue_.out[i], {x + bends[i].x, bends[i].y});
    to_.numbers(tongue_.out_opacity)[0] = 1;
    if (tongue_.groove.empty()) return;
    const std::array<double, 3> heights{top - 0.02 * width_, 0.5 * (top + low),
                                        low + 0.03 * width_};
    for (std::size_t i = 0; i < heights.size(); ++i) to_.put(tongue_.groove[i], {x, heights[i]});
    to_.numbers(tongue_.groove_opacity)[0] = kGroove;
  }

 private:
  const MouthNumbers& n_;
  const MouthTongue& tongue_;
  const double width_;
  const LipLine& line_;
  MouthVector& to_;
  double half_ = 0, sign_ = 1;
};

}  // namespace

void move_tongue(const MouthNumbers& n, const Mouth& mouth, const std::optional<TeethEdge>& teeth,
                 const LipLine& line, double share, double lip_bottom, MouthVector& to) {
  TongueAtWork tongue(n, mouth, line, to);
  const double edge = teeth ? teeth->y(teeth->b.x) : line.upper[1].y;
  tongue.body(edge, share), tongue.tip(edge), tongue.out(edge, lip_bottom);
}

}  // namespace mien
