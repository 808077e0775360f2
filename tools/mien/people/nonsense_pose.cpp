#include "tools/mien/people/nonsense_pose.h"
#include <mien/face_model.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace mien {
namespace {

constexpr double kMostTurn = 30;  // [degrees]

/// Words of a pose in the making.
struct PoseWord {
  std::string control;
  double value;
};
using PoseWords = std::vector<PoseWord>;

struct Looked {
  PoseWords words;
  int directions;  ///< of the head beside the front: 8, 4, 2
  bool half_shut;
  bool speaks = false;  ///< looked at from the front alone, with open eyes
};

class PoseList {
 public:
  explicit PoseList(const Face& face) : model_(*face.model) {
    for (const auto& [name, value] : {std::pair{"yaw", &yaw_}, std::pair{"pitch", &pitch_}})
      if (const int control = find(name); control >= 0) {
        const Channel& channel = channel_of(control);
        *value = std::min({kMostTurn, -channel.lo, channel.hi});
      }
  }

  std::vector<NonsensePose> all() {
    for (const Looked& look : looks()) {
      add(look.words, 0, 0, 0);
      if (look.speaks) continue;
      if (look.half_shut) add(look.words, 0.5, 0, 0);
      add(look.words, 1, 0, 0);
      for (const int yaw : {-1, 0, 1})
        for (const int pitch : {-1, 0, 1})
          if (wanted(look.directions, yaw, pitch)) add(look.words, 0, yaw * yaw_, pitch * pitch_);
    }
    return std::move(poses_);
  }

 private:
  int find(std::string_view name) const {
    const auto found = std::find_if(model_.controls.begin(), model_.controls.end(),
                                    [&](const Control& c) { return c.name == name; });
    return found == model_.controls.end() ? -1 : int(found - model_.controls.begin());
  }
  const Channel& channel_of(int control) const {
    return model_.controls[std::size_t(control)].channels[0].in(model_.channels);
  }

  static bool wanted(int directions, int yaw, int pitch) {
    if (yaw == 0 && pitch == 0) return false;
    return directions == 8 || (directions == 4 && (yaw == 0 || pitch == 0)) ||
           (directions == 2 && pitch == 0);
  }

  std::vector<Looked> looks() const {
    constexpr std::array<std::string_view, 6> kFeelings{"joy",     "sadness", "anger",
                                                        "disgust", "fear",    "surprise"};
    const auto feeling = [&](std::size_t i) { return fmt::format("emotion.{}", kFeelings[i]); };
    std::vector<Looked> looks{{{}, 8, true}};
    for (const double strength : {0.5, 1.0})
      for (std::size_t i = 0; i < kFeelings.size(); ++i)
        looks.push_back({{{feeling(i), strength}}, 8, true});
    for (std::size_t i = 0; i < kFeelings.size(); ++i)
      for (std::size_t j = i + 1; j < kFeelings.size(); ++j)
        looks.push_back({{{feeling(i), 1.0}, {feeling(j), 1.0}}, 4, false});
    for (const std::string_view idle : {"corner", "brow_lift", "breath"})
      if (const int control = find(idle); control >= 0)
        for (const double end : {channel_of(control).lo, channel_of(control).hi})
          if (end != channel_of(control).rest)
            looks.push_back({{{std::string(idle), end}}, 2, false});
    for (const Expression& expression : model_.expressions)
      if (expression.name.starts_with("arkit.") || expression.name.starts_with("viseme."))
        looks.push_back({{{std::string(expression.name), 1.0}}, 2, false});
    add_speech(looks);
    return looks;
  }

  /// Lips that shut on an open jaw, and the sounds that need lips: alone and in every mood.
  static void add_speech(std::vector<Looked>& looks) {
    for (const std::string_view mood :
         {"", "joy", "sadness", "anger", "disgust", "fear", "surprise"}) {
      const auto look = [&](PoseWords words) {
        if (!mood.empty()) words.insert(words.begin(), {fmt::format("emotion.{}", mood), 1.0});
        looks.push_back({std::move(words), 0, false, true});
      };
      for (const double jaw : {0.2, 0.6, 1.0})
        look({{"arkit.jawOpen", jaw}, {"arkit.mouthClose", jaw}});
      for (const char* sound : {"viseme.PP", "viseme.FF"})
        if (!mood.empty()) look({{sound, 1.0}});
    }
  }

  void add(PoseWords words, double blink, double yaw, double pitch) {
    NonsensePose pose;
    if (words.size() == 1 && words[0].control.starts_with("emotion.") && blink == 0 && yaw == 0 &&
        pitch == 0)
      pose.feeling = words[0].control;
    pose.blink = blink, pose.turned = yaw != 0 || pitch != 0;
    for (const PoseWord& turn : {PoseWord{"blink", blink}, {"yaw", yaw}, {"pitch", pitch}})
      if (turn.value != 0) words.push_back(turn);
    if (!words.empty()) pose.name.clear();
    for (const PoseWord& word : words) {
      if (word.control.starts_with("arkit.") || word.control.starts_with("viseme."))
        pose.moves_head = false;
      pose.lips_shut =
          pose.lips_shut || word.control == "arkit.mouthClose" || word.control == "viseme.PP";
      pose.bites = pose.bites || word.control == "viseme.FF";
      if (word.control == "arkit.jawOpen") pose.jaw = word.value;
      const int control = find(word.control);
      if (control < 0) return;
      pose.pose.settings.push_back({true, control, {word.value}});
      pose.name +=
          fmt::format("{}{}={:.6g}", pose.name.empty() ? "" : " ", word.control, word.value);
      for (const std::string_view low : {"anger", "disgust", "browDown"})
        pose.lowers_brow = pose.lowers_brow || word.control.find(low) != std::string::npos;
    }
    poses_.push_back(std::move(pose));
  }

  const FaceModel& model_;
  double yaw_ = 0, pitch_ = 0;
  std::vector<NonsensePose> poses_;
};

}  // namespace

std::vector<NonsensePose> nonsense_poses(const Face& face) {
  return PoseList(face).all();
}

}  // namespace mien
