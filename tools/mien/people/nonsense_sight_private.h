#pragma once
// What the checks of the nonsense test share: which features a face has, what they cover now, and the
// list of faults.

#include <mien/face_model.h>
#include "tools/mien/people/flat_area.h"
#include "tools/mien/people/nonsense.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// The features that checks look at, by their index in the model; −1: none.
struct KnownFeatures {
  explicit KnownFeatures(const Face& face);

  using Sides = std::array<int, 2>;  ///< left, right
  int head = -1, nose = -1, mouth = -1, beard = -1, hijab = -1;
  Sides opening, pupil, brow, upper_lid, lens, rim, arm, ear;
  std::vector<int> lip_upper, lips;  ///< lips: both
  std::vector<int> over_head;        ///< what can hide the head, of hair or cloth
  /// And hair that fades into skin: a fade has no edge inside the outline that anybody could see.
  std::vector<int> over_temples;
  bool one_mass = false;  ///< whether a style draws several features of them as one area
  std::array<std::vector<int>, 2> over_brow;
  std::vector<int> framed;  ///< what has to stay in the picture
  std::vector<int> looped;  ///< painted paths, which must not turn inside out
};

/// The areas of one posed face, worked out when they are asked for.
class AreaCache {
 public:
  explicit AreaCache(const Face& face) : face_(face), areas_(face.model->features.size()) {}

  const FlatArea& of(int feature) {
    std::optional<FlatArea>& area = areas_[std::size_t(feature)];
    if (!area) area = flat_area(face_.model->features[std::size_t(feature)].figure, face_);
    return *area;
  }
  /// Its first loop; null where it has none.
  const Polygon* loop_of(int feature) {
    if (feature < 0) return nullptr;
    const FlatArea& area = of(feature);
    return area.loops.empty() ? nullptr : area.loops.data();
  }
  bool any_covers(const std::vector<int>& features, glm::dvec2 p) {
    for (const int feature : features)
      if (of(feature).covers(p)) return true;
    return false;
  }

 private:
  const Face& face_;
  std::vector<std::optional<FlatArea>> areas_;
};

/// A face at rest, as the checks need to know it.
struct RestSight {
  explicit RestSight(const Face& face);

  const Face face;  ///< without its mood, from which feelings are told
  KnownFeatures known;
  double unit = 1;  ///< the length that thresholds are in
  std::array<double, 2> opening_area{0, 0};
  std::vector<std::size_t> crown, temples;  ///< points of the head's outline that hair has to cover
  std::vector<std::size_t> chin;            ///< those that the beard covers
  std::vector<double> loop_areas;           ///< of known.looped, loop after loop
  std::vector<char> leaves_below;           ///< of known.framed: whether it runs off the lower edge

 private:
  void find_hair(AreaCache& areas);
  void find_beard(AreaCache& areas);
  void find_frame(AreaCache& areas);
};

/// One posed face under test.
struct NonsenseSight {
  NonsenseSight(const RestSight& at_rest, const Face& posed_face, const NonsensePose& its_pose,
                std::vector<NonsenseFault>& list);

  /// `measured` in units of the face's own; notes a fault where it is less than allowed.
  void at_least(std::string_view check, double measured, double allowed,
                std::string_view what = {});
  void at_most(std::string_view check, double measured, double allowed, std::string_view what = {});

  const RestSight& rest;
  const KnownFeatures& known;
  const Face& posed;
  const NonsensePose& pose;
  AreaCache areas;
  glm::dvec2 right{1, 0},
      up{0, 1};  ///< the head's own, as it is rolled; right: to the subject's left
  double unit = 1;

 private:
  std::vector<NonsenseFault>& faults_;
};

inline constexpr std::array<std::string_view, 2> kSideNames{"left", "right"};

void check_eyes(NonsenseSight& sight);
void check_mouth(NonsenseSight& sight);
void check_speech(NonsenseSight& sight);  // lips that close, teeth, the chin
void check_brows(NonsenseSight& sight);
void check_hair(NonsenseSight& sight);
void check_ears(NonsenseSight& sight);
void check_glasses(NonsenseSight& sight);
void check_beard(NonsenseSight& sight);
void check_drawing(NonsenseSight& sight);  // loops, the picture's edge
void check_colors(NonsenseSight& sight);

}  // namespace mien
