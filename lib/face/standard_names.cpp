#include "lib/face/standard_names.h"

#include <iterator>
#include <unordered_map>
#include <utility>

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

namespace {

/// Names in lower-case letters and digits alone, and what they stand for.
using Spellings = std::unordered_map<std::string, std::string_view>;

std::string folded(std::string_view name) {
  std::string letters;
  for (const char c : name)
    if (c >= 'A' && c <= 'Z')
      letters += char(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      letters += c;
  return letters;
}

Spellings spellings_of(std::string_view set) {
  Spellings known;
  for (const std::string_view name : standard_names(set)) known.emplace(folded(name), name);
  const std::pair<const char*, std::string_view> kViseme1[] = {
      {"ih", "I"}, {"oh", "O"}, {"ou", "U"}, {"eh", "E"}, {"ah", "aa"}, {"silence", "sil"}};
  const std::pair<const char*, std::string_view> kVrm0[] = {
      {"joy", "happy"}, {"sorrow", "sad"}, {"fun", "relaxed"}, {"a", "aa"},
      {"i", "ih"},      {"u", "ou"},       {"e", "ee"},        {"o", "oh"}};
  if (set == "viseme") known.insert(std::begin(kViseme1), std::end(kViseme1));
  if (set == "vrm") known.insert(std::begin(kVrm0), std::end(kVrm0));
  return known;
}

const Spellings& spellings(std::string_view set) {
  static const Spellings arkit = spellings_of("arkit"), facs = spellings_of("facs"),
                         vrm = spellings_of("vrm"), viseme = spellings_of("viseme");
  return set == "arkit" ? arkit : set == "facs" ? facs : set == "vrm" ? vrm : viseme;
}

/// "AU01_r" without what OpenFace adds and FACS does not.
std::string plain_unit(std::string_view unit) {
  if (unit.ends_with("_r") || unit.ends_with("_c")) unit.remove_suffix(2);
  std::string letters = folded(unit);
  while (letters.size() > 3 && letters.starts_with("au0")) letters.erase(2, 1);
  return letters;
}

/// The name of a set that is meant; empty: none.
std::string_view meant_name(std::string_view set, std::string_view name) {
  const Spellings& known = spellings(set);
  std::string letters = set == "facs" ? plain_unit(name) : folded(name);
  if (set == "viseme" && letters.starts_with("viseme")) letters.erase(0, 6);
  if (const auto found = known.find(letters); found != known.end()) return found->second;
  if (letters.ends_with('l')) letters += "eft";
  if (letters.ends_with('r')) letters += "ight";
  const auto found = known.find(letters);
  return found == known.end() ? std::string_view{} : found->second;
}

}  // namespace

std::string standard_spelling(std::string_view set, std::string_view name) {
  if (standard_names(set).empty()) return std::string(name);
  const bool sided = name.starts_with("left.") || name.starts_with("right.");
  const std::size_t begin = sided ? name.find('.') + 1 : 0;
  const std::string_view known = meant_name(set, name.substr(begin));
  return known.empty() ? std::string(name) : std::string(name.substr(0, begin)).append(known);
}

bool names_have_sides(std::string_view set) {
  return set == "arkit" || set == "vrm" || set == "viseme";
}

}  // namespace mien
