#include "lib/rig/speech/phone_visemes.h"

#include "lib/face/standard_names.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace mien {
namespace {

using V = Viseme;

struct Entry {
  std::string_view name;
  V first;
  V second = V::sil;  ///< of a diphthong; sil: none
};

constexpr Entry kArpabet[] = {
    {"AA", V::aa}, {"AE", V::aa},  {"AH", V::aa},       {"AO", V::O},       {"AW", V::aa, V::U},
    {"AX", V::E},  {"AXR", V::RR}, {"AY", V::aa, V::I}, {"B", V::PP},       {"CH", V::CH},
    {"D", V::DD},  {"DH", V::TH},  {"DX", V::DD},       {"EH", V::E},       {"ER", V::RR},
    {"EL", V::nn}, {"EM", V::PP},  {"EN", V::nn},       {"EY", V::E, V::I}, {"F", V::FF},
    {"G", V::kk},  {"HH", V::kk},  {"H", V::kk},        {"IH", V::I},       {"IX", V::I},
    {"IY", V::I},  {"JH", V::CH},  {"K", V::kk},        {"L", V::nn},       {"M", V::PP},
    {"N", V::nn},  {"NG", V::kk},  {"NX", V::nn},       {"OW", V::O, V::U}, {"OY", V::O, V::I},
    {"P", V::PP},  {"Q", V::kk},   {"R", V::RR},        {"S", V::SS},       {"SH", V::CH},
    {"T", V::DD},  {"TH", V::TH},  {"UH", V::U},        {"UW", V::U},       {"UX", V::U},
    {"V", V::FF},  {"W", V::U},    {"WH", V::U},        {"Y", V::I},        {"Z", V::SS},
    {"ZH", V::CH}};

/// Longer names first where one begins another; marks of length, stress and voice may follow.
constexpr Entry kIpa[] = {
    {"tʃ", V::CH},       {"dʒ", V::CH},       {"tɕ", V::CH},       {"dʑ", V::CH},
    {"ts", V::SS},       {"dz", V::SS},       {"pf", V::FF},       {"aɪ", V::aa, V::I},
    {"aʊ", V::aa, V::U}, {"aj", V::aa, V::I}, {"aw", V::aa, V::U}, {"ɑɪ", V::aa, V::I},
    {"eɪ", V::E, V::I},  {"ej", V::E, V::I},  {"ɛɪ", V::E, V::I},  {"əʊ", V::E, V::U},
    {"oʊ", V::O, V::U},  {"ow", V::O, V::U},  {"əw", V::E, V::U},  {"ɔɪ", V::O, V::I},
    {"ɔj", V::O, V::I},  {"ɔʏ", V::O, V::I},  {"ɪə", V::I, V::E},  {"eə", V::E, V::aa},
    {"ʊə", V::U, V::E},  {"p", V::PP},        {"b", V::PP},        {"m", V::PP},
    {"ɓ", V::PP},        {"ʙ", V::PP},        {"f", V::FF},        {"v", V::FF},
    {"ɱ", V::FF},        {"ʋ", V::FF},        {"θ", V::TH},        {"ð", V::TH},
    {"t", V::DD},        {"d", V::DD},        {"ɾ", V::DD},        {"ʈ", V::DD},
    {"ɖ", V::DD},        {"ɗ", V::DD},        {"k", V::kk},        {"ɡ", V::kk},
    {"g", V::kk},        {"ŋ", V::kk},        {"x", V::kk},        {"ɣ", V::kk},
    {"χ", V::kk},        {"ʁ", V::kk},        {"q", V::kk},        {"ɢ", V::kk},
    {"h", V::kk},        {"ɦ", V::kk},        {"ħ", V::kk},        {"ʕ", V::kk},
    {"ʔ", V::kk},        {"c", V::kk},        {"ɟ", V::kk},        {"ç", V::I},
    {"ʃ", V::CH},        {"ʒ", V::CH},        {"ʂ", V::CH},        {"ʐ", V::CH},
    {"ɕ", V::SS},        {"ʑ", V::SS},        {"s", V::SS},        {"z", V::SS},
    {"n", V::nn},        {"ɲ", V::nn},        {"ɳ", V::nn},        {"l", V::nn},
    {"ɫ", V::nn},        {"ʎ", V::nn},        {"ɭ", V::nn},        {"ɬ", V::nn},
    {"r", V::RR},        {"ɹ", V::RR},        {"ɻ", V::RR},        {"ɽ", V::RR},
    {"ʀ", V::kk},        {"ɝ", V::RR},        {"ɚ", V::RR},        {"ɜ", V::RR},
    {"j", V::I},         {"ɥ", V::U},         {"w", V::U},         {"ʍ", V::U},
    {"ɰ", V::kk},        {"a", V::aa},        {"ɑ", V::aa},        {"ɐ", V::aa},
    {"ʌ", V::aa},        {"æ", V::aa},        {"e", V::E},         {"ɛ", V::E},
    {"ə", V::E},         {"ɘ", V::E},         {"ɞ", V::E},         {"i", V::I},
    {"ɪ", V::I},         {"ɨ", V::I},         {"ᵻ", V::I},         {"y", V::U},
    {"ʏ", V::U},         {"ø", V::O},         {"œ", V::O},         {"ɶ", V::aa},
    {"ɵ", V::O},         {"ɤ", V::E},         {"ɯ", V::I},         {"o", V::O},
    {"ɔ", V::O},         {"ɒ", V::O},         {"u", V::U},         {"ʊ", V::U},
    {"ʉ", V::U}};

/// What is written otherwise than in the alphabet above.
constexpr Entry kSampa[] = {
    {"tS", V::CH},       {"dZ", V::CH},       {"ts", V::SS},       {"dz", V::SS},
    {"aI", V::aa, V::I}, {"aU", V::aa, V::U}, {"AI", V::aa, V::I}, {"eI", V::E, V::I},
    {"EI", V::E, V::I},  {"@U", V::E, V::U},  {"oU", V::O, V::U},  {"OI", V::O, V::I},
    {"OY", V::O, V::I},  {"I@", V::I, V::E},  {"e@", V::E, V::aa}, {"E@", V::E, V::aa},
    {"U@", V::U, V::E},  {"T", V::TH},        {"D", V::TH},        {"S", V::CH},
    {"Z", V::CH},        {"N", V::kk},        {"J", V::nn},        {"L", V::nn},
    {"R", V::kk},        {"C", V::I},         {"H", V::U},         {"G", V::kk},
    {"X", V::kk},        {"?", V::kk},        {"F", V::FF},        {"B", V::PP},
    {"P", V::FF},        {"A", V::aa},        {"Q", V::O},         {"V", V::aa},
    {"{", V::aa},        {"E", V::E},         {"@", V::E},         {"3", V::RR},
    {"I", V::I},         {"O", V::O},         {"U", V::U},         {"Y", V::U},
    {"M", V::I},         {"2", V::O},         {"9", V::O},         {"6", V::aa},
    {"8", V::O},         {"1", V::I},         {"}", V::U}};

/// Rhubarb's mouths: https://github.com/DanielSWolf/rhubarb-lip-sync.
constexpr Entry kRhubarb[] = {{"A", V::PP}, {"B", V::SS}, {"C", V::E},  {"D", V::aa}, {"E", V::O},
                              {"F", V::U},  {"G", V::FF}, {"H", V::nn}, {"X", V::sil}};

constexpr Entry kAzure[] = {
    {"0", V::sil},      {"1", V::aa},        {"2", V::aa},  {"3", V::O},   {"4", V::E},
    {"5", V::RR},       {"6", V::I},         {"7", V::U},   {"8", V::O},   {"9", V::aa, V::U},
    {"10", V::O, V::I}, {"11", V::aa, V::I}, {"12", V::kk}, {"13", V::RR}, {"14", V::nn},
    {"15", V::SS},      {"16", V::CH},       {"17", V::TH}, {"18", V::FF}, {"19", V::DD},
    {"20", V::kk},      {"21", V::PP}};

bool is_silence(std::string_view name) {
  constexpr std::string_view kSilences[] = {"",      "sil",   "SIL", "sp",     "SP", "_",
                                            "_:",    "pau",   "PAU", "#",      "##", "<p:>",
                                            "<eps>", "<sil>", "h#",  "silence"};
  return std::find(std::begin(kSilences), std::end(kSilences), name) != std::end(kSilences);
}

constexpr double kSecondary = 0.5;  ///< stress

PhoneMeaning meaning(const Entry& entry, double strength = 1, double stress = 0) {
  PhoneMeaning found;
  found.stress = stress;
  found.shapes[0] = {entry.first, strength};
  found.shapes[1] = {entry.second, strength};
  found.count = entry.second == V::sil ? 1 : 2;
  return found;
}

template <std::size_t kSize>
const Entry* whole(const Entry (&table)[kSize], std::string_view name) {
  const auto found = std::find_if(std::begin(table), std::end(table),
                                  [&](const Entry& entry) { return entry.name == name; });
  return found == std::end(table) ? nullptr : found;
}

template <std::size_t kSize>
const Entry* beginning(const Entry (&table)[kSize], std::string_view name) {
  const auto found = std::find_if(std::begin(table), std::end(table),
                                  [&](const Entry& entry) { return name.starts_with(entry.name); });
  return found == std::end(table) ? nullptr : found;
}

/// "AH0": vowels without stress open less.
PhoneMeaning arpabet_meaning(std::string_view name) {
  constexpr double kUnstressed = 0.75;
  double strength = 1, stress = 0;
  if (name.size() > 1 && name.back() >= '0' && name.back() <= '2') {
    if (name.back() == '0') strength = kUnstressed;
    stress = name.back() == '1' ? 1 : name.back() == '2' ? kSecondary : 0;
    name.remove_suffix(1);
  }
  std::string capitals(name);
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
  if (const Entry* entry = whole(kArpabet, capitals)) return meaning(*entry, strength, stress);
  for (std::size_t length = std::min<std::size_t>(capitals.size(), 2); length > 0; --length)
    if (const Entry* entry = whole(kArpabet, std::string_view(capitals).substr(0, length))) {
      PhoneMeaning near = meaning(*entry, strength, stress);
      near.known = false;
      return near;
    }
  return {{{V::kk}, {V::sil}}, 1, false};
}

/// The longest sound that a text begins with.
const Entry* first_sound(std::string_view text, bool sampa) {
  const Entry* const entry = sampa ? beginning(kSampa, text) : nullptr;
  return entry ? entry : beginning(kIpa, text);
}

/// Whether two sounds in one name are a single sound: a diphthong, a vowel with the liquid or nasal that
/// ends it ("əl", "ɑːɹ"), an affricate ("kx"), or a consonant with a glide ("nj").
bool belong_together(const Entry& one, const Entry& next) {
  const V ends = one.second == V::sil ? one.first : one.second;
  if (is_vowel(ends))
    return is_vowel(next.first) || next.first == V::RR || next.first == V::nn || next.name == "m";
  if (next.name == "j" || next.name == "w") return true;
  constexpr std::string_view kThroat[] = {"x", "χ", "h", "ɦ"};
  if (one.name == next.name) return false;
  const bool stop = ends == V::PP || ends == V::DD || ends == V::kk;
  return stop &&
         (next.first == V::FF || next.first == V::TH || next.first == V::CH ||
          next.first == V::SS || std::count(std::begin(kThroat), std::end(kThroat), next.name) > 0);
}

/// Whether what follows a sound in its name belongs to it: marks, tones, and at most two more sounds.
/// Else the name is a word or a slip.
bool is_one_sound(const Entry& first, std::string_view rest, bool sampa) {
  constexpr int kMostMore = 2;
  const Entry* before = &first;
  for (int more = 0; !rest.empty();) {
    const Entry* const entry = first_sound(rest, sampa);
    if (entry && (++more > kMostMore || !belong_together(*before, *entry))) return false;
    const bool letter = (rest[0] >= 'a' && rest[0] <= 'z') || (rest[0] >= 'A' && rest[0] <= 'Z');
    if (!entry && letter) return false;
    rest.remove_prefix(entry ? entry->name.size() : 1);
    if (entry) before = entry;
  }
  return true;
}

/// The first sound that the name begins with, past marks of stress and ties.
PhoneMeaning sound_meaning(std::string_view name, bool sampa) {
  bool known = true;
  double stress = 0;
  for (std::size_t at = 0; at < name.size(); ++at) {
    const std::string_view rest = name.substr(at);
    if (const Entry* const entry = first_sound(rest, sampa)) {
      PhoneMeaning found = meaning(*entry, 1, stress);
      found.known = known && is_one_sound(*entry, rest.substr(entry->name.size()), sampa);
      return found;
    }
    struct Mark {
      std::string_view text;
      double stress = 0;
    };
    constexpr Mark kMarks[] = {{"ˈ", 1},  {"ˌ", kSecondary}, {"'", 1}, {",", kSecondary},
                               {"\"", 1}, {"%", kSecondary}, {"͡"},     {"̩"}};
    const auto mark = std::find_if(std::begin(kMarks), std::end(kMarks),
                                   [&](const Mark& m) { return rest.starts_with(m.text); });
    known &= mark != std::end(kMarks);
    if (mark != std::end(kMarks))
      at += mark->text.size() - 1, stress = std::max(stress, mark->stress);
  }
  return {{{V::kk}, {V::sil}}, 1, false};
}

std::optional<Viseme> viseme_named(std::string_view name) {
  const std::string spelt = standard_spelling("viseme", name);
  const auto found = std::find(std::begin(kVisemeNames), std::end(kVisemeNames), spelt);
  if (found == std::end(kVisemeNames)) return {};
  return Viseme(found - std::begin(kVisemeNames));
}

bool is_arpabet(std::string_view name) {
  if (name.size() > 1 && name.back() >= '0' && name.back() <= '2') name.remove_suffix(1);
  return whole(kArpabet, name) != nullptr;
}

}  // namespace

