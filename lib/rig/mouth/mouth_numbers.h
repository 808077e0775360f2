#pragma once
// What a mouth is asked to do at a pose.

#include <mien/mouth.h>

#include <array>
#include <span>

namespace mien {

/// Acts at a pose, after the laws of those that exclude each other.
struct MouthNumbers {
  double jaw = 0, aside = 0, forward = 0;
  double close = 0, part = 0, pucker = 0, funnel = 0, shift = 0, puff = 0, bite = 0;
  std::array<double, 2> stretch{}, press{}, dimple{};  ///< left, right
  std::array<double, 2> roll{}, shrug{};               ///< upper, lower
  double tongue_up = 0, tongue_between = 0, tongue_out = 0, tongue_wide = 0, tongue_back = 0;

  friend bool operator==(const MouthNumbers&, const MouthNumbers&) = default;
};

/// `values` are those of all channels, `pulled` how far muscles open the jaw. Both open it as pulls do: j = 1 − (1 −
/// control)(1 − pulled). Speech has the jaw nearly for itself: pulled counts by 1 − 0.8 s, where s is the sum of all
/// visemes, 1 at most, so a surprised mouth opens and shuts as it speaks. A tongue that is out wins over the lips: they close by 1 − out at most, and the jaw opens a
/// little.
MouthNumbers mouth_numbers(const Mouth& mouth, std::span<const double> values, double pulled);

}  // namespace mien
