#include "lib/file/motion/take_names.h"

#include "lib/face/standard_names.h"

#include <algorithm>
#include <iterator>
#include <numbers>

namespace mien {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// How far eyes turn for an action unit of the gaze at its full strength [radians].
constexpr double kFullGaze = 0.5;

/// Turns of the head in radians. In the files of Live Link Face yaw and roll go to the subject's right and pitch goes down:
/// there, eyes that look to the subject's left and up (EyeLookOutLeft, EyeLookUpLeft) have a negative LeftEyeYaw and
/// LeftEyePitch. In OpenFace the axes go to the right of the picture, down, and away from the camera, and turns are
/// right-handed.
struct NamedTurn {
  std::string_view name, channel;
};
constexpr NamedTurn kTurns[] = {{"headyaw", "yaw"}, {"headpitch", "pitch"}, {"headroll", "roll"},
                                {"posery", "yaw"},  {"poserx", "pitch"},    {"poserz", "roll"}};

constexpr std::string_view kEyeTurns[] = {"lefteyeyaw",  "lefteyepitch",  "lefteyeroll",
                                          "righteyeyaw", "righteyepitch", "righteyeroll"};

/// Letters and digits in lower case.
std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : name)
    if (c >= 'A' && c <= 'Z')
      letters += char(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      letters += c;
  return letters;
}

bool is_one_of(std::string_view set, std::string_view name) {
  const auto names = standard_names(set);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// OpenFace gives action units from 0 to 5 (AU12_r) and whether they are there (AU12_c).
TakeTarget unit_target(std::string_view name, std::string unit) {
  const bool intensity = name.ends_with("_r");
  return {"facs." + std::move(unit), TakeUnit::share, intensity ? 0.2 : 1, false,
          intensity || name.ends_with("_c")};
}

/// One that goes both ways about 0, as two that go from 0 to 1.
std::vector<TakeTarget> gaze_targets(std::string_view more, std::string_view less) {
  return {{std::string(more), TakeUnit::share, 1 / kFullGaze, true, true},
          {std::string(less), TakeUnit::share, -1 / kFullGaze, true, true}};
}

}  // namespace

std::vector<TakeTarget> take_targets(std::string_view name) {
  const std::string letters = letters_of(name);
  for (const NamedTurn& turn : kTurns)
    if (letters == turn.name)
      return {{std::string(turn.channel), TakeUnit::degrees, -kDegrees, false, true}};
  // Of the gaze, positive angles are the subject's left, and down.
  if (letters == "gazeanglex") return gaze_targets("facs.AU61", "facs.AU62");
  if (letters == "gazeangley") return gaze_targets("facs.AU64", "facs.AU63");
  for (const std::string_view set : {"arkit", "viseme"})
    if (std::string spelt = standard_spelling(set, name); is_one_of(set, spelt))
      return {{std::string(set) + "." + spelt}};
  if (std::string unit = standard_spelling("facs", name); is_one_of("facs", unit))
    return {unit_target(name, std::move(unit))};
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos || dot + 1 == name.size()) return {};
  const std::string_view set = name.substr(0, dot);
  const std::string spelt = standard_spelling(set, name.substr(dot + 1));
  if (set == "emotion" || set == "muscle" || is_one_of(set, spelt))
    return {{std::string(set) + "." + spelt}};
  return {};
}

bool is_turn_of_head_or_eye(std::string_view name) {
  const std::string letters = letters_of(name);
  return letters == "headyaw" || letters == "headpitch" || letters == "headroll" ||
         std::find(std::begin(kEyeTurns), std::end(kEyeTurns), letters) != std::end(kEyeTurns);
}

bool is_beside_the_face(std::string_view name) {
  constexpr std::string_view kKnown[] = {"blendshapecount", "frame",   "frameindex", "index",
                                         "framenumber",     "faceid",  "confidence", "neutral",
                                         "comment",         "success", "headname",   "headindex"};
  const std::string letters = letters_of(name);
  return std::find(std::begin(kKnown), std::end(kKnown), letters) != std::end(kKnown) ||
         is_turn_of_head_or_eye(name);
}

}  // namespace mien