PhoneAlphabet alphabet_of(std::span<const std::string_view> names) {
  const auto all = [&](auto&& is_one) {
    return std::all_of(names.begin(), names.end(),
                       [&](std::string_view name) { return is_silence(name) || is_one(name); });
  };
  if (all([](std::string_view name) { return whole(kRhubarb, name) != nullptr; }))
    return PhoneAlphabet::rhubarb;
  if (all([](std::string_view name) { return viseme_named(name).has_value(); }))
    return PhoneAlphabet::visemes;
  const auto arpabets = std::count_if(names.begin(), names.end(), is_arpabet);
  const auto silences = std::count_if(names.begin(), names.end(), is_silence);
  if (2 * arpabets > std::ptrdiff_t(names.size()) - silences) return PhoneAlphabet::arpabet;
  return PhoneAlphabet::ipa;
}

PhoneMeaning phone_meaning(PhoneAlphabet alphabet, std::string_view name) {
  if (is_silence(name)) return {{{V::sil}, {V::sil}}, 1, true};
  if (name == "spn" || name == "SPN")
    return {{{V::kk}, {V::sil}}, 1, true};  // a word that nobody knows
  if (alphabet == PhoneAlphabet::rhubarb)
    if (const Entry* entry = whole(kRhubarb, name)) return meaning(*entry);
  const auto viseme = viseme_named(name);
  const PhoneMeaning as_viseme{{{viseme.value_or(V::sil)}, {V::sil}}, 1, true};
  if (viseme && alphabet == PhoneAlphabet::visemes) return as_viseme;
  const PhoneMeaning found = alphabet == PhoneAlphabet::arpabet
                                 ? arpabet_meaning(name)
                                 : sound_meaning(name, alphabet == PhoneAlphabet::sampa);
  if (found.known) return found;
  if (viseme) return as_viseme;
  // Capitals among visemes or IPA, of a track by hand: "M".
  return is_arpabet(name) ? arpabet_meaning(name) : found;
}

std::optional<PhoneMeaning> azure_viseme(double id) {
  if (!(id >= 0 && id < double(std::size(kAzure))) || id != double(int(id))) return {};
  return meaning(kAzure[std::size_t(id)]);
}

}  // namespace mien
