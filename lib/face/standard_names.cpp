#include "lib/face/standard_names.h"

#include <algorithm>
#include <iterator>

namespace mien {
namespace {

constexpr std::string_view kArkit[] = {
    "browDownLeft",      "browDownRight",      "browInnerUp",         "browOuterUpLeft",
    "browOuterUpRight",  "cheekPuff",          "cheekSquintLeft",     "cheekSquintRight",
    "eyeBlinkLeft",      "eyeBlinkRight",      "eyeLookDownLeft",     "eyeLookDownRight",
    "eyeLookInLeft",     "eyeLookInRight",     "eyeLookOutLeft",      "eyeLookOutRight",
    "eyeLookUpLeft",     "eyeLookUpRight",     "eyeSquintLeft",       "eyeSquintRight",
    "eyeWideLeft",       "eyeWideRight",       "jawForward",          "jawLeft",
    "jawOpen",           "jawRight",           "mouthClose",          "mouthDimpleLeft",
    "mouthDimpleRight",  "mouthFrownLeft",     "mouthFrownRight",     "mouthFunnel",
    "mouthLeft",         "mouthLowerDownLeft", "mouthLowerDownRight", "mouthPressLeft",
    "mouthPressRight",   "mouthPucker",        "mouthRight",          "mouthRollLower",
    "mouthRollUpper",    "mouthShrugLower",    "mouthShrugUpper",     "mouthSmileLeft",
    "mouthSmileRight",   "mouthStretchLeft",   "mouthStretchRight",   "mouthUpperUpLeft",
    "mouthUpperUpRight", "noseSneerLeft",      "noseSneerRight",      "tongueOut"};
static_assert(std::size(kArkit) == 52);

constexpr std::string_view kFacs[] = {
    "AU1",  "AU2",  "AU4",  "AU5",  "AU6",  "AU7",  "AU9",  "AU10", "AU11", "AU12", "AU13",
    "AU14", "AU15", "AU16", "AU17", "AU18", "AU20", "AU22", "AU23", "AU24", "AU25", "AU26",
    "AU27", "AU28", "AU41", "AU42", "AU43", "AU44", "AU45", "AU46", "AU51", "AU52", "AU53",
    "AU54", "AU55", "AU56", "AU57", "AU58", "AU61", "AU62", "AU63", "AU64"};

constexpr std::string_view kVrm[] = {"happy",    "angry",    "sad",       "relaxed",    "surprised",
                                     "neutral",  "aa",       "ih",        "ou",         "ee",
                                     "oh",       "blink",    "blinkLeft", "blinkRight", "lookUp",
                                     "lookDown", "lookLeft", "lookRight"};

constexpr std::string_view kViseme[] = {"sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS",
                                        "nn",  "RR", "aa", "E",  "I",  "O",  "U"};

}  // namespace

std::span<const std::string_view> standard_names(std::string_view set) {
  if (set == "arkit") return kArkit;
  if (set == "facs") return kFacs;
  if (set == "vrm") return kVrm;
  if (set == "viseme") return kViseme;
  return {};
}

std::string standard_spelling(std::string_view set, std::string_view name) {
  const std::size_t dot = name.rfind('.') == std::string_view::npos ? 0 : name.rfind('.') + 1;
  std::string_view unit = name.substr(dot);
  const bool named =
      unit.size() > 2 && (unit[0] == 'A' || unit[0] == 'a') && (unit[1] == 'U' || unit[1] == 'u');
  if (set != "facs" || !named) return std::string(name);
  unit.remove_prefix(2);
  if (unit.ends_with("_r") || unit.ends_with("_c")) unit.remove_suffix(2);
  while (unit.size() > 1 && unit.front() == '0') unit.remove_prefix(1);
  const std::string spelt = "AU" + std::string(unit);
  const bool known = std::find(std::begin(kFacs), std::end(kFacs), spelt) != std::end(kFacs);
  return known ? std::string(name.substr(0, dot)) + spelt : std::string(name);
}

bool names_have_sides(std::string_view set) {
  return set == "arkit" || set == "vrm" || set == "viseme";
}

}  // namespace mien
