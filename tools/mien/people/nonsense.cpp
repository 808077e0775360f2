#include "tools/mien/people/nonsense.h"
#include <mien/composed_face.h>
#include <mien/limits.h>
#include <mien/poser.h>

#include "nonsense_sight_private.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {
namespace {

constexpr std::array<NonsenseCheck, 22> kNonsenseChecks{{
    {"lids_meet", "shut lids leave no opening"},
    {"pupil_in_opening", "a quarter of the pupil is seen at least, unless lids are nearly shut"},
    {"eye_in_head", "the opening of an eye is within the head"},
    {"eyes_apart", "there is room for a nose between the eyes"},
    {"mouth_in_head", "the lips are within the head"},
    {"lips_close", "shut lips are one curve on any jaw and keep about the area they have at rest"},
    {"teeth_touch", "of F and V the lower lip touches the upper teeth"},
    {"chin_follows", "the chin goes down with the jaw"},
    {"lip_below_nose", "the upper lip is below the nose"},
    {"brow_above_lid", "brows do not lie on the lids, but for anger and disgust"},
    {"brow_seen", "two thirds of a brow are seen at least, not under hair or cloth"},
    {"scalp_covered", "hair or a hat covers the crown, unless the head is bald"},
    {"hairline_overlaps", "hair at the temples reaches over the outline of the head"},
    {"ear_rooted", "ears grow out of the head"},
    {"ear_hidden", "no ear looks out of a scarf"},
    {"pupil_in_lens", "pupils are behind the glasses"},
    {"arm_joined", "the arms of glasses meet the rims"},
    {"beard_on_chin", "a beard follows the chin"},
    {"no_loops", "no outline turns inside out"},
    {"in_canvas", "the head and what it wears are within the picture"},
    {"colours", "colours that touch are apart; lines are seen on the skin, in grey too"},
    {"reads", "an emotion moves the features as it does on a plain face, more than any other does"},
}};

constexpr std::array<std::string_view, 6> kNonsenseFeelings{"emotion.joy",   "emotion.sadness",
                                                            "emotion.anger", "emotion.disgust",
                                                            "emotion.fear",  "emotion.surprise"};

/// What tells feelings: brows, lids, lips.
constexpr std::array<std::string_view, 20> kTellingSlices{
    "brow.left/spine/0",        "brow.left/spine/1",        "brow.left/spine/2",
    "brow.right/spine/0",       "brow.right/spine/1",       "brow.right/spine/2",
    "opening.left/upper",       "opening.left/lower",       "opening.right/upper",
    "opening.right/lower",      "upper_edge.left/spine/0",  "upper_edge.left/spine/1",
    "upper_edge.left/spine/2",  "upper_edge.right/spine/1", "upper_edge.right/spine/2",
    "lower_edge.left/spine/0",  "lower_edge.left/spine/1",  "lower_edge.right/spine/0",
    "lower_edge.right/spine/1", "upper_edge.right/spine/0"};

/// How far each has moved, all on end; empty: the face lacks one of them.
std::vector<double> moved(const Face& rest, const Face& posed) {
  std::vector<double> moves;
  for (const std::string_view name : kTellingSlices) {
    const int slice = rest.model->layout.find(name);
    if (slice < 0) return {};
    const auto begin = std::size_t(rest.model->layout[slice].begin);
    for (const std::size_t i : {begin, begin + 1})
      moves.push_back(posed.vector[i] - rest.vector[i]);
  }
  return moves;
}

/// The cosine of the angle between two movements: 1 where they are the same but for their size.
double likeness(const std::vector<double>& a, const std::vector<double>& b) {
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    ab += a[i] * b[i], aa += a[i] * a[i], bb += b[i] * b[i];
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0.0;
}

}  // namespace

std::span<const NonsenseCheck> nonsense_checks() {
  return kNonsenseChecks;
}

/// How each of kNonsenseFeelings moves a plain face.
struct NonsenseTest::Feelings {
  std::array<std::vector<double>, kNonsenseFeelings.size()> moves;

  void check(NonsenseSight& sight) const {
    const auto own =
        std::find(kNonsenseFeelings.begin(), kNonsenseFeelings.end(), sight.pose.feeling);
    const std::vector<double> now = moved(sight.rest.face, sight.posed);
    if (own == kNonsenseFeelings.end() || now.empty()) return;
    const auto index = std::size_t(own - kNonsenseFeelings.begin());
    double nearest = -1;
    for (std::size_t i = 0; i < moves.size(); ++i)
      if (i != index) nearest = std::max(nearest, likeness(now, moves[i]));
    sight.at_least("reads", likeness(now, moves[index]) - nearest, 0);
  }
};

NonsenseTest::NonsenseTest() {
  auto feelings = std::make_unique<Feelings>();
  const auto plain = face_from_recipe({});
  if (plain) {
    Poser poser(*plain);
    for (const NonsensePose& pose : nonsense_poses(*plain))
      for (std::size_t i = 0; i < kNonsenseFeelings.size(); ++i)
        if (pose.feeling == kNonsenseFeelings[i])
          feelings->moves[i] = moved(*plain, poser.pose(pose.pose));
  }
  feelings_ = std::move(feelings);
}

NonsenseTest::NonsenseTest(NonsenseTest&&) noexcept = default;
NonsenseTest& NonsenseTest::operator=(NonsenseTest&&) noexcept = default;
NonsenseTest::~NonsenseTest() = default;

std::vector<NonsenseFault> NonsenseTest::faults(const Face& face, const Face& posed,
                                                const NonsensePose& pose) const {
  std::vector<NonsenseFault> list;
  look(RestSight(face), posed, pose, list);
  return list;
}

std::vector<NonsenseFault> NonsenseTest::faults(const Face& face) const {
  std::vector<NonsenseFault> list;
  const RestSight rest(face);
  Poser poser(face);
  for (const NonsensePose& pose : nonsense_poses(face))
    look(rest, poser.pose(pose.pose), pose, list);
  return list;
}

void NonsenseTest::look(const RestSight& rest, const Face& posed, const NonsensePose& pose,
                        std::vector<NonsenseFault>& list) const {
  end_if_stopped();
  NonsenseSight sight(rest, posed, pose, list);
  check_eyes(sight);
  if (pose.blink != 1) {  // lids alone have moved since the same pose with open eyes
    check_mouth(sight);
    check_speech(sight);
    check_brows(sight);
    check_glasses(sight);
    check_beard(sight);
  }
  if (pose.blink == 0 && pose.moves_head) {
    check_hair(sight);
    check_ears(sight);
    check_drawing(sight);
  }
  if (pose.name == "rest") check_colors(sight);
  if (!pose.feeling.empty()) feelings_->check(sight);
}

}  // namespace mien
