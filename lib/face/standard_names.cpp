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
    "AU1",  "AU2",  "AU4",  "AU5",  "AU6",  "AU7",  "AU9",  "AU10", "AU11", "AU12", "AU13", "AU14",
    "AU15", "AU16", "AU17", "AU18", "AU19", "AU20", "AU22", "AU23", "AU24", "AU25", "AU26", "AU27",
    "AU28", "AU29", "AU30", "AU34", "AU41", "AU42", "AU43", "AU44", "AU45", "AU46", "AU51", "AU52",
    "AU53", "AU54", "AU55", "AU56", "AU57", "AU58", "AU61", "AU62", "AU63", "AU64"};
static_assert(std::size(kFacs) == 46);

constexpr std::string_view kVrm[] = {"happy",    "angry",    "sad",       "relaxed",    "surprised",
                                     "neutral",  "aa",       "ih",        "ou",         "ee",
                                     "oh",       "blink",    "blinkLeft", "blinkRight", "lookUp",
                                     "lookDown", "lookLeft", "lookRight"};

constexpr std::string_view kViseme[] = {"sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS",
                                        "nn",  "RR", "aa", "E",  "I",  "O",  "U"};

constexpr std::string_view kAzure[] = {"0",  "1",  "2",  "3",  "4",  "5",  "6",  "7",
                                       "8",  "9",  "10", "11", "12", "13", "14", "15",
                                       "16", "17", "18", "19", "20", "21"};

/// Other spellings that no rule gives, in lower case.
struct OtherName {
  std::string_view set, other, name;
};
constexpr OtherName kOtherNames[] = {
    {"vrm", "joy", "happy"}, {"vrm", "sorrow", "sad"},     {"vrm", "fun", "relaxed"},
    {"vrm", "a", "aa"},      {"vrm", "i", "ih"},           {"vrm", "u", "ou"},
    {"vrm", "e", "ee"},      {"vrm", "o", "oh"},           {"viseme", "ih", "I"},
    {"viseme", "oh", "O"},   {"viseme", "ou", "U"},        {"viseme", "eh", "E"},
    {"viseme", "ah", "aa"},  {"viseme", "silence", "sil"},
};

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

/// Without case and separators; a last "_l", ".l", "-l" is "left".
std::string plain(std::string_view name) {
  std::string bare;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool parts = name[i] == '_' || name[i] == '.' || name[i] == '-' || name[i] == ' ';
    const char side = i + 2 == name.size() ? lower(name[i + 1]) : '\0';
    if (parts && (side == 'l' || side == 'r')) return bare + (side == 'l' ? "left" : "right");
    if (!parts) bare += lower(name[i]);
  }
  return bare;
}

/// "12" of "AU12", "au12", "AU012_r", "AU12_c"; nothing of others.
std::string_view unit_number(std::string_view name) {
  if (name.size() < 3 || lower(name[0]) != 'a' || lower(name[1]) != 'u') return {};
  name.remove_prefix(2);
  if (name.ends_with("_r") || name.ends_with("_c")) name.remove_suffix(2);
  while (name.size() > 1 && name.front() == '0') name.remove_prefix(1);
  return name;
}

/// OpenXR's and others' words around a viseme's name.
std::string_view without_words(std::string_view set, std::string_view name) {
  if (set != "viseme") return name;
  for (const std::string_view before : {"xrfacetrackingviseme", "viseme"})
    if (name.starts_with(before) && name.size() > before.size()) name.remove_prefix(before.size());
  for (const std::string_view after : {"meta", "fb"})
    if (name.ends_with(after) && name.size() > after.size()) name.remove_suffix(after.size());
  return name;
}

std::string spelling(std::string_view set, std::string_view name) {
  const auto names = standard_names(set);
  if (std::find(names.begin(), names.end(), name) != names.end()) return std::string(name);
  if (set == "facs") {
    const std::string unit = "AU" + std::string(unit_number(name));
    return std::find(names.begin(), names.end(), unit) != names.end() ? unit : std::string(name);
  }
  const std::string bare = plain(name);
  const std::string_view wanted = without_words(set, bare);
  for (const std::string_view standard : names)
    if (plain(standard) == wanted) return std::string(standard);
  for (const OtherName& other : kOtherNames)
    if (other.set == set && other.other == wanted) return std::string(other.name);
  return std::string(name);
}

}  // namespace

std::span<const std::string_view> standard_names(std::string_view set) {
  if (set == "arkit") return kArkit;
  if (set == "facs") return kFacs;
  if (set == "vrm") return kVrm;
  if (set == "viseme") return kViseme;
  if (set == "azure") return kAzure;
  return {};
}

std::string standard_spelling(std::string_view set, std::string_view name) {
  if (standard_names(set).empty()) return std::string(name);
  if (!names_have_sides(set))
    for (const std::string_view side : {"left.", "right."})
      if (name.starts_with(side))
        return std::string(side) + spelling(set, name.substr(side.size()));
  return spelling(set, name);
}

bool names_have_sides(std::string_view set) {
  return set == "arkit" || set == "vrm" || set == "viseme" || set == "azure";
}

}  // namespace mien
